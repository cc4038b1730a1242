#!/usr/bin/env bash
# Repeats the sweeps of the FMPM paper's Figs. 2-5 and prints the loss of energy of each run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

usage() {
    cat <<'END'
usage: examples/two-block-impact/sweep.sh [--short] [--threads N] [PART...]

Prints a table (CSV): part, variant, order (0: flip), cell in mm, CFL factor (or fixed step), loss in % of the energy.

  PART       order: FLIP, FMPM(k), XPIC(k), PIC      step: CFL factors, FMPM at every step and at every_cfl 0.2
             cell: cell sizes, at one step and at    shape: shape functions
             one CFL factor                          update: stress updates
             Not given: all.
  --short    coarser: cells of 2 mm, and no cells below 1 mm (about 3 minutes on one core; else 15 minutes)
  --threads N  threads of each run (default: 1, for the bodies are small)
ABUT names the program, build/release/abut by default.
END
}

source examples/sweep_options.sh
cell=1
cells=(5 2.5 2 1 0.5)
steps=(0.4 0.2 0.1 0.05 0.02 0.01)
parts=()
option() {
    case $1 in
        --short)
            cell=2
            cells=(5 2.5 2 1)
            steps=(0.4 0.2 0.1 0.05)
            ;;
        order | cell | step | shape | update) parts+=("$1") ;;
        *) return 1 ;;
    esac
}
sweep_options "$@"
((${#parts[@]} > 0)) || parts=(order cell step shape update)
orders=(1 2 3 4 5 6 8 12 16)

# run PART VARIANT ORDER CELL TIME_KEY=VALUE OPTIONS...
run() {
    local part=$1 variant=$2 order=$3 h=$4 time=$5
    shift 5
    local transfer="\"scheme\": \"fmpm\", \"order\": $order"
    case $variant in
        xpic*) transfer="\"scheme\": \"xpic\", \"order\": $order" ;;
        pic) transfer='"scheme": "pic"' ;;
    esac
    if ((order == 0)); then transfer='"scheme": "flip"'; fi
    local sets=(--set "/method/transfer={$transfer}")
    # The blocks are 4 cells apart, and apart again after about as much time more.
    local -a place
    read -r -a place < <(LC_ALL=C awk -v h="$h" 'BEGIN { print -50 - 2 * h, -2 * h, 2 * h, 50 + 2 * h, 1.36 + 0.24 * h }')
    case $time in
        step=*) sets+=(--set "/time={\"end\": \"${place[4]} ms\", \"step\": \"${time#step=}\"}") ;;
        cfl=*) sets+=(--set "/time/end=${place[4]} ms" --set "/time/cfl=${time#cfl=}") ;;
    esac
    if ! "$abut" run examples/two-block-impact/scene.json -o "$results/run" --overwrite --quiet --threads "$threads" \
        --set "/grid/cell=$h mm" --set /output/every=0 \
        --set "/bodies/0/box/lower/0=${place[0]} mm" --set "/bodies/0/box/upper/0=${place[1]} mm" \
        --set "/bodies/1/box/lower/0=${place[2]} mm" --set "/bodies/1/box/upper/0=${place[3]} mm" \
        "${sets[@]}" "$@" 2>"$results/errors"; then
        printf '%s,%s,%d,%s,%s,failed\n' "$part" "$variant" "$order" "$h" "${time#*=}"
        sed 's/^/    /' "$results/errors" >&2
        return
    fi
    LC_ALL=C awk -F, -v row="$part,$variant,$order,$h,${time#*=}" '
        NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "total_energy") column = i; next }
        NR == 2 { first = $column }
        { last = $column }
        END { printf "%s,%.4f\n", row, 100 * (1 - last / first) }' "$results/run/history.csv"
}

order_part() {
    run order flip 0 "$cell" cfl=0.2
    for k in "${orders[@]}"; do run order fmpm "$k" "$cell" cfl=0.2; done
    for k in "${orders[@]}"; do
        run order xpic-start "$k" "$cell" cfl=0.2 --set /method/transfer/position=start-velocity # as published
    done
    for k in 1 2 4 8 16; do run order xpic "$k" "$cell" cfl=0.2; done
    run order pic 1 "$cell" cfl=0.2
}

cell_part() {
    local h k
    for h in "${cells[@]}"; do
        for k in 0 1 2 4 8 16; do
            run cell cpdi "$k" "$h" "step=1 us"
            run cell cpdi "$k" "$h" cfl=0.2
        done
    done
}

step_part() {
    local cfl k
    for cfl in "${steps[@]}"; do
        for k in 0 1 2 4 8 16; do
            if LC_ALL=C awk -v c="$cfl" -v k="$k" 'BEGIN { exit !(c > 0.25 && k >= 8) }'; then continue; fi # abut would shorten it
            run step every "$k" 2 "cfl=$cfl"
            case $k-$cfl in 0-* | *-0.4 | *-0.2) continue ;; esac # FMPM at every CFL 0.2 needs smaller steps
            run step periodic "$k" 2 "cfl=$cfl" --set /method/transfer/every_cfl=0.2
        done
    done
}

shape_part() {
    local shape k
    for shape in cpdi ugimp gimp b2spline b2gimp b2cpdi; do
        for k in 0 2 3 4 6 8 12 16; do
            local cfl=0.2
            case $shape-$k in ugimp-16 | gimp-16) cfl=0.175 ;; esac # what abut shortens 0.2 to
            run shape "$shape" "$k" "$cell" "cfl=$cfl" --set "/method/shape=$shape"
        done
    done
}

update_part() {
    local h k update
    for h in "${cells[@]}"; do
        for k in 0 8; do
            for update in usl usf usl+ usavg usavg+; do
                run update "$update" "$k" "$h" "step=1 us" --set "/method/stress_update=$update"
            done
        done
    done
}

echo "part,variant,order,cell_mm,cfl,loss_percent"
for part in "${parts[@]}"; do "${part}_part"; done
