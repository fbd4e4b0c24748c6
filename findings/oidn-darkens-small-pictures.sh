#!/usr/bin/env bash
# Open Image Denoise takes what lies beyond a picture's edges for black. Constant grey, in which there
# is nothing to denoise, comes out darker the smaller the picture: of 0.5 a quarter or less is left of
# a single pixel. Pictures of a few hundred pixels a side are not affected.
#
# Seen on 2026-12-01 with Open Image Denoise 2.5.1 (its CPU device, filter RT, hdr), from the package
# pyoidn 2.5.1.0 on PyPI (Python 3.11, x86-64 Linux); means of what is 0.5 everywhere:
#   1 x 1: 0.09, 64 x 1: 0.36, 128 x 2: 0.45, 512 x 512: 0.50
# Exits with 0 while the single pixel comes out below 0.2 and the large picture within 0.01.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" download --quiet --disable-pip-version-check --no-deps --only-binary :all: \
    -d "$work" pyoidn==2.5.1.0
python3 -m zipfile -e "$work"/pyoidn-*.whl "$work/wheel"
"$work/venv/bin/python" - "$work/wheel/pyoidn/oidn/lib" <<'END'
import array
import ctypes
import sys

library = ctypes.CDLL(sys.argv[1] + "/libOpenImageDenoise.so.2")
handle, text, size = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_size_t
signatures = {
    "oidnNewDevice": (handle, [ctypes.c_int]),
    "oidnCommitDevice": (None, [handle]),
    "oidnNewFilter": (handle, [handle, text]),
    "oidnNewBuffer": (handle, [handle, size]),
    "oidnWriteBuffer": (None, [handle, size, size, handle]),
    "oidnReadBuffer": (None, [handle, size, size, handle]),
    "oidnSetFilterImage": (None, [handle, text, handle, ctypes.c_int] + [size] * 5),
    "oidnSetFilterBool": (None, [handle, text, ctypes.c_bool]),
    "oidnCommitFilter": (None, [handle]),
    "oidnExecuteFilter": (None, [handle]),
}
for name, (result, parameters) in signatures.items():
    getattr(library, name).restype, getattr(library, name).argtypes = result, parameters

CPU, FLOAT3 = 1, 3
device = library.oidnNewDevice(CPU)
library.oidnCommitDevice(device)


def denoise_grey(width, height):
    grey = array.array("f", [0.5] * (3 * width * height))
    bytes_ = 4 * len(grey)
    source, target = (library.oidnNewBuffer(device, bytes_) for _ in range(2))
    library.oidnWriteBuffer(source, 0, bytes_, grey.buffer_info()[0])
    rt = library.oidnNewFilter(device, b"RT")
    library.oidnSetFilterImage(rt, b"color", source, FLOAT3, width, height, 0, 0, 0)
    library.oidnSetFilterImage(rt, b"output", target, FLOAT3, width, height, 0, 0, 0)
    library.oidnSetFilterBool(rt, b"hdr", True)
    library.oidnCommitFilter(rt)
    library.oidnExecuteFilter(rt)
    library.oidnReadBuffer(target, 0, bytes_, grey.buffer_info()[0])
    return sum(grey) / len(grey)


means = {}
for width, height in (1, 1), (64, 1), (128, 2), (512, 512):
    means[width] = denoise_grey(width, height)
    print(f"{width} x {height}: {means[width]:.3f}")
assert means[1] < 0.2, "changed: a single pixel keeps its value"
assert abs(means[512] - 0.5) < 0.01, "changed: a large picture loses its value"
print("as recorded")
END
