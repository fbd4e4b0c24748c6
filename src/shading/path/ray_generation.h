// The ray-generation stage: one sample of one pixel, from the camera to the end of its path.

HM_FN void trace_sample(uint pixel_x, uint pixel_y, uint index, HM_OUT(PathSample) s) {
    PathState path;
    PathPayload p;
    begin_path(pixel_x, pixel_y, index, path, p, s);
    for (;;) {
        if (!extend_path(path, p, s)) continue;
        if (!shade_path(path, p, s)) break;
        connect_path(path, p, s);
        if (!scatter_path(path, p, s)) break;
    }
}
