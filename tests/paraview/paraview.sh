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
exec xvfb-run -a -s "-screen 0 1280x1024x24" pvbatch "$here/in_paraview.py" "$@"
