#!/usr/bin/env bash
# Repeats the convergence study of the FMPM paper's Fig. 6A: error of the stress over cell size, for FLIP and FMPM(k).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

usage() {
    cat <<'END'
usage: examples/traction-pulse/sweep.sh [--full] [--threads N]

Prints a table (CSV): order (0: flip), cell in mm, RMS error of the stress in Pa (the pulse has 500), place of the top
in mm, its height, the largest stress behind the pulse (shares of 500 Pa), order of convergence from the row before.

  --full       cells down to 0.5 mm (5 minutes on one core); else 4, 2 and 1 mm (half a minute)
  --threads N  threads of each run (default: 1, for the bar is small)
ABUT names the program, build/release/abut by default. Needs python3-vtk9.
END
}

source examples/sweep_options.sh
cells=(4 2 1)
option() {
    case $1 in
        --full) cells=(4 2 1 0.5) ;;
        *) return 1 ;;
    esac
}
sweep_options "$@"

echo "order,cell_mm,rms_pa,top_mm,top,behind,convergence"
for k in 0 1 2 4 8; do
    transfer="{\"scheme\": \"fmpm\", \"order\": $k}"
    if ((k == 0)); then transfer='{"scheme": "flip"}'; fi
    before=
    for h in "${cells[@]}"; do
        "$abut" run examples/traction-pulse/scene.json -o "$results/run" --overwrite --quiet --threads "$threads" \
            --set "/grid/cell=$h mm" --set "/method/transfer=$transfer" --set /output/every=0
        row=$(/usr/bin/python3 examples/traction-pulse/error.py "$results/run")
        LC_ALL=C awk -v k="$k" -v h="$h" -v row="$row" -v before="$before" 'BEGIN {
            printf "%d,%s,%s,", k, h, row
            if (before != "") {
                split(before, a, ","); split(row, b, ",")
                printf "%.2f", log(a[2] / b[1]) / log(a[1] / h)
            }
            print "" }'
        before=$h,$row
    done
done
