// Host structs with the tables that the files of shading/path read, so that tests can call
// individual functions of the stages.
#pragma once

#include <cmath>

#include "shading/shading.h"
#include "shading/tables/tables.h"

namespace hm::test {

struct BsdfHost {
    RenderParams params{};
#define HM_CONSTANT_TABLE(number, Type, name, rows) const Type* name = shading_tables().name.data();
#include "shading/tables.inl"

    explicit BsdfHost(bool energy_compensation) {
        params.energy_compensation = energy_compensation ? 1 : 0;
    }

#include "shading/material/bsdf.h"
};

// BsdfHost with the lobes of extensions; what reads materials' tables is left out.
struct ExtendedHost : BsdfHost {
    using BsdfHost::BsdfHost;

#include "shading/material/energy.h"
    //
#include "shading/material/coat.h"
    //
#include "shading/material/extended_specular.h"
    //
#include "shading/material/extended_bsdf.h"
};

struct SamplerHost {
    RenderParams params{};
#define HM_CONSTANT_TABLE(number, Type, name, rows) const Type* name = shading_tables().name.data();
#include "shading/tables.inl"

    SamplerHost(uint kind, uint seed) {
        params.sampler_kind = kind;
        params.seed = seed;
    }

#include "shading/path/sampler.h"

    uvec4 numbers(uint x, uint y, uint index, uint dimension) const {
        auto* self = const_cast<SamplerHost*>(this);
        SamplerState s;
        self->begin_sample(x, y, index, s);
        return self->sample_4d(s, dimension);
    }
};

// Unit vector from the cosine of the angle to z and the azimuth.
inline vec3 direction(float cos_theta, float phi) {
    float s = std::sqrt(std::max(0.0f, 1 - cos_theta * cos_theta));
    return {s * std::cos(phi), s * std::sin(phi), cos_theta};
}

}  // namespace hm::test
