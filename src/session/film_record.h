// What is stored beside a film's sums: the settings, the devices that drew them, and everything
// that a picture made from them later needs. Checkpoints and parts hold one each.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "image/layers.h"
#include "output/tonemap.h"
#include "scene/surface_names.h"
#include "session/fingerprint.h"

namespace hm {

struct FilmRecord {
    NamedValues settings;
    std::vector<std::string> devices;    // that drew the samples (RendererReport::device)
    std::optional<std::uint32_t> frame;  // of a sequence
    std::uint32_t samples_asked = 0;     // per pixel
    double seconds = 0;                  // of rendering
    std::uint64_t rays = 0, non_finite = 0;
    Metadata picture;  // picture_metadata at that time
    bool alpha = false;
    ToneSettings tone;
    bool auto_exposure = false;
    std::vector<std::string> half;  // layers of 16 bits in the picture (film/layers.h)
    ExrOptions exr;
    SurfaceNames names;    // if a cryptomatte is chosen
    glm::dvec3 origin{0};  // Scene::origin, which the position AOV is summed relative to
};

Metadata to_notes(const FilmRecord& record);

// `file` is for messages. Fails with ErrorKind::invalid.
Result<FilmRecord> from_notes(const Metadata& notes, const std::string& file);

// "NVIDIA H200, then CPU".
std::string devices_text(const std::vector<std::string>& devices);

}  // namespace hm
