#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors and runs the tests.
# The exit status says whether all is well.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/phase.sh

usage() {
    cat <<'END'
usage: tests/run.sh [--full] [--no-paraview] [--sanitizers] [--asan] [--tsan] [--fuzz [SECONDS]] [--tidy]

Installs the packages that are missing (Debian 12) and ParaView, checks the format of the sources, builds abut and its tests in
build/release with warnings as errors, and runs the tests (all but the published cases at full size).

  --full  also the published cases at full size (hours)
  --no-paraview  does not install ParaView (0.7 GB); its test is skipped if it isn't there
  --sanitizers  then also what --fuzz and --tsan do, and the contact scenes of the tests of threads under the address and
          undefined-behaviour sanitizers
  --asan  instead: the tests of the solver, of images and shapes and of files under the address and undefined-behaviour
          sanitizers, in build/asan
  --fuzz [SECONDS]  instead: all readers of files get inputs that libFuzzer invents, SECONDS each (15), in build/asan; see
          tests/fuzz/README.md
  --tsan  instead: contact scenes on several threads under the thread sanitizer, in build/tsan
  --tidy  instead: clang-tidy over the libraries and the program, in build/tidy; installs clang-tidy
  --help  this text

--asan, --fuzz and --tsan can be combined. They, and --sanitizers, install clang 14.
END
}

full=no
paraview=yes
release=yes
asan=no fuzz=no tsan=no
tidy=no
fuzz_seconds=15
only() { # the first of --asan, --fuzz and --tsan leaves all else out
    [[ $release == yes ]] && release=no asan=no fuzz=no tsan=no # whatever --sanitizers has said before
    printf -v "$1" yes
}
while (($# > 0)); do
    argument=$1
    shift
    case $argument in
        --full) full=yes ;;
        --no-paraview) paraview=no ;;
        --sanitizers) asan=yes fuzz=yes tsan=yes ;;
        --asan) only asan ;;
        --tsan) only tsan ;;
        --fuzz)
            only fuzz
            if [[ ${1:-} =~ ^[0-9]+$ ]]; then
                fuzz_seconds=$1
                shift
            fi
            ;;
        --tidy) tidy=yes ;;
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

configure() { # PRESET CMAKE_OPTIONS...
    phase "Configuring build/$1" cmake --preset "$@"
}
build() { # PRESET TARGETS...; without targets, those of the preset
    phase "Building build/$1" cmake --build --preset "$1" -j"$(nproc)" ${2:+--target "${@:2}"}
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

if [[ $tidy == yes ]]; then
    phase "Packages" bash .ci/setup.sh clang-tidy libomp-dev # clang's own omp.h
    configure tidy
    build tidy
    exit
fi

packages=()
[[ $asan$fuzz$tsan == *yes* ]] && packages=(clang-14 libclang-rt-14-dev libomp-14-dev)
phase "Packages" bash .ci/setup.sh "${packages[@]}"

if [[ $release == yes ]]; then
    [[ $paraview == yes ]] && phase "ParaView" bash .ci/paraview.sh
    badly_formatted=no
    format_or_note() { format || badly_formatted=yes; }
    phase "Format of the sources" format_or_note
    configure release -DABUT_WERROR=ON -DABUT_TESTS=ON -DABUT_BENCHMARKS=ON
    build release
    if [[ $full == yes ]]; then # these share no cores
        phase "Published cases at full size" ctest --preset release -L full --no-tests=ignore
    fi
    # One thread a test, as many tests at a time as there are cores. Tests of threading choose their own numbers; threads
    # that wait must not spin then.
    OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive phase "Tests" ctest --preset release -LE full -j"$(nproc)"
    if [[ $badly_formatted == yes ]]; then
        echo "run.sh: some sources are not formatted, see above; clang-format -i FILE corrects them" >&2
        exit 1
    fi
fi

# === Sanitizers
if [[ $asan$fuzz == *yes* ]]; then configure asan -DABUT_WERROR=ON; fi
if [[ $asan == yes ]]; then
    suites=(test_threads)
    # These take as long to compile as all libraries together.
    [[ $release == no ]] && suites+=(test_core test_geometry test_io)
    build asan "${suites[@]}"
    phase "Tests under the address and undefined-behaviour sanitizers" tests/sanitized.sh "${suites[@]}"
fi
if [[ $fuzz == yes ]]; then
    build asan fuzz
    phase "Fuzzing, $fuzz_seconds s a target" tests/fuzz/run.sh "$fuzz_seconds"
fi
if [[ $tsan == yes ]]; then
    configure tsan -DABUT_WERROR=ON
    build tsan
    # Archer tells the sanitizer of OpenMP's barriers; libomp itself has no instrumentation.
    KMP_BLOCKTIME=0 OMP_TOOL_LIBRARIES=/usr/lib/llvm-14/lib/libarcher.so TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1" \
        phase "Contact scenes under the thread sanitizer" build/tsan/tests/test_threads --gtest_filter='*ShortRun*'
fi
