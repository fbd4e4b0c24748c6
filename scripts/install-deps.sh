#!/bin/sh
# Installs what Himalaya needs from Debian 12's own packages, and gets from PyPI into the build folder
# the PNG decoder (scripts/fetch-wuffs.sh) and the denoiser's library (scripts/fetch-oidn.sh). A
# second run only looks and returns.
#   --build    what building and rendering need
#   --test     that, and what the tests need (default)
#   --clang    that, and clang, its libFuzzer and clang-tidy
#   --fuzz     what building needs, and clang with libFuzzer
#   --gallery  what building needs, and what puts the contact sheet together
set -eu

group=${1:---test}
packages="g++ cmake ninja-build ccache pkg-config git ca-certificates
    libglm-dev libsimdjson-dev libopenexr-dev libspng-dev libjpeg62-turbo-dev zlib1g-dev
    libxxhash-dev libtbb-dev libcli11-dev libfmt-dev libexpected-dev
    libvulkan-dev libvulkan-volk-dev spirv-headers glslang-tools spirv-tools"
case $group in
--build) ;;
--test | --clang)
    packages="$packages clang-format libgtest-dev libboost-dev vulkan-validationlayers
        libspirv-cross-c-shared-dev openimageio-tools"
    # Node from elsewhere serves as well, and Debian's npm would conflict with it.
    command -v node >/dev/null || packages="$packages nodejs"
    command -v npm >/dev/null || packages="$packages npm"
    ;;
--fuzz) ;;
--gallery) packages="$packages imagemagick fonts-dejavu-core" ;;
*)
    echo "usage: $0 [--build|--test|--clang|--fuzz|--gallery]" >&2
    exit 2
    ;;
esac
case $group in
--clang) packages="$packages clang libclang-rt-14-dev clang-tidy" ;;
--fuzz) packages="$packages clang libclang-rt-14-dev" ;;
esac
# So does Python.
python3 -m pip --version >/dev/null 2>&1 || packages="$packages python3-pip"

# Rendering goes on without the denoiser, --denoise does not; the tests want it.
fetch_from_pypi() {
    "$(dirname "$0")/fetch-wuffs.sh"
    [ "$group" != --fuzz ] || return 0
    "$(dirname "$0")/fetch-oidn.sh" && return
    case $group in --test | --clang) exit 1 ;; esac
    echo "install-deps: no denoiser, so --denoise will not work; all else does" >&2
}

is_installed() {
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "install-deps: this is not Debian; install the equivalents of these packages:" >&2
    echo "$packages" | tr -s ' \n' '\n\n' | sed '/^$/d; s/^/  /' >&2
    exit 1
fi

missing=""
for package in $packages; do
    is_installed "$package" || missing="$missing $package"
done
if [ -z "$missing" ]; then
    echo "install-deps: every package is installed"
    fetch_from_pypi
    exit 0
fi
echo "install-deps: installing$missing"

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}
as_root apt-get update -qq
# shellcheck disable=SC2086  # one word per package
as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends $missing
fetch_from_pypi
