#!/usr/bin/env bash
# Installs the Debian 12 packages that abut is built from, if any are missing. With everything present it needs
# neither the network nor root, and changes nothing.
#
#   .ci/setup.sh [--dry-run] [MORE_PACKAGES...]
set -euo pipefail

dry_run=no
if [[ ${1:-} == --dry-run ]]; then
    dry_run=yes
    shift
fi

packages=(
    g++ cmake ninja-build pkg-config ccache
    libeigen3-dev libfmt-dev nlohmann-json3-dev libcli11-dev libhdf5-dev
    libcgal-dev libmuparser-dev
    libvtk9-dev libegl-dev libgl1-mesa-dri # pictures are rendered through EGL, without a display
    libgtest-dev libgmock-dev libbenchmark-dev
    python3-vtk9 python3-numpy # tests of paraview/
    "$@"
)

if ! { command -v apt-get && command -v dpkg-query; } >/dev/null; then
    echo "setup: no apt-get here, so nothing is installed. abut needs the equivalents of: ${packages[*]}"
    exit 0
fi

installed() { [[ $(dpkg-query -W -f ' ${db:Status-Status} ' "$1" 2>/dev/null) == *' installed '* ]]; }

missing=()
for package in "${packages[@]}"; do
    installed "$package" || missing+=("$package")
done

if ((${#missing[@]} == 0)); then
    echo "setup: all ${#packages[@]} packages are present"
    exit 0
fi
echo "setup: missing ${#missing[@]} of ${#packages[@]} packages: ${missing[*]}"
if [[ $dry_run == yes ]]; then
    echo "setup: dry run, nothing installed"
    exit 0
fi

if ((EUID == 0)); then
    as_root=()
elif command -v sudo >/dev/null && { [[ -t 0 ]] || sudo -n true 2>/dev/null; }; then
    as_root=(sudo) # may ask for the password on a terminal
else
    {
        echo "setup: installing packages needs root, and there is no sudo that works here. As root, run:"
        echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}"
    } >&2
    exit 1
fi

# --no-remove: libvtk9-dev and python3-paraview exclude each other; rather fail than remove what the user has.
apt_get() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
        -o Acquire::Retries=2 -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@"
}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
for attempt in 1 2 3; do
    echo "setup: installing them (attempt $attempt of 3; about a minute and 1.7 GB on a bare system)"
    if {
        apt_get update || echo "setup: apt-get update failed; trying with the lists that are here"
        apt_get install --no-install-recommends --no-remove "${missing[@]}"
    } >"$log" 2>&1; then
        echo "setup: done"
        exit 0
    fi
    tail -n 20 "$log" >&2
    ((attempt < 3)) && sleep $((attempt * 10))
done
echo "setup: the packages could not be installed, see the messages of apt-get above" >&2
exit 1
