// Images, samplers, textures (glTF 2.0, 3.8, 5.18, 5.26, 5.29).
#include "corpus/container.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

std::string json_string(std::string_view text) {
    return '"' + std::string(text) + '"';
}

std::string cut_png(std::size_t bytes) {
    return json_string("data:image/png;base64," + base64(tiny_png().substr(0, bytes)));
}

void add_image_rules(std::vector<Case>& cases) {
    Object image(cases, "image", "5.18", "/images/0");
    image.rule("no-source", "uri or bufferView: one of them", {drop("/images/0/bufferView")},
               refused("/images/0", "has neither a uri nor a bufferView"));
    image.rule("two-sources", "uri or bufferView: only one of them",
               {set("/images/0/uri", json_string("a.png"))},
               refused("/images/0", "has both a uri and a bufferView"));
    image.index("bufferView");
    image.required("mimeType").expect(ignored("the content tells the format"));
    image.text("mimeType");
    image.value("mimeType", "unknown", R"("image/gif")", "is image/png or image/jpeg", "")
        .expect(warned("/images/0", "declared as \"image/gif\", but it is image/png", kRepaired));
    image.value("mimeType", "differs", R"("image/jpeg")", "is that of the content", "")
        .expect(warned("/images/0", "declared as \"image/jpeg\", but it is image/png", kRepaired));
    image.common();
    Object linked(cases, "image-uri", "5.18", "/images/1");
    linked.text("uri");
    linked.value("uri", "no-picture", json_string(data_uri("no picture")), "is a PNG or a JPEG",
                 "");
    linked.value("uri", "gif", json_string(data_uri("GIF89a\1\0\1\0")), "is a PNG or a JPEG", "");
    linked.value("uri", "cut-header", cut_png(20), "is a whole picture", "");
    linked.value("uri", "cut-pixels", cut_png(45), "is a whole picture", "").silent(kProseOnly);
    linked.value("uri", "empty", R"("data:image/png;base64,")", "is a whole picture", "");
    linked
        .value("uri", "webp", json_string(data_uri("RIFF    WEBPVP8 ")), "is a PNG or a JPEG",
               "is a WebP image")
        .expect(refused("/images/1/uri", "is a WebP image", ErrorKind::unsupported));
}

void add_sampler_rules(std::vector<Case>& cases) {
    Object sampler(cases, "sampler", "5.26", "/samplers/0");
    for (const char* key : {"magFilter", "minFilter"}) {
        sampler.choice(key);
        sampler.unlisted(key, "unknown", "9730", "is one of the known filters", "is not a filter");
    }
    sampler.unlisted("magFilter", "mipmap", "9987", "is one of the known filters",
                     "is not a filter");
    sampler.unlisted("minFilter", "zero", "0", "is one of the known filters", "is not a filter");
    for (const char* key : {"wrapS", "wrapT"}) {
        sampler.choice(key);
        sampler.unlisted(key, "unknown", "10496", "is one of the known modes",
                         "is not a wrapping mode");
        sampler.unlisted(key, "border", "33069", "is one of the known modes",
                         "is not a wrapping mode");
    }
    sampler.common();
}

}  // namespace

void add_texture_rules(std::vector<Case>& cases) {
    add_image_rules(cases);
    add_sampler_rules(cases);
    Object texture(cases, "texture", "5.29", "/textures/0");
    texture.index("sampler");
    texture.index("source");
    texture.common();
}

}  // namespace hm::corpus
