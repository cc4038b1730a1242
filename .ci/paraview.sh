#!/usr/bin/env bash
# Installs ParaView and a virtual display for the tests labelled paraview (Debian 12), if they are missing: about 100 s
# and 0.7 GB. ParaView's Python modules are in the package python3-paraview, which excludes libvtk9-dev, so they are
# unpacked into build/paraview-python instead; nothing is removed.
#
#   .ci/paraview.sh            installs
#   .ci/paraview.sh --modules  only prints the folder of the modules, for PYTHONPATH; exit status 1 if there is none
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

unpacked=$PWD/build/paraview-python
modules() { # the folder of the modules, if they are anywhere
    local folder
    for folder in "${ABUT_PARAVIEW_PYTHON:-}" "$unpacked"/usr/lib/python3/dist-packages \
        /usr/lib/python3/dist-packages; do
        if [[ -f $folder/paraview/simple.py ]]; then
            echo "$folder"
            return
        fi
    done
    return 1
}

if [[ ${1:-} == --modules ]]; then
    modules
    exit
fi

bash .ci/setup.sh paraview xvfb xauth
if ! command -v apt-get >/dev/null; then exit; fi
if ! modules >/dev/null; then
    download=$(mktemp -d)
    trap 'rm -rf "$download"' EXIT
    chmod 755 "$download"
    (cd "$download" && apt-get -q -o Acquire::Retries=2 -o APT::Sandbox::User=root download python3-paraview)
    mkdir -p build
    dpkg -x "$download"/python3-paraview_*.deb "$download/tree"
    rm -rf "$unpacked"
    mv "$download/tree" "$unpacked"
fi
echo "paraview: $(pvbatch --version 2>&1 | tail -n 1), Python modules in $(modules)"
