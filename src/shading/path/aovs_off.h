// Ray generation without AOVs: the functions of aovs.h, empty.

HM_FN void begin_aovs(HM_INOUT(PathSample)) {}
HM_FN void note_emitted(HM_INOUT(PathSample), HM_IN(PathPayload), vec3) {}
HM_FN void note_lit(HM_INOUT(PathSample), HM_IN(PathPayload), vec3) {}
HM_FN void note_first_scatter(HM_INOUT(PathSample), HM_IN(PathPayload)) {}
HM_FN void add_aovs(uint, HM_IN(PathSample)) {}
