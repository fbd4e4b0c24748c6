// From samples to a pixel's sums.

// A sample that is not a number counts as black. False if it was one: renderers report how many.
HM_FN bool add_sample(HM_INOUT(PixelSum) sum, HM_IN(PathSample) s) {
    sum.weight = sum.weight + 1.0f;
    if (!is_finite_color(s.radiance)) return false;
    sum.radiance = sum.radiance + s.radiance;
    sum.alpha = sum.alpha + s.alpha;
    sum.removed = sum.removed + s.removed;
    return true;
}
