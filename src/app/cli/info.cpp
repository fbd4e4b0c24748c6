#include "app/cli/info.h"

#include "app/cli/info_report.h"
#include "app/cli/output.h"

namespace hm::cli {
Result<ExitCode> info(const InfoOptions& options) {
    InfoReport report = examine(options);
    if (options.json) {
        HM_TRY(print(info_json(report)));
    } else if (report.file) {
        HM_TRY(print(info_text(report)));
    }
    if (report.error) return tl::unexpected(std::move(*report.error));
    return report.diagnostics.warnings().empty() ? ExitCode::ok : ExitCode::warned;
}

}  // namespace hm::cli
