#!/usr/bin/env bash
# Puts Intel Open Image Denoise 2.5.1 into build/oidn/lib, where the program finds it. The libraries
# come from the wheel `pyoidn` on PyPI, which holds the device libraries for CPU, CUDA, HIP and SYCL;
# nothing of it is installed or run.
#
# The folder has to be called lib: the libraries look for each other in $ORIGIN/../lib.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
source "$root/scripts/folder.sh"
source "$root/scripts/pypi.sh"
version=2.5.1
# Each under the name that is asked for at run time; the wheel has copies under other names.
libraries=(
    libOpenImageDenoise.so.2 libOpenImageDenoise_core.so.$version
    libOpenImageDenoise_device_{cpu,cuda,hip,sycl}.so.$version
    libtbb.so.12 libsycl.so.9 libumf.so.1
    libur_loader.so.0 libur_adapter_level_zero.so.0 libur_adapter_level_zero_v2.so.0
)

if [ "$(uname -sm)" != "Linux x86_64" ]; then
    echo "fetch-oidn: the wheel is for Linux on x86-64, this is $(uname -sm)." \
        "Build Open Image Denoise 2 and name its folder in HIMALAYA_OIDN." >&2
    exit 1
fi

pypi_begin fetch-oidn "$root/build/oidn" $version
mkdir "$work/wheel" "$work/lib"
echo "fetch-oidn: downloading pyoidn $version.0 from PyPI (87 MB)"
pypi_pip download --only-binary :all: -d "$work/wheel" <<END
pyoidn==$version.0 --hash=sha256:32ad13368f8de1ef63001942ad05b02a00cd732d1206d97f352d3a3f606d823e
END
python3 -m zipfile -e "$work"/wheel/pyoidn-*.whl "$work/wheel/all"
for library in "${libraries[@]}"; do
    mv "$work/wheel/all/pyoidn/oidn/lib/$library" "$work/lib/"
done
cp "$work"/wheel/all/pyoidn-*.dist-info/licenses/LICENSE "$work/LICENSE.pyoidn"
rm -r "$work/wheel"
pypi_end
echo "fetch-oidn: Open Image Denoise $version is in $target/lib"
