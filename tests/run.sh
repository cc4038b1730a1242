#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors and runs the tests.
# The exit status says whether all is well.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/phase.sh

usage() {
    cat <<'END'
usage: tests/run.sh [--full] [--no-paraview] [--asan] [--tsan] [--fuzz [SECONDS]] [--tidy]

Installs the packages that are missing (Debian 12) and ParaView, checks the format of the sources, builds abut and its tests in
build/release with warnings as errors, and runs the tests (all but the published cases at full size).

  --full  also the published cases at full size (hours)
  --no-paraview  does not install ParaView (0.7 GB); its test is skipped if it isn't there
  --asan  instead: the tests under the address and undefined-behaviour sanitizers, in build/asan
  --tsan  instead: contact scenes on several threads under the thread sanitizer, in build/tsan; installs clang 14
  --fuzz [SECONDS]  instead: all readers of files get inputs that libFuzzer invents, SECONDS each (20), in build/fuzz;
          installs clang 14; see tests/fuzz/README.md
  --tidy  instead: clang-tidy over the libraries and the program, in build/tidy; installs clang-tidy
  --help  this text
END
}

full=no
paraview=yes
preset=release
fuzz_seconds=20
while (($# > 0)); do
    argument=$1
    shift
    case $argument in
        --full) full=yes ;;
        --no-paraview) paraview=no ;;
        --asan) preset=asan ;;
        --tsan) preset=tsan ;;
        --fuzz)
            preset=fuzz
            if [[ ${1:-} =~ ^[0-9]+$ ]]; then
                fuzz_seconds=$1
                shift
            fi
            ;;
        --tidy) preset=tidy ;;
        -h | --help)
            usage
            exit 0
            ;;
        *)
            echo "run.sh: unknown argument \"$argument\"" >&2
            usage >&2
            exit 2
            ;;
    esac
done

build() { # PRESET CMAKE_OPTIONS...
    phase "Configuring build/$1" cmake --preset "$@"
    phase "Building build/$1" cmake --build --preset "$1" -j"$(nproc)"
}

# Other versions of clang-format than Debian 12's break lines differently.
format() {
    if ! clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
        echo "skipped: no clang-format 14 here"
        return
    fi
    find src geometry io tests '(' -name '*.h' -o -name '*.cpp' ')' -print0 |
        xargs -0 clang-format --dry-run -Werror --style=file
}

if [[ $preset == tidy ]]; then
    phase "Packages" bash .ci/setup.sh clang-tidy libomp-dev # clang's own omp.h
    build tidy
    exit
fi

clang=(clang-14 libclang-rt-14-dev libomp-14-dev)
if [[ $preset == fuzz ]]; then
    phase "Packages" bash .ci/setup.sh "${clang[@]}"
    build fuzz -DABUT_WERROR=ON
    phase "Fuzzing, $fuzz_seconds s a target" tests/fuzz/run.sh "$fuzz_seconds"
    exit
fi
if [[ $preset == tsan ]]; then
    phase "Packages" bash .ci/setup.sh "${clang[@]}"
    build tsan -DABUT_WERROR=ON
    # Archer tells the sanitizer of OpenMP's barriers; libomp itself has no instrumentation.
    KMP_BLOCKTIME=0 OMP_TOOL_LIBRARIES=/usr/lib/llvm-14/lib/libarcher.so TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1" \
        phase "Contact scenes under the thread sanitizer" build/tsan/tests/test_stability --gtest_filter='Threads.*ShortRun*'
    exit
fi

phase "Packages" bash .ci/setup.sh
if [[ $preset == release && $paraview == yes ]]; then
    phase "ParaView" bash .ci/paraview.sh
fi
badly_formatted=no
format_or_note() { format || badly_formatted=yes; }
phase "Format of the sources" format_or_note
build "$preset" -DABUT_WERROR=ON -DABUT_TESTS=ON -DABUT_BENCHMARKS=ON
if [[ $full == yes ]]; then # these share no cores
    phase "Published cases at full size" ctest --preset "$preset" --output-on-failure -L full --no-tests=ignore
fi
# One thread a test, as many tests at a time as there are cores. Tests of threading choose their own numbers; threads
# that wait must not spin then.
printf '\n== Tests\n'
OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive ctest --preset "$preset" --output-on-failure -LE full -j"$(nproc)"
if [[ $badly_formatted == yes ]]; then
    echo "run.sh: some sources are not formatted, see above; clang-format -i FILE corrects them" >&2
    exit 1
fi
