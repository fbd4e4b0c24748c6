#include "app/cli/info.h"

#include <cstdio>

#include "app/cli/info_report.h"

namespace hm::cli {
namespace {

Result<void> print(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        return fail(ExitCode::unwritable, "standard output", "", "can't be written");
    return {};
}

}  // namespace

Result<ExitCode> info(const InfoOptions& options) {
    InfoReport report = examine(options);
    if (options.json) {
        HM_TRY(print(info_json(report)));
    } else if (report.file) {
        HM_TRY(print(info_text(report)));
    }
    if (report.error) return tl::unexpected(std::move(*report.error));
    return report.diagnostics.warnings().empty() ? ExitCode::ok : kWarned;
}

}  // namespace hm::cli
