// The program: parses, dispatches, and turns whatever went wrong into one line and an exit code.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "app/cli/bench.h"
#include "app/cli/compare.h"
#include "app/cli/denoise.h"
#include "app/cli/doctor/doctor.h"
#include "app/cli/hints.h"
#include "app/cli/info.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/output.h"
#include "app/cli/render.h"
#include "base/text.h"
#include "image/exr_threads.h"

namespace {

using namespace hm;

Result<cli::ExitCode> run(int count, const char* const* arguments) {
    HM_TRY_ASSIGN(const cli::CommandLine line, cli::parse_command_line(count, arguments));
    if (line.render) set_exr_threads(line.render->threads);
    if (line.denoise) set_exr_threads(line.denoise->threads);
    if (line.merge) set_exr_threads(0);
    if (line.render) return cli::render(*line.render);
    if (line.info) return cli::info(*line.info);
    if (line.doctor) return cli::doctor(*line.doctor);
    if (line.bench) return cli::bench(*line.bench);
    if (line.compare) return cli::compare(*line.compare);
    if (line.denoise) return cli::denoise(*line.denoise);
    if (line.merge) return cli::merge(*line.merge);
    HM_TRY(cli::print(line.text));
    return cli::ExitCode::ok;
}

int complain(cli::ExitCode code, std::string_view line) {
    cli::tell(fmt::format("himalaya: error: {}\n", printable(line)));
    return int(code);
}

}  // namespace

int main(int count, char** arguments) {
    cli::ignore_write_signals();
    try {
        const Result<cli::ExitCode> code = run(count, arguments);
        return code ? int(*code)
                    : complain(cli::exit_code(code.error().kind),
                               cli::with_hint(code.error()).line());
    } catch (const std::bad_alloc&) {
        return complain(cli::ExitCode::internal, "there is not enough memory");
    } catch (const std::exception& error) {
        return complain(cli::ExitCode::internal, error.what());
    }
}
