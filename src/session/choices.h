// The names of what can be chosen, once for flags, metadata, reports and the library.
#pragma once

#include "base/choice.h"
#include "denoise/denoise.h"
#include "image/layers.h"
#include "session/settings.h"
#include "shading/color.h"
#include "shading/structs.h"
#include "shading/tables/tables.h"

namespace hm {

inline constexpr Choice<std::uint32_t> kSamplers[] = {{"independent", kSamplerIndependent},
                                                      {"sobol-blue-noise", kSamplerSobolBlueNoise},
                                                      {"sobol-owen", kSamplerSobolOwen}};

inline constexpr Choice<std::uint32_t> kStrategies[] = {
    {"mis", kStrategyMis}, {"light", kStrategyLight}, {"bsdf", kStrategyBsdf}};

inline constexpr Choice<std::uint32_t> kDiffuseModels[] = {{"lambert", kDiffuseLambert},
                                                           {"burley", kDiffuseBurley}};

inline constexpr Choice<PixelFilter> kPixelFilters[] = {
    {"box", PixelFilter::box},
    {"gaussian", PixelFilter::gaussian},
    {"blackman-harris", PixelFilter::blackman_harris}};

inline constexpr Choice<std::uint32_t> kToneCurves[] = {
    {"neutral", kToneNeutral}, {"aces", kToneAces}, {"agx", kToneAgx}, {"linear", kToneLinear}};

inline constexpr Choice<ExrCompression> kExrCompressions[] = {
    {"none", ExrCompression::none}, {"rle", ExrCompression::rle},
    {"zips", ExrCompression::zips}, {"zip", ExrCompression::zip},
    {"piz", ExrCompression::piz},   {"pxr24", ExrCompression::pxr24},
    {"b44", ExrCompression::b44},   {"b44a", ExrCompression::b44a},
    {"dwaa", ExrCompression::dwaa}, {"dwab", ExrCompression::dwab}};

inline constexpr Choice<DenoiseDevice> kDenoiseDevices[] = {{"auto", DenoiseDevice::fastest},
                                                            {"cpu", DenoiseDevice::cpu},
                                                            {"cuda", DenoiseDevice::cuda},
                                                            {"hip", DenoiseDevice::hip},
                                                            {"sycl", DenoiseDevice::sycl}};

inline constexpr Choice<LightUnits> kLightUnits[] = {{"gltf", LightUnits::gltf},
                                                     {"blender", LightUnits::blender}};

inline constexpr Choice<bool> kSwitches[] = {{"on", true}, {"off", false}};

}  // namespace hm
