#!/usr/bin/env bash
# From a fresh clone to pictures: installs what is missing, builds abut, compresses a bed of ellipses and renders it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/phase.sh

usage() {
    cat <<'END'
usage: examples/demo.sh [--full] [--threads N]

Installs the packages that are missing (Debian 12), builds abut in build/release, runs examples/ellipses at half
resolution and renders it. Results are written to results/ellipses, those of an earlier demo are replaced.

  --full       the published resolution; results are written to results/ellipses-full
  --threads N  threads of the run (default: all)
  --help       this text
END
}

results=results/ellipses
options=(--set "/grid/cell=28.6 um" --set /time/cfl=0.3)
threads=()
while (($# > 0)); do
    case $1 in
        --full)
            results=results/ellipses-full
            options=()
            ;;
        --threads)
            if ! [[ ${2:-} =~ ^[1-9][0-9]*$ ]]; then
                echo "demo.sh: --threads needs a number of threads, 1 or more" >&2
                exit 2
            fi
            threads=(--threads "$2")
            shift
            ;;
        -h | --help)
            usage
            exit 0
            ;;
        *)
            echo "demo.sh: unknown argument \"$1\"" >&2
            usage >&2
            exit 2
            ;;
    esac
    shift
done

# The last value of a column of a CSV file, found by the column's name.
last() {
    LC_ALL=C awk -F, -v name="$2" '
        NR == 1 { sub(/\r$/, ""); for (i = 1; i <= NF; ++i) if ($i == name) column = i }
        NR > 1 && column { value = $column }
        END { if (value == "") exit 1; print value }' "$1"
}

abut=build/release/abut
phase "Packages" bash .ci/setup.sh
phase "Configuring" cmake --preset release -DABUT_TESTS=OFF
phase "Building" cmake --build --preset release -j"$(nproc)" --target abut
phase "Running examples/ellipses" \
    "$abut" run examples/ellipses/scene.json -o "$results" --overwrite "${threads[@]}" "${options[@]}"
rm -f "$results"/pictures/frame_*.png # of an earlier demo, which may have had more of them
phase "Rendering" "$abut" render "$results" -o "$results/pictures"

shopt -s nullglob
pictures=("$results"/pictures/*.png)
((${#pictures[@]} > 0)) || { echo "demo.sh: no pictures in $results/pictures" >&2 && exit 1; }
stress=$(last "$results/history.csv" mean_stress_yy)
time=$(last "$results/history.csv" time)

printf '\n== Done in %d s. Made in %s:\n' "$SECONDS" "$PWD/$results"
echo "  to open in ParaView:"
for file in "$results"/*.pvd; do echo "    $PWD/$file"; done
echo "  to look at: ${#pictures[@]} pictures, the last of them"
echo "    $PWD/${pictures[-1]}"
echo "  stress and energies over time:"
echo "    $PWD/$results/history.csv"
LC_ALL=C awk -v s="$stress" -v t="$time" \
    'BEGIN { printf "  mean stress in y at the end, %.4g us: %.4g GPa\n", t * 1e6, s / 1e9 }'
