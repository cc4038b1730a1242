#!/usr/bin/env bash
# Runs the fuzz targets of build/asan, one thread each, as many at a time as there are cores. Inputs that are found are
# kept in build/asan/fuzz/corpus/TARGET, so that a later run goes on from them; findings go to build/asan/fuzz/findings.
#
#   tests/fuzz/run.sh [SECONDS [TARGET...]]    15 seconds a target, all targets
#
# The exit status says whether there were findings.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

seconds=${1:-15}
shift || true
targets=("$@")
((${#targets[@]} > 0)) || targets=(scene units image surface outline checkpoint table series)
folder=build/asan/fuzz
findings=$folder/findings
mkdir -p "$findings"

fuzz_one() { # TARGET SECONDS
    local target=$1 corpus=$folder/corpus/$1 log=$folder/$1.log seeds=tests/fuzz/seeds/$1 status=0
    mkdir -p "$corpus"
    local options=(-max_total_time="$2" -timeout=20 -rss_limit_mb=2048 -malloc_limit_mb=512 -print_final_stats=1
        -artifact_prefix="$findings/$target-")
    [[ -f tests/fuzz/$target.dict ]] && options+=(-dict="tests/fuzz/$target.dict")
    [[ $target == checkpoint ]] && options+=(-max_len=65536)
    local folders=("$corpus")
    [[ -d $seeds ]] && folders+=("$seeds")
    # One allocation too large for malloc_limit_mb is a finding; allocators return null above what ASan takes at all.
    ASAN_OPTIONS=allocator_may_return_null=1:detect_leaks=1:handle_abort=1 \
        LSAN_OPTIONS=suppressions=tests/leaks_elsewhere.txt:print_suppressions=0 UBSAN_OPTIONS=print_stacktrace=1 OMP_NUM_THREADS=1 \
        "build/asan/tests/fuzz/fuzz_$target" "${options[@]}" "${folders[@]}" >"$log" 2>&1 || status=$?
    local done_ cover
    done_=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    cover=$(grep -oE 'cov: [0-9]+' "$log" | tail -n 1 || true)
    if ((status == 0)); then
        printf '%-11s %10s executions, %s, no finding\n' "$target" "${done_:-?}" "${cover:-cov: ?}"
    else
        printf '%-11s %10s executions, %s, A FINDING, see %s:\n' "$target" "${done_:-?}" "${cover:-cov: ?}" "$log"
        grep -E '^SUMMARY|ERROR: |runtime error|Test unit written' "$log" | head -n 5
    fi
    return $((status != 0))
}
export -f fuzz_one
export folder findings

printf '%s\n' "${targets[@]}" | xargs -P "${FUZZ_JOBS:-$(nproc)}" -I '{}' bash -c 'fuzz_one "$1" "$2"' _ '{}' "$seconds"
