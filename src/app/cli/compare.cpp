// Reads both pictures, measures the layers they share, writes the error's picture, and says whether
// a limit was exceeded.
#include "app/cli/compare.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <utility>

#include "app/cli/compare_report.h"
#include "app/cli/flag.h"
#include "app/cli/output.h"
#include "app/cli/values.h"
#include "base/files.h"
#include "compare/error_map.h"
#include "image/picture_file.h"
#include "image/write.h"
#include "output/write.h"

namespace hm::cli {
namespace {

std::string size_of(const LayeredImage& p) {
    const PictureWindow& w = p.data;
    return fmt::format("{} x {} pixels{}", w.width(), w.height(),
                       w.x0 != 0 || w.y0 != 0 ? fmt::format(" from {},{} on", w.x0, w.y0) : "");
}

// Whether the pictures can be compared at all.
Result<void> check_pair(const CompareOptions& options, const PictureFile& a, const PictureFile& b) {
    const auto refuse = [&](std::string why) {
        return fail(ErrorKind::invalid, options.test.string(), "", std::move(why));
    };
    const std::string other = options.reference.string();
    if (!(a.picture.data == b.picture.data))
        return refuse(
            fmt::format("is {}, but {} is {}", size_of(a.picture), other, size_of(b.picture)));
    const auto kind = [](bool encoded) { return encoded ? "sRGB" : "linear"; };
    if (a.encoded != b.encoded)
        return refuse(fmt::format("has {} values, but {} has {} ones", kind(a.encoded), other,
                                  kind(b.encoded)));
    return {};
}

std::vector<std::string> channel_names(const Layer& layer) {
    std::vector<std::string> names;
    for (const LayerChannel& channel : layer.channels)
        names.push_back(channel.name);
    std::sort(names.begin(), names.end());
    return names;
}

// An alpha may be missing: one picture has a transparent background, the other none.
bool same_channels(const Layer& a, const Layer& b) {
    auto x = channel_names(a), y = channel_names(b);
    for (auto* names : {&x, &y})
        if (names->size() > 1) std::erase(*names, "A");
    return x == y;
}

std::string list_of_layers(const LayeredImage& picture) {
    std::string names;
    for (const Layer& layer : picture.layers)
        names += (names.empty() ? "" : ", ") + shown_name(layer);
    return names;
}

Result<const Layer*> find_layer(const LayeredImage& picture, const std::string& name,
                                const std::filesystem::path& file) {
    if (const Layer* layer = picture.find(name == "beauty" ? "" : name)) return layer;
    if (const Layer* layer = picture.find(name)) return layer;
    return fail(ErrorKind::invalid, file.string(), "",
                fmt::format("has no layer \"{}\"; there are {}", name, list_of_layers(picture)));
}

using Pairs = std::vector<std::pair<const Layer*, const Layer*>>;

Result<Pairs> choose_layers(const CompareOptions& options, const LayeredImage& a,
                            const LayeredImage& b, CompareReport& report) {
    Pairs pairs;
    const bool all =
        std::find(options.layers.begin(), options.layers.end(), "all") != options.layers.end();
    std::vector<std::string> names = options.layers;
    if (names.empty()) names = {"beauty"};
    if (all) {
        names.clear();
        for (const Layer& layer : a.layers)
            (b.find(layer.name) ? names : report.only_test).push_back(shown_name(layer));
        for (const Layer& layer : b.layers)
            if (!a.find(layer.name)) report.only_reference.push_back(shown_name(layer));
    }
    for (const std::string& name : names) {
        const std::size_t equals = name.find('=');
        const std::string second = equals == name.npos ? name : name.substr(equals + 1);
        HM_TRY_ASSIGN(const Layer* test, find_layer(a, name.substr(0, equals), options.test));
        HM_TRY_ASSIGN(const Layer* reference, find_layer(b, second, options.reference));
        if (same_channels(*test, *reference))
            pairs.emplace_back(test, reference);
        else
            report.different_channels.push_back(name);
    }
    return pairs;
}

void check_limits(const CompareOptions& options, const LayerError& e,
                  std::vector<std::string>& exceeded) {
    const auto limit = [&](const char* what, double value, const std::optional<float>& most) {
        // NaN is not below any limit.
        if (most && !(value <= double(*most)))
            exceeded.push_back(
                fmt::format("{}: {} is {:.6g}, above {:g}", e.name, what, value, *most));
    };
    limit("RMSE", e.stored.rmse, options.max_rmse);
    limit("relMSE", e.stored.relative_mse, options.max_relmse);
    if (e.flip) limit("FLIP", *e.flip, options.max_flip);
    const bool any = options.max_rmse || options.max_relmse || options.max_flip || options.z_test;
    if (any && e.not_finite_test + e.not_finite_reference > 0)
        exceeded.push_back(e.name + ": there are pixels that are not finite");
    if (options.z_test && e.z_test && !e.z_test->agree())
        exceeded.push_back(e.name + ": the z-test finds a difference");
}

Result<void> check_z_test(const CompareOptions& options, const PictureFile& a,
                          const PictureFile& b) {
    if (!options.z_test) return {};
    HM_TRY(find_layer(a.picture, "variance", options.test));
    HM_TRY(find_layer(b.picture, "variance", options.reference));
    return {};
}

Result<void> write_error_picture(const std::filesystem::path& path, const LayerError& layer) {
    const Plane& error = layer.picture;
    if (error.values.empty())
        return fail(
            ErrorKind::invalid_argument, "", "",
            fmt::format(
                "--error: FLIP compares colours, which {} does not have; use rmse or relmse",
                layer.name));
    if (picture_kind(path) == PictureKind::png) return write_png(path, magma(error), false, {});
    return write_exr(path, grey(error), false, {});
}

}  // namespace

void add_compare_flags(CLI::App& app, CompareOptions& o) {
    app.add_option("FILE", o.test, "The picture to judge: .exr, .hdr, .png or .jpg")->required();
    app.add_option("REFERENCE", o.reference, "What it should look like")->required();
    app.add_option("--layer", o.layers,
                   "Compare this layer of both files (beauty), or FILE's first with REFERENCE's "
                   "second, as in denoised=beauty; may be repeated. all: every layer")
        ->type_name("NAME[=NAME]|all")
        ->allow_extra_args(false);
    const auto output = [&o](const std::string& path) {
        const std::optional<PictureKind> kind = picture_kind(path);
        if (kind != PictureKind::png && kind != PictureKind::exr)
            throw CLI::ValidationError("--output", "\"" + path + "\" does not end in .exr or .png");
        o.error_picture = path;
    };
    CLI::Option* picture = app.add_option_function<std::string>(
        "-o,--output", output,
        "Write a picture of the error in the first layer. .png: colours from black (0) to light "
        "yellow (1), green where a value is not finite. .exr: the numbers");
    picture->type_name("PATH");
    const auto kind = [](const std::string& text) { return parse_choice(text, kErrorMetrics); };
    add(app, "--error", "NAME", o.error_metric, kind,
        "What that picture shows: flip (the default), rmse or relmse")
        ->needs(picture);
    const auto limit = [](const std::string& text) { return parse_number(text, 0, 1e30f); };
    add(app, "--max-rmse", "X", o.max_rmse, limit, "Fail if a layer's RMSE is above this");
    add(app, "--max-relmse", "X", o.max_relmse, limit, "Fail if a layer's relMSE is above this");
    add(app, "--max-flip", "X", o.max_flip, limit, "Fail if a layer's mean FLIP is above this");
    app.add_flag("--z-test", o.z_test,
                 "Fail if the beauties differ by more than their variance layers explain");
    app.add_flag("--json", o.json, "Print JSON instead of text");
    app.footer(
        "The exit code is 0; 11 if a limit is exceeded, if a value is NaN or infinite and there is "
        "a "
        "limit, or if a layer is missing with --layer all; 4 if the two can't be compared.");
}

Result<ExitCode> compare(const CompareOptions& options) {
    if (!options.error_picture.empty()) HM_TRY(check_writable(options.error_picture));
    HM_TRY_ASSIGN(const PictureFile a, read_picture_file(options.test));
    HM_TRY_ASSIGN(const PictureFile b, read_picture_file(options.reference));
    for (const auto& [path, file] : {std::pair(options.test, &a), {options.reference, &b}})
        for (const std::string& warning : file->warnings)
            fmt::print(stderr, "warning: {}: {}\n", path.string(), warning);
    HM_TRY(check_pair(options, a, b));
    HM_TRY(check_z_test(options, a, b));

    CompareReport report{
        a.picture.data.width(), a.picture.data.height(), a.encoded, {}, {}, {}, {}, {}};
    HM_TRY_ASSIGN(const Pairs pairs, choose_layers(options, a.picture, b.picture, report));
    for (const auto& [test, reference] : pairs) {
        const bool first = report.layers.empty() && !options.error_picture.empty();
        report.layers.push_back(
            measure({a.picture, *test, b.picture, *reference, a.encoded},
                    first ? std::optional(options.error_metric) : std::nullopt));
        if (first) HM_TRY(write_error_picture(options.error_picture, report.layers[0]));
        check_limits(options, report.layers.back(), report.exceeded);
    }
    HM_TRY(print(options.json ? compare_json(options, report) : compare_text(options, report)));
    const bool different = !report.exceeded.empty() || !report.only_test.empty() ||
                           !report.only_reference.empty() || !report.different_channels.empty();
    return different ? ExitCode::different : ExitCode::ok;
}

}  // namespace hm::cli
