// Closest hit without AOVs: the functions of aov_facts.h, empty.

HM_FN void note_surface(HM_INOUT(PathPayload), HM_IN(HitIds), HM_IN(Surface)) {}
HM_FN void note_material(HM_INOUT(PathPayload), HM_IN(Bsdf), float) {}
HM_FN void note_light_sample(HM_INOUT(PathPayload), HM_IN(Bsdf), vec3, vec3, uint) {}
HM_FN void note_scatter(HM_INOUT(PathPayload), HM_IN(Bsdf), vec3, vec3) {}
#ifdef HM_EXTENDED
HM_FN void note_extended(HM_INOUT(PathPayload), vec3, float, float) {}
HM_FN void note_extended_light(HM_INOUT(PathPayload), vec3, vec3, uint) {}
HM_FN void note_extended_scatter(HM_INOUT(PathPayload), HM_IN(ExtendedSample)) {}
#endif
