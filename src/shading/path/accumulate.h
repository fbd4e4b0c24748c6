// From samples to a pixel's sums.

HM_FN bool is_finite_radiance(vec3 radiance) {
    vec3 size = abs(radiance);
    return size.x <= 3.4e38f && size.y <= 3.4e38f && size.z <= 3.4e38f;
}

// A sample that is not a number counts as black. False if it was one: renderers report how many.
HM_FN bool add_sample(HM_INOUT(PixelSum) sum, HM_IN(PathSample) s) {
    sum.weight = sum.weight + 1.0f;
    if (!is_finite_radiance(s.radiance)) return false;
    sum.radiance = sum.radiance + s.radiance;
    sum.alpha = sum.alpha + s.alpha;
    sum.removed = sum.removed + s.removed;
    return true;
}
