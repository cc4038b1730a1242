#!/usr/bin/env bash
# Compares the thick cylinder with Lamé's solution for several shape functions and cell sizes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

usage() {
    cat <<'END'
usage: examples/thick-cylinder/sweep.sh [--full] [--threads N]

Prints a table (CSV): shape, cell in mm, and the largest and the RMS error of radial stress (in % of the pressure), hoop
stress and displacement (in % of the largest).

  --full       cells down to 0.625 mm (2 minutes on one core); else 2.5 and 1.25 mm (20 seconds)
  --threads N  threads of each run (default: 1, for the section is small)
ABUT names the program, build/release/abut by default. Needs python3.
END
}

abut=${ABUT:-build/release/abut}
threads=1
cells=(2.5 1.25)
while (($# > 0)); do
    case $1 in
        --full) cells=(2.5 1.25 0.625) ;;
        --threads)
            threads=${2:?sweep.sh: --threads needs a number}
            shift
            ;;
        -h | --help)
            usage
            exit 0
            ;;
        *)
            echo "sweep.sh: unknown argument \"$1\"" >&2
            usage >&2
            exit 2
            ;;
    esac
    shift
done

results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT

echo "shape,cell_mm,radial_max,radial_rms,hoop_max,hoop_rms,displacement_max,displacement_rms"
for shape in ugimp gimp cpdi b2spline b2gimp b2cpdi; do
    for h in "${cells[@]}"; do
        "$abut" run examples/thick-cylinder/scene.json -o "$results/run" --overwrite --quiet --threads "$threads" \
            --set "/grid/cell=$h mm" --set "/method/shape=$shape" --set /output/every=0
        python3 examples/thick-cylinder/lame.py "$results/run" | sed -n "2s|^[^,]*|$shape,$h|p"
    done
done
