#!/usr/bin/env bash
# Runs test programs of build/asan, as many parts of one at a time as there are cores; not a process for every test, as
# `ctest --preset asan` does it, since each process starts slowly and looks for leaks at its end.
#
#   tests/sanitized.sh TEST_PROGRAM...
#
# The exit status says whether all tests passed and nothing was found. What they said is in build/asan/PROGRAM-PART.log.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

GTEST_TOTAL_SHARDS=$(nproc) # before OMP_NUM_THREADS, which it heeds
export GTEST_TOTAL_SHARDS
export ASAN_OPTIONS=strict_string_checks=1:detect_stack_use_after_return=1:fast_unwind_on_malloc=0:allocator_may_return_null=1
export LSAN_OPTIONS=suppressions=$PWD/tests/leaks_elsewhere.txt:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1
left_out=*Full*:SurfaceImplicit.*:SurfaceRepair.*:SurfaceHostile.*Repaired* # tests/fuzz/left_out.cpp
export left_out
export OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive

run_part() { # PROGRAM PART
    local log=build/asan/$1-$2.log status=0 start=$SECONDS
    GTEST_SHARD_INDEX=$2 timeout 900 "build/asan/tests/$1" --gtest_filter="-$left_out" >"$log" 2>&1 || status=$?
    if ((status == 0)); then
        printf '%-14s part %d: %s, %d s\n' "$1" "$2" "$(grep -F '[  PASSED  ]' "$log")" $((SECONDS - start))
    else
        printf '%-14s part %d: exit status %d, see %s:\n' "$1" "$2" "$status" "$log"
        grep -E 'ERROR: |^SUMMARY|runtime error|Failure$|\[  FAILED  \]' "$log" | head -n 20
        tail -n 40 "$log"
    fi
    return $((status != 0))
}
export -f run_part

for program in "$@"; do
    for ((part = 0; part < GTEST_TOTAL_SHARDS; ++part)); do echo "$program $part"; done
done | xargs -P "$GTEST_TOTAL_SHARDS" -L 1 bash -c 'run_part "$1" "$2"' _
