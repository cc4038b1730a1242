#!/usr/bin/env bash
# Runs in_paraview.py in the real pvbatch on a virtual display. Exit status 77: not installed, see .ci/paraview.sh.
#
#   paraview.sh [FOLDER_FOR_PICTURES]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
for program in pvbatch xvfb-run; do
    if ! command -v "$program" >/dev/null; then
        echo "skipped: no $program here (bash .ci/paraview.sh installs it)"
        exit 77
    fi
done
if ! modules=$(bash "$here/../../.ci/paraview.sh" --modules); then
    echo "skipped: no Python modules of ParaView here (bash .ci/paraview.sh unpacks them)"
    exit 77
fi
export PYTHONPATH=$modules ABUT_MACROS_RAISE=1
# Not the first free display: another xvfb-run may be about to take the same one.
exec xvfb-run -a -n $((100 + $$ % 900)) -s "-screen 0 1280x1024x24 -noreset" pvbatch "$here/in_paraview.py" "$@"
