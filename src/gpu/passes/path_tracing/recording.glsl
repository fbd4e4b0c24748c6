// Records the rays of paths for gpu/bench, in the build with HM_RECORD.
#ifdef HM_RECORD
layout(set = 3, binding = 6, scalar) writeonly buffer Rays { RecordedRay rays[]; };
layout(set = 3, binding = 7, scalar) writeonly buffer RayCounts { RecordedCounts ray_counts[]; };

uint recorded = 0u;
uint recorded_shadow = 0u;

void record_ray(vec3 origin, vec3 direction, float t_max, uint kind) {
    uint pixels = gl_LaunchSizeEXT.x * gl_LaunchSizeEXT.y;
    if ((recorded + 1u) * pixels > uint(rays.length())) return;
    RecordedRay ray;
    ray.origin = origin;
    ray.t_max = t_max;
    ray.direction = direction;
    ray.kind = kind;
    rays[recorded * pixels + gl_LaunchIDEXT.y * gl_LaunchSizeEXT.x + gl_LaunchIDEXT.x] = ray;
    ++recorded;
    if (kind == kRecordedShadow) ++recorded_shadow;
}

void finish_recording() {
    RecordedCounts counts;
    counts.rays = recorded;
    counts.shadow_rays = recorded_shadow;
    ray_counts[gl_LaunchIDEXT.y * gl_LaunchSizeEXT.x + gl_LaunchIDEXT.x] = counts;
}
#else
void record_ray(vec3 origin, vec3 direction, float t_max, uint kind) {}
void finish_recording() {}
#endif
