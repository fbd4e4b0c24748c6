#!/usr/bin/env python3
"""Renders the scenes of tests/reference in Mitsuba 3 and stores the mean and the variance of the mean per pixel.

    python3 -m venv /path/to/venv && /path/to/venv/bin/pip install mitsuba==3.9.1 numpy
    DRJIT_LIBLLVM_PATH=/path/to/libLLVM.so /path/to/venv/bin/python tests/reference/make_references.py

Dr.Jit needs LLVM 16 or newer. The scenes are described here a second time on purpose: scenes.cpp says the same in
C++ and shares nothing with this file but the numbers. With names as arguments only those scenes are rendered.
"""
import json
import math
import os
import sys
import tempfile

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
import drjit as dr

import gltf_plugins

gltf_plugins.register()
T = mi.ScalarTransform4f
WIDTH, HEIGHT, REPLICATES = 48, 32, 32
DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "data")
SCRATCH = tempfile.mkdtemp()


def mesh(vertices, faces, bsdf, emission=None, uv=None, opacity=None):
    """Flat triangles, counter-clockwise seen from the front. `opacity` is a texture or a number."""
    path = os.path.join(SCRATCH, f"{len(os.listdir(SCRATCH))}.ply")
    with open(path, "w") as f:
        f.write(f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\n")
        names = ["x", "y", "z"] + (["u", "v"] if uv else [])
        f.write("".join(f"property float {n}\n" for n in names))
        f.write(f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
        for i, v in enumerate(vertices):
            f.write(" ".join(repr(float(x)) for x in [*v, *(uv[i] if uv else [])]) + "\n")
        for a, b, c in faces:
            f.write(f"3 {a} {b} {c}\n")
    bsdf = {"type": "twosided", "inner": bsdf}
    if opacity:
        bsdf = {"type": "mask", "opacity": opacity, "inner": bsdf}
    shape = {"type": "ply", "filename": path, "face_normals": True, "bsdf": bsdf}
    if emission:
        shape["emitter"] = {"type": "area", "radiance": {"type": "rgb", "value": emission}}
    return shape


def quad(a, b, c, d, bsdf, emission=None, uv=None, opacity=None):
    return mesh([a, b, c, d], [(0, 1, 2), (0, 2, 3)], bsdf, emission, uv, opacity)


def ball(centre, radius, bsdf):
    """An octahedron whose faces are split in four twice, its corners on the sphere."""
    x, y, z = np.eye(3)
    triangles = [(x, y, z), (y, -x, z), (-x, -y, z), (-y, x, z), (y, x, -z), (-x, y, -z), (-y, -x, -z), (x, -y, -z)]
    for _ in range(2):
        split = []
        for a, b, c in triangles:
            ab, bc, ca = ((p + q) / np.linalg.norm(p + q) for p, q in ((a, b), (b, c), (c, a)))
            split += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = split
    corners = [np.array(centre) + radius * p for t in triangles for p in t]
    return mesh(corners, [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(triangles))], bsdf)


def block(centre, half, degrees, bsdf):
    """A box without its floor, rotated about +y."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def corner(x, y, z):
        x, y, z = x * half[0], y * half[1], z * half[2]
        return (centre[0] + c * x + s * z, centre[1] + y, centre[2] - s * x + c * z)

    faces = [
        [(-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)],
        [(1, -1, -1), (-1, -1, -1), (-1, 1, -1), (1, 1, -1)],
        [(1, -1, 1), (1, -1, -1), (1, 1, -1), (1, 1, 1)],
        [(-1, -1, -1), (-1, -1, 1), (-1, 1, 1), (-1, 1, -1)],
        [(-1, 1, 1), (1, 1, 1), (1, 1, -1), (-1, 1, -1)],
    ]
    return [quad(*(corner(*p) for p in face), bsdf) for face in faces]


def lambert(r, g, b):
    return {"type": "diffuse", "reflectance": {"type": "rgb", "value": [r, g, b]}}


def gltf(base, metallic, roughness):
    return {"type": "gltf", "base": mi.ScalarColor3f(base), "metallic": metallic, "roughness": roughness}


def camera(eye, target, vertical_fov, lens=None):
    sensor = {
        "type": "thinlens" if lens else "perspective",
        "to_world": T().look_at(origin=eye, target=target, up=[0, 1, 0]),
        "fov": vertical_fov,
        "fov_axis": "y",
        "near_clip": 1e-3,
        "far_clip": 1e4,
        "film": {"type": "hdrfilm", "width": WIDTH, "height": HEIGHT, "pixel_format": "rgb",
                 "component_format": "float32", "rfilter": {"type": "box"}},
        "sampler": {"type": "independent"},
    }
    if lens:
        sensor["aperture_radius"], sensor["focus_distance"] = lens
    return sensor


def sky_texel(x, y):
    """Of 32 by 16: bands by height, stripes around, and a bright patch in a quarter of the sky."""
    band = 0.2 + 0.05 * (15 - y)
    stripe = 0.1 * ((3 * x + 5 * y) % 7)
    sun = 6.0 if 20 <= x <= 22 and 3 <= y <= 4 else 0.0
    return [band + stripe + sun, band + 0.5 * stripe + 0.8 * sun, 1.4 * band + 0.5 * sun]


def sky_reference(directions, rotation):
    """The renderer's convention in double: u = 0.5 + atan2(z, x) / 2 pi + rotation / 360, v = acos(y) / pi, bilinear
    between texel centres."""
    d = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    u = (0.5 + np.arctan2(d[:, 2], d[:, 0]) / (2 * np.pi) + rotation / 360) % 1
    v = np.arccos(np.clip(d[:, 1], -1, 1)) / np.pi
    texels = np.array([[sky_texel(x, y) for x in range(32)] for y in range(16)])
    x, y = u * 32 - 0.5, v * 16 - 0.5
    x0, y0 = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = (x - x0)[:, None], (y - y0)[:, None]
    rows = [np.clip(y0, 0, 15), np.clip(y0 + 1, 0, 15)]
    upper, lower = (texels[r, x0 % 32] * (1 - fx) + texels[r, (x0 + 1) % 32] * fx for r in rows)
    return upper * (1 - fy) + lower * fy


def sky(rotation=0.0, scale=1.0):
    """Mitsuba's rows are at v = k / (rows - 1), ours at texel centres: 33 rows represent the same function exactly.
    Its u is atan2(x, -z) / 2 pi."""
    rows = []
    for k in range(33):
        y = min(max(k / 2 - 0.5, 0), 15)
        low, high = math.floor(y), math.ceil(y)
        rows.append([[0.5 * (a + b) for a, b in zip(sky_texel(x, low), sky_texel(x, high))] for x in range(32)])
    to_world = T().rotate([0, 1, 0], rotation) @ T([[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]])
    emitter = {"type": "envmap", "bitmap": mi.Bitmap(np.array(rows, dtype=np.float32)), "scale": scale,
               "to_world": to_world}
    check_sky(emitter, rotation, scale)
    return emitter


def check_sky(description, rotation, scale):
    directions = np.random.default_rng(1).normal(size=(20000, 3))
    si = dr.zeros(mi.SurfaceInteraction3f, len(directions))
    si.wi = -dr.normalize(mi.Vector3f(directions.T.astype(np.float32)))
    seen = np.array(mi.load_dict(description).eval(si)).T
    error = np.abs(seen - scale * sky_reference(directions, rotation)).max()
    assert error < 1e-3, f"the two descriptions of the environment differ by {error}"


def check_bsdf():
    """With the appendix's separable masking and base colour 1 our plugin must be Mitsuba's own rough conductor."""
    rng = np.random.default_rng(2)
    wi, wo = (mi.warp.square_to_uniform_hemisphere(mi.Point2f(rng.random((2, 50000)).astype(np.float32)))
              for _ in range(2))
    si = dr.zeros(mi.SurfaceInteraction3f, 50000)
    si.wi = wi
    for roughness in (0.3, 0.5, 0.8, 1.0):
        ours = mi.load_dict({**gltf([1, 1, 1], 1.0, roughness), "separable": True}).eval(mi.BSDFContext(), si, wo)
        own = mi.load_dict({"type": "roughconductor", "material": "none", "distribution": "ggx",
                            "alpha": roughness**2}).eval(mi.BSDFContext(), si, wo)
        ours, own = np.array(ours), np.array(own)
        error = (np.abs(ours - own) / (own + 1e-3)).max()
        assert error < 1e-3, f"roughness {roughness}: {error} from the rough conductor"


def box():
    white = lambert(0.725, 0.71, 0.68)
    x, y, z = 1.5, 2.0, 2.0
    return {
        "depth": 9,
        "camera": camera([0.2, 1.1, 1.9], [0, 0.8, -1], 60),
        "shapes": [
            quad((-x, 0, z), (x, 0, z), (x, 0, -z), (-x, 0, -z), white),
            quad((-x, y, -z), (x, y, -z), (x, y, z), (-x, y, z), white),
            quad((-x, 0, -z), (x, 0, -z), (x, y, -z), (-x, y, -z), white),
            quad((x, 0, z), (-x, 0, z), (-x, y, z), (x, y, z), white),
            quad((-x, 0, z), (-x, 0, -z), (-x, y, -z), (-x, y, z), lambert(0.63, 0.065, 0.05)),
            quad((x, 0, -z), (x, 0, z), (x, y, z), (x, y, -z), lambert(0.14, 0.45, 0.091)),
            quad((-0.4, 1.98, -0.5), (0.4, 1.98, -0.5), (0.4, 1.98, 0.3), (-0.4, 1.98, 0.3),
                 lambert(0.5, 0.5, 0.5), [12, 9, 6]),
            *block((-0.5, 0.6, -0.9), (0.35, 0.6, 0.35), 20, white),
            *block((0.5, 0.3, -0.1), (0.3, 0.3, 0.3), -18, white),
        ],
    }


def metal():
    balls = [ball((1.6 * i, 0.75, 0), 0.7, gltf([1, 1, 1], 1.0, r)) for i, r in ((-1, 0.3), (0, 0.5), (1, 0.8))]
    ground = quad((-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4), lambert(0.5, 0.45, 0.4))
    return {"depth": -1, "camera": camera([0, 2, 5], [0, 0.6, 0], 38), "shapes": [ground, *balls],
            "environment": sky()}


def materials():
    shapes = [
        ball((1.1 * i, 1.1 * j, 0), 0.48, gltf([0.8, 0.5, 0.2], metallic, roughness))
        for i, metallic in ((-1, 0.0), (0, 0.5), (1, 1.0))
        for j, roughness in ((1, 0.3), (0, 0.6), (-1, 1.0))
    ]
    shapes.append(quad((-3, -2, -0.8), (3, -2, -0.8), (3, 2, -0.8), (-3, 2, -0.8), gltf([0.3, 0.4, 0.6], 0.0, 0.4)))
    shapes.append(quad((-2, 1, 2.9), (-2.6, 1, 2), (-2.6, 2.2, 2), (-2, 2.2, 2.9), lambert(0.2, 0.2, 0.2),
                       [14, 15, 18]))
    return {"depth": 5, "camera": camera([0, 0, 6], [0, 0, 0], 36), "shapes": shapes,
            "environment": sky(75, 0.5)}


def punctual():
    return {
        "depth": 4,
        "camera": camera([0.5, 2.2, 4], [0, 0.4, 0], 42),
        "shapes": [
            quad((-3, 0, 3), (3, 0, 3), (3, 0, -3), (-3, 0, -3), lambert(0.6, 0.6, 0.5)),
            quad((-3, 0, -2), (3, 0, -2), (3, 3, -2), (-3, 3, -2), lambert(0.4, 0.5, 0.7)),
            ball((-0.8, 0.6, 0), 0.55, lambert(0.8, 0.3, 0.2)),
            ball((0.9, 0.5, 0.4), 0.45, gltf([0.2, 0.6, 0.3], 0.0, 0.5)),
        ],
        "lights": [
            {"type": "point", "position": [-1.8, 2.2, 1.2], "intensity": {"type": "rgb", "value": [6, 4, 3]}},
            {"type": "directional", "direction": [-0.6, -1, -0.4],
             "irradiance": {"type": "rgb", "value": [0.5, 0.6, 0.9]}},
            {"type": "gltf_spot", "position": mi.ScalarPoint3f(1, 3, 1.5), "direction": mi.ScalarVector3f(-0.3, -1, -0.5),
             "intensity": mi.ScalarColor3f(14, 16, 9), "range": 5.0, "inner_cone": 0.25, "outer_cone": 0.5},
        ],
    }


def picture():
    """4 by 4 texels, all different; sRGB."""
    return np.array([[[40 + 50 * x, 220 - 45 * y, 30 + 13 * (x * y)] for x in range(4)] for y in range(4)], dtype=np.uint8)


def texture_corners(left, top, right, bottom):
    """v grows downwards from the picture's first row, in glTF and in Mitsuba's own files."""
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def lens():
    def textured(wrap):
        return {"type": "diffuse", "reflectance": {
            "type": "bitmap", "bitmap": mi.Bitmap(picture()), "filter_type": "bilinear", "wrap_mode": wrap}}

    shapes = [quad((-6, 0, 3), (6, 0, 3), (6, 0, -9), (-6, 0, -9), textured("repeat"), uv=texture_corners(-1, -2, 3.5, 2.25))]
    for i, z in enumerate((1.5, 0, -2, -5)):
        x = -1.2 + 0.9 * i
        shapes.append(quad((x, 0.1, z), (x + 0.8, 0.1, z), (x + 0.8, 1.3, z), (x, 1.3, z), textured("clamp"),
                           uv=texture_corners(-0.1, -0.1, 1.2, 1.1)))
    return {"depth": 3, "camera": camera([0.3, 1, 4], [0, 0.5, 0], 40, (0.3, 4.2)), "shapes": shapes,
            "environment": sky(-30)}


def transparency():
    alpha = np.array([[[20 + 60 * x + 13 * y] for x in range(4)] for y in range(4)], dtype=np.uint8)

    def texture(values, filter_type):
        return {"type": "bitmap", "bitmap": mi.Bitmap(values), "raw": True, "filter_type": filter_type}

    def card(x, z, bsdf, opacity):
        return quad((x, 0.1, z), (x + 1.1, 0.1, z + 0.4), (x + 1.1, 1.4, z + 0.4), (x, 1.4, z), bsdf,
                    uv=texture_corners(0, 0, 1, 1), opacity=opacity)

    return {
        "depth": -1,
        "camera": camera([0.3, 1.6, 4.5], [0, 0.5, 0], 36),
        "shapes": [
            quad((-3, 0, 3), (3, 0, 3), (3, 0, -3), (-3, 0, -3), lambert(0.5, 0.6, 0.7)),
            ball((0, 0.6, -1), 0.55, lambert(0.8, 0.2, 0.1)),
            card(-1.9, 0.3, gltf([0.2, 0.7, 0.3], 0.0, 0.4), 0.35),
            card(-0.6, 0.5, gltf([0.9, 0.8, 0.3], 1.0, 0.5), texture(alpha, "bilinear")),
            card(0.7, 0.4, lambert(0.3, 0.3, 0.8), texture(np.where(alpha >= 128, 255, 0).astype(np.uint8), "nearest")),
        ],
        "environment": sky(120, 0.8),
    }


SCENES = {f.__name__: (f, spp) for f, spp in ((box, 512), (metal, 512), (materials, 512), (punctual, 256), (lens, 256),
                                              (transparency, 512))}


def render(name):
    """Stores NAME.exr and NAME_variance.exr: mean, and variance of the mean over the replicates."""
    make, spp = SCENES[name]
    parts = make()
    description = {"type": "scene", "sensor": parts["camera"],
                   "integrator": {"type": "path", "max_depth": parts["depth"]}}
    for i, shape in enumerate(parts["shapes"]):
        description[f"shape{i}"] = shape
    for i, light in enumerate(parts.get("lights", [])):
        description[f"light{i}"] = light
    if "environment" in parts:
        description["environment"] = parts["environment"]
    scene = mi.load_dict(description)
    pictures = [np.array(mi.render(scene, spp=spp, seed=1000 + i), dtype=np.float64) for i in range(REPLICATES)]
    mean = np.mean(pictures, axis=0)
    variance = np.var(pictures, axis=0, ddof=1) / REPLICATES
    for suffix, values in (("", mean), ("_variance", variance)):
        mi.Bitmap(values.astype(np.float32)).write(os.path.join(DATA, f"{name}{suffix}.exr"))
    print(name, "mean", mean.mean(axis=(0, 1)), "standard error", np.sqrt(variance.sum(axis=(0, 1))) / mean[..., 0].size)
    return {"samples": spp, "replicates": REPLICATES, "first_seed": 1000, "width": WIDTH, "height": HEIGHT}


def main():
    check_bsdf()
    path = os.path.join(DATA, "references.json")
    stored = json.load(open(path)) if os.path.exists(path) else {"scenes": {}}
    stored["renderer"] = f"Mitsuba {mi.__version__}, {mi.variant()}, Dr.Jit {dr.__version__}"
    for name in sys.argv[1:] or SCENES:
        stored["scenes"][name] = render(name)
    with open(path, "w") as f:
        json.dump(stored, f, indent=2)
        f.write("\n")


main()
