"""glTF's material and light for Mitsuba 3, written from the specification and the papers it cites.

Nothing here follows the C++ of this repository: lobes are sampled by half vectors of D cos (Walter et al. 2007),
where the renderer draws visible normals, and every term is written as its paper has it.
"""
import drjit as dr
import mitsuba as mi


class GltfBsdf(mi.BSDF):
    """glTF 2.0, Appendix B: mix(dielectric, metal, metallic).

    `separable` chooses the masking of the appendix, the product of two Smith terms; without it the terms are
    correlated by height (Heitz 2014), which the appendix calls more accurate and which renderers use.
    """

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.base = mi.Color3f(props["base"])
        self.metallic = mi.Float(props.get("metallic", 0.0))
        self.alpha = mi.Float(props["roughness"] ** 2)
        self.separable = props.get("separable", False)
        flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide
        self.m_components = [flags]
        self.m_flags = flags

    def traverse(self, callback):
        pass

    def _distribution(self, cos_h):
        a2 = dr.square(self.alpha)
        return a2 / (dr.pi * dr.square(dr.square(cos_h) * (a2 - 1) + 1))

    def _lambda(self, cosine):
        """Heitz 2014, equation 72, with the tangent written by the cosine."""
        tan2 = 1 / dr.square(cosine) - 1
        return 0.5 * (dr.sqrt(1 + dr.square(self.alpha) * tan2) - 1)

    def _masking(self, cos_v, cos_l):
        v, l = self._lambda(cos_v), self._lambda(cos_l)
        return 1 / ((1 + v) * (1 + l)) if self.separable else 1 / (1 + v + l)

    def _value_and_pdf(self, wi, wo, active):
        cos_v, cos_l = mi.Frame3f.cos_theta(wi), mi.Frame3f.cos_theta(wo)
        active = active & (cos_v > 0) & (cos_l > 0)
        h = dr.normalize(wi + wo)
        v_dot_h = dr.dot(wi, h)
        d = self._distribution(h.z)
        specular = d * self._masking(cos_v, cos_l) / (4 * cos_v * cos_l)
        diffuse = self.base * dr.inv_pi
        schlick = (1 - dr.abs(v_dot_h)) ** 5
        fresnel = 0.04 + (1 - 0.04) * schlick
        dielectric = diffuse * (1 - fresnel) + specular * fresnel
        metal = specular * (self.base + (1 - self.base) * schlick)
        value = (dielectric * (1 - self.metallic) + metal * self.metallic) * cos_l
        pdf = 0.5 * cos_l * dr.inv_pi + 0.5 * d * h.z / (4 * v_dot_h)
        return value & active, pdf & active

    def sample(self, ctx, si, sample1, sample2, active=True):
        cos2 = (1 - sample2.x) / (1 + (dr.square(self.alpha) - 1) * sample2.x)
        sin_h = dr.sqrt(dr.maximum(1 - cos2, 0))
        sin_phi, cos_phi = dr.sincos(2 * dr.pi * sample2.y)
        h = mi.Vector3f(sin_h * cos_phi, sin_h * sin_phi, dr.sqrt(cos2))
        mirrored = 2 * dr.dot(si.wi, h) * h - si.wi
        cosine = mi.warp.square_to_cosine_hemisphere(sample2)
        bs = mi.BSDFSample3f()
        bs.wo = dr.select(sample1 < 0.5, mirrored, cosine)
        value, bs.pdf = self._value_and_pdf(si.wi, bs.wo, active)
        bs.eta = 1.0
        bs.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
        bs.sampled_component = mi.UInt32(0)
        return bs, (value / bs.pdf) & (bs.pdf > 0)

    def eval(self, ctx, si, wo, active=True):
        return self._value_and_pdf(si.wi, wo, active)[0]

    def pdf(self, ctx, si, wo, active=True):
        return self._value_and_pdf(si.wi, wo, active)[1]

    def eval_pdf(self, ctx, si, wo, active=True):
        return self._value_and_pdf(si.wi, wo, active)

    def to_string(self):
        return "GltfBsdf[]"


class GltfSpot(mi.Emitter):
    """KHR_lights_punctual: a spot light with its cone's and its range's recommended falloff."""

    def __init__(self, props):
        mi.Emitter.__init__(self, props)
        self.position = mi.Point3f(props["position"])
        self.axis = dr.normalize(mi.Vector3f(props["direction"]))
        self.intensity = mi.Color3f(props["intensity"])
        self.range = props["range"]
        cos_outer = dr.cos(props["outer_cone"])
        self.scale = 1 / max(0.001, dr.cos(props["inner_cone"]) - cos_outer)
        self.offset = -cos_outer * self.scale
        self.m_flags = +mi.EmitterFlags.DeltaPosition

    def traverse(self, callback):
        pass

    def sample_direction(self, it, sample, active=True):
        ds = dr.zeros(mi.DirectionSample3f)
        ds.p = self.position
        ds.d = self.position - it.p
        ds.dist = dr.norm(ds.d)
        ds.d /= ds.dist
        ds.n = -ds.d
        ds.time = it.time
        ds.pdf = 1.0
        ds.delta = mi.Bool(True)
        ds.emitter = mi.EmitterPtr(self)
        cone = dr.clip(dr.dot(self.axis, -ds.d) * self.scale + self.offset, 0, 1)
        window = dr.clip(1 - (ds.dist / self.range) ** 4, 0, 1)
        return ds, (self.intensity * dr.square(cone) * window / dr.square(ds.dist)) & active

    def pdf_direction(self, it, ds, active=True):
        return mi.Float(0)

    def eval_direction(self, it, ds, active=True):
        return mi.Color3f(0)

    def eval(self, si, active=True):
        return mi.Color3f(0)

    def bbox(self):
        return mi.BoundingBox3f()

    def to_string(self):
        return "GltfSpot[]"


def register():
    mi.register_bsdf("gltf", GltfBsdf)
    mi.register_emitter("gltf_spot", GltfSpot)
