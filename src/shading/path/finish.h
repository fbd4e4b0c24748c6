// From samples to a pixel's sums.

// A sample with a NaN or an infinity counts as black; false for such a one.
HM_FN bool add_sample(HM_INOUT(PixelSum) sum, HM_IN(PathSample) s) {
    sum.weight = sum.weight + 1.0f;
    if (!is_finite_color(s.radiance)) return false;
    sum.radiance = sum.radiance + s.radiance;
    sum.alpha = sum.alpha + s.alpha;
    sum.removed = sum.removed + s.removed;
    return true;
}

// Finish: adds the sample to its pixel, with its AOVs; in the order of the indices. Returns how
// many samples were not finite, 0 or 1, which renderers report.
HM_FN uint finish_path(uint index, HM_IN(PathSample) s, HM_INOUT(PixelSum) sum) {
    if (!add_sample(sum, s)) return 1u;
    add_aovs(index, s);
    return 0u;
}
