// The settings that a pipeline may hold as specialization constants, so that the compiler removes what
// other values need: HM_SETTING(constant_id, member of RenderParams, its usual value). Define HM_SETTING
// and include this file, which undefines it. Members are 32 bits wide; constant_id 0 is
// shading/exact.glsl's.
HM_SETTING(1, sampler_kind, kSamplerSobolOwen)
HM_SETTING(2, max_radiance, 0.0f)
HM_SETTING(3, strategy, kStrategyMis)
HM_SETTING(4, energy_compensation, 1u)
HM_SETTING(5, diffuse_kind, kDiffuseLambert)
HM_SETTING(6, background, kBackgroundEnvironment)

#undef HM_SETTING
