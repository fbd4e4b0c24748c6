// What the AOV build of the stages also reads and writes: the hooks of shading/path/aovs.h over device
// addresses. Only ray generation adds to planes.
#ifdef HM_AOVS
layout(set = 3, binding = 8, scalar) readonly buffer Aovs {
    AovParams aovs;
    AovAddresses aov_addresses;
};

#ifdef HM_RAY_GENERATION
layout(set = 3, binding = 9, scalar) readonly buffer SourceGroups { uint source_groups[]; };

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer FloatArray { float at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer PointArray {
    vec3 at[];
};
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer AddressArray {
    uvec2 at[];
};
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer TransformArray {
    mat4x3 at[];
};
layout(buffer_reference, scalar, buffer_reference_align = 8) writeonly buffer HitArray {
    SampleHit at[];
};

// Of the film's crop.
uint film_pixel() {
    return (gl_LaunchIDEXT.y + range.first_row) * gl_LaunchSizeEXT.x + gl_LaunchIDEXT.x;
}

bool has_plane(uint plane) {
    return aov_addresses.planes[plane] != uvec2(0u);
}

float plane_value(uint plane, uint floats, uint at) {
    return FloatArray(aov_addresses.planes[plane]).at[film_pixel() * floats + at];
}

void set_plane_value(uint plane, uint floats, uint at, float value) {
    FloatArray(aov_addresses.planes[plane]).at[film_pixel() * floats + at] = value;
}

void keep_ids(uint index, HitIds ids) {
    if (range.hits == uvec2(0u)) return;
    uint pixel = gl_LaunchIDEXT.y * gl_LaunchSizeEXT.x + gl_LaunchIDEXT.x;
    SampleHit hit;
    hit.instance = ids.instance;
    hit.geometry = ids.geometry;
    HitArray(range.hits).at[pixel * range.noted_samples + index - range.noted_begin] = hit;
}

vec3 moved_position(HitFacts facts) {
    Triangle t;
    load_triangle(facts.geometry, facts.ids.primitive, t);
    vec3 a = t.a.position;
    vec3 b = t.b.position;
    vec3 c = t.c.position;
    uvec2 moved = AddressArray(aov_addresses.next_positions).at[facts.geometry];
    if (moved != uvec2(0u)) {
        uvec3 corners =
            TriangleArray(geometry_addresses[facts.geometry].triangles).at[facts.ids.primitive];
        a = PointArray(moved).at[corners.x];
        b = PointArray(moved).at[corners.y];
        c = PointArray(moved).at[corners.z];
    }
    vec3 local = a * facts.weights.x + b * facts.weights.y + c * facts.weights.z;
    mat4x3 m = TransformArray(aov_addresses.next_transforms).at[facts.ids.instance];
    return m[0] * local.x + m[1] * local.y + m[2] * local.z + m[3];
}
#endif
#endif
