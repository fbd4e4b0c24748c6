// What is reported about a finished picture: texts in its metadata, a JSON report, one line.
#pragma once

#include <string>

#include "app/cli/options.h"
#include "base/diagnostics.h"
#include "session/metadata.h"

namespace hm::cli {

// "--eye 0,0,1 --fov 45": settings as flags that can be typed again.
std::string flags_text(const NamedValues& values);

MetadataTexts metadata_texts(const RenderOptions& options, const RenderSummary& summary);

std::string json_report(const RenderOptions& options, const RenderSummary& summary,
                        const Diagnostics& diagnostics);
std::string summary_line(const RenderSummary& summary);

}  // namespace hm::cli
