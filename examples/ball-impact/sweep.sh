#!/usr/bin/env bash
# Compares schemes and stress updates in the impact of two balls: what is kept of the energy.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

usage() {
    cat <<'END'
usage: examples/ball-impact/sweep.sh [--full] [--threads N]

Prints a table (CSV): scheme, stress update, largest and last total energy, last strain energy and work of contact, all
in % of the energy at the start.

  --full       full.json, with cells of half the size (half an hour on one core); else scene.json (1 minute)
  --threads N  threads of each run (default: 1)
ABUT names the program, build/release/abut by default.
END
}

source examples/sweep_options.sh
scene=scene.json
option() {
    case $1 in
        --full) scene=full.json ;;
        *) return 1 ;;
    esac
}
sweep_options "$@"

echo "scheme,stress_update,largest_energy,energy,strain_energy,contact_work"
for scheme in flip fmpm-2 fmpm-4 xpic-4; do
    transfer="\"scheme\": \"${scheme%-*}\""
    case $scheme in *-*) transfer+=", \"order\": ${scheme#*-}" ;; esac
    for update in usl usl+ usavg+; do
        "$abut" run "examples/ball-impact/$scene" -o "$results/run" --overwrite --quiet --threads "$threads" \
            --set "/method/transfer={$transfer}" --set "/method/stress_update=$update" --set /output/every=0
        LC_ALL=C awk -F, -v row="$scheme,$update" '
            NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
            NR == 2 { first = $column["total_energy"] }
            $column["total_energy"] > largest { largest = $column["total_energy"] }
            END {
                printf "%s,%.2f,%.2f,%.2f,%.2f\n", row, 100 * largest / first, 100 * $column["total_energy"] / first,
                    100 * $column["strain_energy"] / first, 100 * $column["contact_work"] / first
            }' "$results/run/history.csv"
    done
done
