// What a picture file says about how it was made.
#pragma once

#include <string>

#include "image/write.h"
#include "session/summary.h"

namespace hm {

// Text that only the front end knows: what the user asked for and the view, in its own terms.
struct MetadataTexts {
    std::string settings, view;
};

// "unbiased up to 8 events", or what the clamp removed.
std::string bias_text(const PathSettings& path, const RenderSummary& summary);

Metadata picture_metadata(const RenderSettings& settings, const RenderSummary& summary,
                          const MetadataTexts& texts);

}  // namespace hm
