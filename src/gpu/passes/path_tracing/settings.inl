// The settings that a pipeline holds as specialization constants, so that the compiler removes what
// other values need. HM_SETTING(constant_id, member of RenderParams): a choice, whose every value has
// pipelines of its own. HM_SETTING_OR_ZERO: a number; all values but 0 share pipelines, which read it
// from the frame's values. Define both and include this file, which undefines them. Members are 32 bits
// wide; constant_id 0 is shading/exact.glsl's.
HM_SETTING(1, sampler_kind)
HM_SETTING_OR_ZERO(2, max_radiance)
HM_SETTING(3, strategy)
HM_SETTING(4, energy_compensation)
HM_SETTING(5, diffuse_kind)
HM_SETTING(6, background)

#undef HM_SETTING
#undef HM_SETTING_OR_ZERO
