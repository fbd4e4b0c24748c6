#include "app/cli/compare_report.h"

#include <fmt/format.h>

#include "base/json_writer.h"

namespace hm::cli {
namespace {

std::string cell(const std::optional<double>& number, const char* format) {
    return number ? fmt::format(fmt::runtime(format), *number) : "-";
}

std::string line_of(const LayerError& e) {
    return fmt::format("{:<18} {:>11.5g} {:>11.5g} {:>8} {:>8} {:>8}\n", e.name, e.stored.rmse,
                       e.stored.relative_mse, cell(e.psnr_db, "{:.2f}"), cell(e.ssim, "{:.5f}"),
                       cell(e.flip, "{:.5f}"));
}

std::string notes_of(const CompareOptions& options, const LayerError& e) {
    std::string text;
    const auto broken = [&](std::uint64_t count, const std::filesystem::path& file) {
        if (count > 0)
            text +=
                fmt::format("  {} pixel{} of {} {} not finite and excluded from all measures\n",
                            count, count == 1 ? "" : "s", file.string(), count == 1 ? "is" : "are");
    };
    broken(e.not_finite_test, options.test);
    broken(e.not_finite_reference, options.reference);
    if (e.alpha_rmse && *e.alpha_rmse > 0)
        text += fmt::format("  alpha: RMSE {:.5g}\n", *e.alpha_rmse);
    if (!e.z_test) return text;
    const ZTest& z = *e.z_test;
    text += fmt::format(
        "  z-test: {}; {} of {} comparisons beyond {:.2f}, the largest {:.2f}; "
        "means {:.2f}, {:.2f}, {:.2f}\n",
        z.agree() ? "agree" : "differ", z.beyond, z.comparisons, z.threshold, z.largest, z.whole[0],
        z.whole[1], z.whole[2]);
    return text;
}

std::string names_line(const std::string& what, const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return names.empty() ? "" : fmt::format("{}: {}\n", what, text);
}

void write_optional(JsonWriter& json, const char* key, const std::optional<double>& number) {
    json.key(key);
    if (number)
        json.value(*number);
    else
        json.null();
}

void write_layer(JsonWriter& json, const LayerError& e, bool encoded) {
    json.begin_object().field("name", e.name);
    json.field("rmse", e.stored.rmse).field("relmse", e.stored.relative_mse);
    json.field("max_abs", e.stored.max_abs);
    write_optional(json, "alpha_rmse", e.alpha_rmse);
    write_optional(json, "psnr", e.psnr_db);
    write_optional(json, "ssim", e.ssim);
    write_optional(json, "flip", e.flip);
    if (e.flip && !encoded) {
        json.field("display_exposure", e.display_exposure);
        json.key("flip_exposures").begin_object();
        json.field("start", e.hdr.start_exposure).field("stop", e.hdr.stop_exposure);
        json.field("count", e.hdr.exposures).end_object();
    }
    json.key("not_finite").begin_object().field("test", e.not_finite_test);
    json.field("reference", e.not_finite_reference).end_object();
    if (e.z_test) {
        json.key("z_test").begin_object().field("agree", e.z_test->agree());
        json.field("comparisons", std::uint64_t(e.z_test->comparisons));
        json.field("beyond", std::uint64_t(e.z_test->beyond));
        json.field("threshold", e.z_test->threshold).field("largest", e.z_test->largest);
        json.key("means").values(e.z_test->whole).end_object();
    }
    json.end_object();
}

}  // namespace

std::string compare_text(const CompareOptions& options, const CompareReport& report) {
    std::string text = fmt::format("{} against {}, {} x {} pixels\n", options.test.string(),
                                   options.reference.string(), report.width, report.height);
    text += fmt::format("{:<18} {:>11} {:>11} {:>8} {:>8} {:>8}\n", "layer", "RMSE", "relMSE",
                        "PSNR dB", "SSIM", report.encoded ? "LDR-FLIP" : "HDR-FLIP");
    for (const LayerError& layer : report.layers)
        text += line_of(layer) + notes_of(options, layer);
    text += names_line("only in " + options.test.string(), report.only_test);
    text += names_line("only in " + options.reference.string(), report.only_reference);
    text += names_line("not with the same channels", report.different_channels);
    for (const std::string& limit : report.exceeded)
        text += limit + "\n";
    return text;
}

std::string compare_json(const CompareOptions& options, const CompareReport& report) {
    JsonWriter json;
    json.begin_object().field("program", "himalaya " HIMALAYA_VERSION);
    json.field("test", options.test.string()).field("reference", options.reference.string());
    json.field("width", report.width).field("height", report.height);
    json.field("values", report.encoded ? "sRGB" : "linear");
    json.field("flip_kind", report.encoded ? "LDR" : "HDR");
    json.key("layers").begin_array();
    for (const LayerError& layer : report.layers)
        write_layer(json, layer, report.encoded);
    json.end_array();
    json.key("only_in_test").values(report.only_test);
    json.key("only_in_reference").values(report.only_reference);
    json.key("different_channels").values(report.different_channels);
    json.key("exceeded").values(report.exceeded);
    json.end_object();
    return json.text() + "\n";
}

}  // namespace hm::cli
