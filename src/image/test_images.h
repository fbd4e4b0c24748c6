// Helpers for the tests of this folder.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/files.h"
#include "image/codecs.h"
#include "image/read.h"

namespace hm::testing_images {

// A temporary folder, removed by the destructor.
class Folder {
  public:
    Folder() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "image_test-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data()) ? pattern : std::string();
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::filesystem::path operator/(const char* name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

inline ByteArray bytes_of_file(const std::filesystem::path& path) {
    auto bytes = read_file(path);
    EXPECT_TRUE(bytes) << bytes.error().line();
    return bytes ? std::move(*bytes) : ByteArray();
}

// Reads an image that must be valid and of this type; empty otherwise.
template <class T>
ImageOf<T> read_whole(Bytes bytes) {
    auto read = read_image(bytes, "test");
    EXPECT_TRUE(read) << read.error().line();
    if (!read) return {};
    const ImageOf<T>* image = nullptr;
    if constexpr (std::is_same_v<T, float>)
        image = std::get_if<FloatImage>(&*read);
    else if (const auto* texture = std::get_if<TextureImage>(&*read))
        image = std::get_if<ImageOf<T>>(&texture->image());
    EXPECT_NE(image, nullptr) << "an image of another type";
    return image ? *image : ImageOf<T>();
}

inline bool has_pixels(const AnyImage& image) {
    if (const auto* texture = std::get_if<TextureImage>(&image)) return !texture->bytes().empty();
    return !std::get<FloatImage>(image).pixels.empty();
}

// Truncated files must be rejected, except if only bytes of the last `idle` are missing, which
// carry no data. The copy has the exact size, so that sanitizers detect reads past the end.
inline void expect_cuts_refused(Bytes bytes, std::size_t idle = 0) {
    for (std::size_t size = 0; size < bytes.size() - idle; size += 7) {
        const std::vector<std::byte> cut(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
        const auto image = read_image(cut, "cut");
        ASSERT_FALSE(image) << "accepted " << size << " of " << bytes.size() << " bytes";
        ASSERT_EQ(image.error().kind, ErrorKind::invalid) << image.error().line();
        ASSERT_EQ(image.error().file, "cut");
    }
    const std::vector<std::byte> but_one(bytes.begin(), bytes.end() - std::ptrdiff_t(idle + 1));
    ASSERT_FALSE(read_image(but_one, "cut"));
}

// Damaged files must not crash; whether the damage is detected depends on the format.
inline void expect_damage_survived(Bytes bytes, unsigned char flip) {
    std::vector<std::byte> damaged(bytes.begin(), bytes.end());
    for (std::size_t i = 0; i < damaged.size(); ++i) {
        damaged[i] ^= std::byte(flip);
        const auto image = read_image(damaged, "damaged");
        EXPECT_TRUE(!image || has_pixels(*image));
        damaged[i] ^= std::byte(flip);
    }
}

}  // namespace hm::testing_images
