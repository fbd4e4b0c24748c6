// Checks the embedded shaders: code that decides where a ray goes must not be contracted. Pictures
// rendered by lavapipe would not show it, because lavapipe never contracts.
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>
#include <span>
#include <spirv/unified1/spirv.hpp11>
#include <string>

#include "shaders/anyhit_rahit.h"
#include "shaders/closesthit_extended.h"
#include "shaders/closesthit_rchit.h"
#include "shaders/miss_rmiss.h"
#include "shaders/reference_view_rgen.h"

namespace hm {

namespace {

// Floating-point sums, products and what consists of them.
const std::set<spv::Op> kContractible = {spv::Op::OpFNegate,
                                         spv::Op::OpFAdd,
                                         spv::Op::OpFSub,
                                         spv::Op::OpFMul,
                                         spv::Op::OpVectorTimesScalar,
                                         spv::Op::OpMatrixTimesScalar,
                                         spv::Op::OpVectorTimesMatrix,
                                         spv::Op::OpMatrixTimesVector,
                                         spv::Op::OpMatrixTimesMatrix,
                                         spv::Op::OpOuterProduct,
                                         spv::Op::OpDot};

// The names of functions with arithmetic that a device may contract.
std::set<std::string> contracting(std::span<const std::uint32_t> spirv) {
    std::map<std::uint32_t, std::string> names;
    std::set<std::uint32_t> exact;
    std::set<std::string> found;
    std::string function;
    for (std::size_t at = 5; at < spirv.size(); at += spirv[at] >> spv::WordCountShift) {
        const spv::Op code = spv::Op(spirv[at] & spv::OpCodeMask);
        if (code == spv::Op::OpName) {
            const std::string name(reinterpret_cast<const char*>(&spirv[at + 2]));
            names[spirv[at + 1]] = name.substr(0, name.find('('));  // without its argument types
        }
        if (code == spv::Op::OpDecorate &&
            spirv[at + 2] == std::uint32_t(spv::Decoration::NoContraction))
            exact.insert(spirv[at + 1]);
        if (code == spv::Op::OpFunction) function = names[spirv[at + 2]];
        if (kContractible.contains(code) && !exact.contains(spirv[at + 2])) found.insert(function);
    }
    return found;
}

using Names = std::set<std::string>;

const Names kCore = {"albedo_diffuse",
                     "albedo_layer",
                     "albedo_specular",
                     "compensate_diffuse",
                     "compensate_specular",
                     "environment_radiance",
                     "eval_diffuse",
                     "eval_ggx_d",
                     "eval_ggx_v",
                     "eval_lobes",
                     "eval_specular",
                     "fetch_texel",
                     "ggx_reflection_pdf_scale",
                     "lookup_albedo",
                     "luminance",
                     "make_bsdf",
                     "make_specular",
                     "mis_weight",
                     "pdf_diffuse",
                     "pdf_specular",
                     "shade_light_sample",
                     "srgb_to_linear"};
const Names kExtended = {"anisotropic_reflection_pdf_scale",
                         "colored_shares",
                         "compensation",
                         "eval_anisotropic_d",
                         "eval_coat",
                         "eval_extended_diffuse",
                         "eval_extended_far",
                         "eval_extended_ggx",
                         "eval_extended_reflection",
                         "eval_refraction",
                         "eval_sheen",
                         "eval_smith_v",
                         "film_f0",
                         "fresnel_between",
                         "glass_shares",
                         "lookup_anisotropic_albedo",
                         "lookup_anisotropic_row",
                         "lookup_glass_albedo",
                         "lookup_glass_row",
                         "lookup_sheen_albedo",
                         "make_coat",
                         "make_extended_base",
                         "make_extended_bsdf",
                         "reflected_fresnel",
                         "set_extended_probabilities",
                         "shade_extended_light",
                         "stretched_length",
                         "thin_film_fresnel",
                         "transmittance"};

Names both(Names a, const Names& b) {
    a.insert(b.begin(), b.end());
    return a;
}

TEST(Contraction, OnlyWhereItWeighsPaths) {
    EXPECT_EQ(contracting(shaders::closesthit_rchit()), kCore);
    EXPECT_EQ(contracting(shaders::closesthit_extended()), both(kCore, kExtended));
    EXPECT_EQ(contracting(shaders::miss_rmiss()), Names{"environment_radiance"});
    EXPECT_EQ(contracting(shaders::reference_view_rgen()),
              (Names{"add_contribution", "connect_path", "luminance", "mis_weight", "scatter_path",
                     "shade_path"}));
    EXPECT_EQ(contracting(shaders::anyhit_rahit()), (Names{"fetch_texel", "srgb_to_linear"}));
}

}  // namespace

}  // namespace hm
