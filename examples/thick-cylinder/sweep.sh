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
ABUT names the program, build/release/abut by default. Needs python3-vtk9.
END
}

source examples/sweep_options.sh
cells=(2.5 1.25)
option() {
    case $1 in
        --full) cells=(2.5 1.25 0.625) ;;
        *) return 1 ;;
    esac
}
sweep_options "$@"

echo "shape,cell_mm,radial_max,radial_rms,hoop_max,hoop_rms,displacement_max,displacement_rms"
for shape in ugimp gimp cpdi b2spline b2gimp b2cpdi; do
    for h in "${cells[@]}"; do
        "$abut" run examples/thick-cylinder/scene.json -o "$results/run" --overwrite --quiet --threads "$threads" \
            --set "/grid/cell=$h mm" --set "/method/shape=$shape" --set /output/every=0
        /usr/bin/python3 examples/thick-cylinder/lame.py "$results/run" | sed -n "2s|^[^,]*|$shape,$h|p"
    done
done
