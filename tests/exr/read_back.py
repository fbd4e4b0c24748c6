"""Renders with the program and reads the files with other readers: the Python packages of OpenEXR and
OpenImageIO, and an older OpenImageIO's oiiotool.

    PYTHONPATH=build/openexr-python python3 tests/exr/read_back.py HIMALAYA FOLDER
"""
import json
import pathlib
import re
import subprocess
import sys

import numpy as np
import OpenEXR
import OpenImageIO

PASSES = ["emission", "diffuse_direct", "specular_direct", "diffuse_indirect", "specular_indirect"]
WIDTH, HEIGHT, SAMPLES = 48, 32, 8
LAYERS = {
    "albedo": "RGB", "metallic": "Y", "roughness": "Y", "normal": "XYZ", "geometric_normal": "XYZ",
    "depth": "Z", "position": "XYZ", "uv": "UVA", "forward": "uv", "material_id": "Y",
    "instance_id": "Y", "samples": "Y", "variance": "RGB", **{name: "RGB" for name in PASSES},
}


def render(program, path, *flags):
    command = [program, "render", "demo:spheres", "-o", path, "--quiet", "--spp", SAMPLES,
               "--size", f"{WIDTH}x{HEIGHT}", "--device", "cpu", *flags]
    subprocess.run([str(c) for c in command], check=True)
    return path


def read(path):
    file = OpenEXR.File(str(path), separate_channels=True)
    return file.header(), {name: c.pixels for name, c in file.channels().items()}


def color(channels, layer):
    prefix = layer + "." if layer else ""
    return np.stack([channels[prefix + c].astype(np.float64) for c in "RGB"], axis=-1)


def check_names(path, channels):
    expected = {f"{layer}.{c}" for layer, letters in LAYERS.items() for c in letters}
    expected |= set("RGBA")
    others = {name for name in channels if not re.match(r"Crypto|light_group_", name)}
    assert others == expected, others ^ expected
    info = subprocess.run(["oiiotool", "--info", "-v", str(path)], check=True, capture_output=True,
                          text=True).stdout
    names = re.search(r"channel list: (.*)", info).group(1).split(", ")
    assert set(names) == set(channels), names


def check_sums(channels):
    beauty = color(channels, "")
    groups = sorted({name.rsplit(".", 1)[0] for name in channels if name.startswith("light_group_")})
    assert "light_group_environment" in groups and len(groups) > 1, groups
    # As tests/render/aovs_test.cpp derives: samples * (2 * 8 bounces + 7) roundings.
    tolerance = 2.0**-24 * SAMPLES * 23 * beauty + 1e-12
    for parts in PASSES, groups:
        total = sum(color(channels, part) for part in parts)
        assert (abs(total - beauty) <= tolerance).all(), abs(total - beauty).max()


def check_cryptomatte(header, channels, name):
    keys = {header[k]: k[:-len("name")] for k in header if re.fullmatch(r"cryptomatte/\w{7}/name", k)}
    key = keys[name]
    assert header[key + "hash"] == "MurmurHash3_32"
    assert header[key + "conversion"] == "uint32_to_float32"
    manifest = {int(id, 16): name for name, id in json.loads(header[key + "manifest"]).items()}
    coverage = np.zeros((HEIGHT, WIDTH))
    seen = set()
    layers = sorted({c.split(".")[0] for c in channels if re.match(name + r"\d\d\.", c)})
    assert len(layers) >= 3, layers
    previous = np.ones((HEIGHT, WIDTH), np.float32)
    for layer in layers:
        for id, share in ("R", "G"), ("B", "A"):
            shares = channels[f"{layer}.{share}"]
            assert (shares <= previous).all(), "ranks fall"
            previous = shares
            coverage += shares
            seen |= set(channels[f"{layer}.{id}"].view(np.uint32)[shares > 0].tolist())
    assert len(seen) > 3 or name == "CryptoAsset", seen
    assert all(id in manifest for id in seen), seen - set(manifest)
    assert np.allclose(coverage, channels["A"], atol=1e-6), abs(coverage - channels["A"]).max()


def check_other_reader(path, channels):
    """oiiotool's mean of each channel against numpy's; ids in mattes are not numbers that can be averaged."""
    text = subprocess.run(["oiiotool", "--info", "-v", "--stats", str(path)], check=True,
                          capture_output=True, text=True).stdout
    names = re.search(r"channel list: (.*)", text).group(1).split(", ")
    means = re.search(r"Stats Avg: ([-\d.e+ ]+)", text).group(1).split()
    assert len(names) == len(means) == len(channels), text
    for name, mean in zip(names, map(float, means)):
        if not name.startswith("Crypto"):
            expected = channels[name].mean(dtype=np.float64)
            assert abs(mean - expected) < 1e-4 * max(1, abs(expected)), (name, mean, expected)


def check_metadata(header):
    for key in ["software", "settings", "sceneHash", "camera", "samplesPerPixel", "seed", "device",
                "renderSeconds", "estimatedError", "varianceFrom", "clamp", "clampRemovedShare"]:
        assert header[key], key
    assert header["varianceFrom"] == "4 replicates"
    assert float(header["clampRemovedShare"]) > 0


def check_storage(program, folder, whole):
    """Half floats, tiles, compression and a crop: the same values in the same pixels."""
    path = render(program, folder / "crop.exr", "--crop", "10,5,30,25", "--aov", "albedo,depth",
                  "--exr-half", "albedo", "--exr-tiles", "16", "--exr-compression", "piz",
                  "--background", "transparent")
    header, channels = read(path)
    low, high = header["dataWindow"]
    assert (list(low), list(high)) == ([10, 5], [29, 24]), (low, high)
    assert list(header["displayWindow"][1]) == [WIDTH - 1, HEIGHT - 1]
    assert channels["albedo.R"].dtype == np.float16 and channels["depth.Z"].dtype == np.float32
    assert channels["R"].dtype == np.float32
    path = render(program, folder / "plain.exr", "--aov", "albedo,depth", "--background",
                  "transparent")
    _, plain = read(path)
    inside = slice(5, 25), slice(10, 30)
    assert (plain["depth.Z"][inside] == channels["depth.Z"]).all()
    assert (plain["R"][inside] == channels["R"]).all()
    assert (plain["albedo.R"][inside].astype(np.float16) == channels["albedo.R"]).all()
    info = subprocess.run(["oiiotool", "--info", "-v", str(folder / "crop.exr")], check=True,
                          capture_output=True, text=True).stdout
    assert "tile size: 16 x 16" in info and 'compression: "piz"' in info, info


def check_lossy(program, folder):
    """Lossy compression affects only the beauty; two readers agree on the bits of all other layers."""
    flags = "--aov", "all,variance", "--background", "transparent"
    _, exact = read(render(program, folder / "exact.exr", *flags))
    for compression in "pxr24", "b44", "b44a", "dwaa", "dwab":
        path = render(program, folder / f"{compression}.exr", *flags, "--exr-half", "beauty",
                      "--exr-compression", compression)
        file = OpenEXR.File(str(path), separate_channels=True)
        assert [part.header["name"] for part in file.parts] == ["beauty", "data"]
        lossy = {name: c.pixels for part in file.parts for name, c in part.channels.items()}
        assert set(lossy) == set(exact)
        image = OpenImageIO.ImageInput.open(str(path))
        assert image.seek_subimage(1, 0)
        names = image.spec().channelnames
        other = image.read_image(1, 0, 0, len(names), OpenImageIO.FLOAT)
        for name in exact:
            if name in "RGBA":
                difference = abs(exact[name].astype(np.float64) - lossy[name]).max()
                assert difference < 0.1 * exact[name].max(), (compression, name, difference)
            else:
                bits = exact[name].view(np.uint32)
                assert (lossy[name].view(np.uint32) == bits).all(), (compression, name)
                again = np.ascontiguousarray(other[:, :, names.index(name)])
                assert (again.view(np.uint32) == bits).all(), (compression, name)


def check_refusals(program, folder):
    for flags, expected in [(["--aov", "colour"], "not one of albedo, metallic"),
                        (["--exr-half", "depth"], "not one of the layers"),
                        (["--exr-compression", "lzw"], "not one of none, rle")]:
        run = subprocess.run([program, "render", "demo:spheres", "-o", str(folder / "x.exr"), *flags],
                             capture_output=True, text=True)
        assert run.returncode == 2 and expected in run.stderr, (flags, run.returncode, run.stderr)


def main(program, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    path = render(program, folder / "all.exr", "--aov", "all,variance", "--background", "transparent",
                  "--clamp", "0.5")
    header, channels = read(path)
    check_names(path, channels)
    check_sums(channels)
    for name in "CryptoObject", "CryptoMaterial", "CryptoAsset":
        check_cryptomatte(header, channels, name)
    check_other_reader(path, channels)
    check_metadata(header)
    check_storage(program, folder, channels)
    check_lossy(program, folder)
    check_refusals(program, folder)


if __name__ == "__main__":
    main(*sys.argv[1:])
