// Images: their sources, which of them are read, and errors.
#include <fmt/format.h>

#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

// A used material reads images 1 and 0 of `images`, an unused one reads image 2.
Overrides three_images(const std::string& images) {
    return {{"images", images},
            {"textures", R"([{"source":0},{"source":1},{"source":2}])"},
            {"materials", R"([{"emissiveTexture":{"index":2}},
                {"emissiveTexture":{"index":1},"normalTexture":{"index":0}}])"},
            {"meshes", R"([{"primitives":[{"material":1,
                "attributes":{"POSITION":0,"TEXCOORD_0":2}}]}])"}};
}

std::string data_image(std::string_view encoded) {
    return fmt::format(R"({{"uri":"data:image/png;base64,{}"}})", encoded);
}

TEST(Images, ReadsOnlyWhatIsUsed) {
    const std::string images =
        fmt::format("[{},{},{}]", data_image(kPng1), data_image(kPng2), R"({"uri":"none.png"})");
    const Loaded loaded = load_text(document(three_images(images)));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    const Scene& scene = *loaded.scene;
    ASSERT_EQ(scene.images.size(), 2u);
    EXPECT_EQ(scene.materials[0].emissive_texture.image, kUnset);
    EXPECT_EQ(scene.materials[1].normal_texture.image, 0);
    EXPECT_EQ(scene.materials[1].emissive_texture.image, 1);
    EXPECT_EQ(scene.images[0].width(), 1u);
    EXPECT_EQ(scene.images[1].width(), 2u);
    const std::vector<Rgba<std::uint8_t>> pixel{{10, 20, 30, 40}};
    EXPECT_EQ(std::get<Image8>(scene.images[0].image()).pixels, pixel);
}

TEST(Images, IndicesFollowTheImagesThatAreRead) {
    Overrides overrides = three_images(
        fmt::format("[{},{},{}]", R"({"uri":"none.png"})", data_image(kPng2), data_image(kPng1)));
    overrides["materials"] = R"([{},{"emissiveTexture":{"index":2},"normalTexture":{"index":1}}])";
    const Loaded loaded = load_text(document(overrides));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(loaded.scene->materials[1].normal_texture.image, 0);
    EXPECT_EQ(loaded.scene->materials[1].emissive_texture.image, 1);
    EXPECT_EQ(loaded.scene->images.at(0).width(), 2u);
}

std::vector<std::byte> pixels_of(const TextureImage& image) {
    return {image.bytes().begin(), image.bytes().end()};
}

TEST(Images, FromBufferViewAndFile) {
    const std::vector<std::uint8_t> png{
        0x89, 'P',  'N',  'G',  '\r', '\n', 0x1a, '\n', 0,   0,    0,    13,   'I',  'H',
        'D',  'R',  0,    0,    0,    1,    0,    0,    0,   1,    8,    6,    0,    0,
        0,    0x1f, 0x15, 0xc4, 0x89, 0,    0,    0,    13,  'I',  'D',  'A',  'T',  0x78,
        0x9c, 0x63, 0xe0, 0x12, 0x91, 0xd3, 0,    0,    0,   0xcd, 0,    0x65, 0x6a, 0x99,
        0x84, 0x42, 0,    0,    0,    0,    'I',  'E',  'N', 'D',  0xae, 0x42, 0x60, 0x82};
    // Compared with the base64 form of the same image.
    ASSERT_EQ(base64(bytes_of(png)), kPng1);
    Overrides overrides = three_images(
        R"([{"bufferView":6,"mimeType":"image/png"},{"uri":"a%20b.png"},{"uri":"none.png"}])");
    overrides["buffers"] = buffers(triangle_bytes() + bytes_of(png));
    std::string text = document(overrides);
    const std::string last = R"("byteLength":48})";
    text.insert(text.find(last) + last.size(),
                fmt::format(R"(,{{"buffer":0,"byteOffset":164,"byteLength":{}}})", png.size()));
    const Folder folder;
    folder.write("a b.png", bytes_of(png));
    Diagnostics diagnostics;
    const auto scene = load_gltf(folder.write("scene.gltf", text), diagnostics);
    ASSERT_TRUE(scene) << scene.error().line();
    EXPECT_EQ(scene->images.size(), 2u);
    EXPECT_EQ(pixels_of(scene->images[0]), pixels_of(scene->images[1]));

    // External images are part of the scene's hash; even a comment in one changes it.
    std::string other = bytes_of(png);
    other.insert(other.size() - 12, std::string("\0\0\0\3tEXta\0b\xDC\x49\xA2\x3B", 15));
    EXPECT_EQ(load_gltf(folder.write("scene.gltf", text), diagnostics)->hash, scene->hash);
    folder.write("a b.png", other);
    const auto changed = load_gltf(folder.write("scene.gltf", text), diagnostics);
    ASSERT_TRUE(changed) << changed.error().line();
    EXPECT_NE(changed->hash, scene->hash);
    EXPECT_EQ(pixels_of(changed->images[0]), pixels_of(scene->images[0]));
}

TEST(Images, AMediaTypeThatIsWrongIsWarnedOf) {
    const std::string said =
        fmt::format(R"({{"uri":"data:image/png;base64,{}","mimeType":"image/jpeg"}})", kPng1);
    const std::string in_uri = fmt::format(R"({{"uri":"data:image/jpeg;base64,{}"}})", kPng1);
    const Loaded loaded =
        load_text(document(three_images(fmt::format("[{},{},{{}}]", said, in_uri))));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(loaded.warned("/images/0", "declared as \"image/jpeg\", but it is image/png"), 2u);
    EXPECT_EQ(loaded.diagnostics.warnings().size(), 1u);
}

TEST(Images, Refusals) {
    const std::string good = data_image(kPng1);
    const auto images = [&](const std::string& a, const std::string& b) {
        return three_images(fmt::format("[{},{},{}]", a, b, good));
    };
    const std::string webp = "RIFF" + std::string(4, 'x') + "WEBPVP8 ";
    const std::string ktx2 = "\xABKTX 20\xBB\r\n\x1A\n";
    expect_refused({
        {"missing file", images(good, R"({"uri":"none.png"})"), "/images/1/uri", "none.png",
         ErrorKind::unreadable},
        {"leaves the folder", images(good, R"({"uri":"../none.png"})"), "/images/1/uri", "..",
         ErrorKind::invalid},
        {"not a picture", images(good, data_image("aGVsbG8=")), "/images/1/uri", ""},
        {"cut picture", images(good, data_image(kPng1.substr(0, 60))), "/images/1/uri", ""},
        {"both", images(good, R"({"uri":"a.png","bufferView":0})"), "/images/1", "both"},
        {"neither", images(good, "{}"), "/images/1", "neither"},
        {"no such view", images(good, R"({"bufferView":9})"), "/images/1/bufferView",
         "past the end"},
        {"WebP", images(good, data_image(base64(webp))), "/images/1/uri", "WebP",
         ErrorKind::unsupported},
        {"KTX2", images(good, data_image(base64(ktx2))), "/images/1/uri", "KTX2",
         ErrorKind::unsupported},
        {"the first of two", images(R"({"uri":"none.png"})", "{}"), "/images/0/uri", "none.png",
         ErrorKind::unreadable},
    });
}

}  // namespace
}  // namespace hm::gltf_test
