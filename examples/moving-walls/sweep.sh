#!/usr/bin/env bash
# Repeats the study of the FMPM paper's Fig. 7: error of the velocity over the depth of the walls.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

usage() {
    cat <<'END'
usage: examples/moving-walls/sweep.sh [--full] [--far] [--threads N]

Prints a table (CSV): method, conditions, depth of the walls in cells, velocity error in % (paper §3.4).

  --full       the published bar of 20 x 4 m, all depths (10 minutes on one core); else 20 x 1 m, four depths (1 minute)
  --far        instead: full.json, until the bar breaks up; prints method, strain in %, RMS velocity error in %
  --threads N  threads of each run (default: 1, for the bar is small)
ABUT names the program, build/release/abut by default. Needs python3-vtk9.
END
}

source examples/sweep_options.sh
depths=(0.5 1 1.5 2.5)
half="0.5 m"
far=no
option() {
    case $1 in
        --full)
            depths=(0 0.5 1 1.5 2 2.5 3 4)
            half="2 m"
            ;;
        --far) far=yes ;;
        *) return 1 ;;
    esac
}
sweep_options "$@"
errors="/usr/bin/python3 examples/moving-walls/error.py"

# abut_run SCENE DEPTH OPTIONS...
abut_run() {
    local scene=$1 depth=$2
    shift 2
    "$abut" run "examples/moving-walls/$scene" -o "$results/run" --overwrite --quiet --threads "$threads" \
        --set "/boundaries/0/wall/depth=$depth" --set "/boundaries/1/wall/depth=$depth" "$@"
}

if [[ $far == yes ]]; then
    echo "method,strain_percent,error_percent"
    for shape in cpdi b2cpdi; do
        depth=1.5 end=3200s
        if [[ $shape == cpdi ]]; then depth=1 end=1600s; fi
        abut_run full.json "$depth" --set "/method/shape=$shape" --until "$end" 2>"$results/errors" || cat "$results/errors" >&2
        $errors --series "$results/run" | LC_ALL=C awk -F, -v name="$shape" '{ printf "%s,%.1f,%s\n", name, 100 * $2, $3 }'
    done
    exit
fi

# row METHOD CONDITIONS DEPTH TRANSFER OPTIONS...
row() {
    local method=$1 conditions=$2 depth=$3 transfer=$4
    shift 4
    local error=failed
    if abut_run scene.json "$depth" --set "/bodies/0/box/lower/1=-$half" --set "/bodies/0/box/upper/1=$half" \
        --set "/method/transfer={$transfer}" --set "/method/velocity_conditions=$conditions" "$@" 2>"$results/errors"; then
        error=$($errors "$results/run")
    else
        sed 's/^/    /' "$results/errors" >&2
    fi
    echo "$method,$conditions,$depth,$error"
}

echo "method,conditions,depth,error_percent"
for depth in "${depths[@]}"; do
    row flip combined "$depth" '"scheme": "flip"'
    row fmpm-1 combined "$depth" '"scheme": "fmpm", "order": 1'
    for k in 2 4 8; do
        for conditions in combined velocity lumped; do
            row "fmpm-$k" "$conditions" "$depth" "\"scheme\": \"fmpm\", \"order\": $k"
        done
    done
    row fmpm-2-b2cpdi combined "$depth" '"scheme": "fmpm", "order": 2' --set /method/shape=b2cpdi
    row xpic-1 combined "$depth" '"scheme": "xpic", "order": 1, "position": "start-velocity"'
    row pic combined "$depth" '"scheme": "pic"'
    row flip-estimated combined "$depth" '"scheme": "flip"' \
        --set /boundaries/0/wall/gradient=estimated --set /boundaries/1/wall/gradient=estimated
    row fmpm-2-estimated combined "$depth" '"scheme": "fmpm", "order": 2' \
        --set /boundaries/0/wall/gradient=estimated --set /boundaries/1/wall/gradient=estimated
done
