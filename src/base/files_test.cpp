#include "base/files.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <new>
#include <string>
#include <string_view>

namespace hm {
namespace {

namespace fs = std::filesystem;

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

// Each test gets an empty folder of its own.
class Files : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "base_test-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string text_of(const fs::path& path) {
        const auto bytes = read_file(path);
        if (!bytes) return "<" + bytes.error().line() + ">";
        return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
    }
    std::ptrdiff_t entries() {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }

    fs::path folder_;
};

TEST_F(Files, ReadsWhatWasWritten) {
    const std::string text("a\0b\nc\xFF", 6);
    std::string large(3 << 20, 'x');
    large[1 << 20] = 'y';
    ASSERT_TRUE(write_file_atomically(folder_ / "small", bytes_of(text)));
    ASSERT_TRUE(write_file_atomically(folder_ / "large", bytes_of(large)));
    ASSERT_TRUE(write_file_atomically(folder_ / "empty", {}));
    EXPECT_EQ(text_of(folder_ / "small"), text);
    EXPECT_TRUE(text_of(folder_ / "large") == large);
    EXPECT_EQ(text_of(folder_ / "empty"), "");
    EXPECT_EQ(entries(), 3);
}

TEST_F(Files, ReadingSaysWhyNot) {
    const auto missing = read_file(folder_ / "missing.gltf");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::unreadable);
    EXPECT_EQ(missing.error().line(),
              (folder_ / "missing.gltf").string() + ": can't be opened: No such file or directory");

    const auto directory = read_file(folder_);
    ASSERT_FALSE(directory);
    EXPECT_EQ(directory.error().kind, ErrorKind::unreadable);

    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    const auto pipe = read_file(folder_ / "pipe");  // has no writer: must not block
    ASSERT_FALSE(pipe);
    EXPECT_EQ(pipe.error().kind, ErrorKind::unreadable);
}

TEST_F(Files, ReplacesAtOnceAndHonoursTheUmask) {
    const fs::path path = folder_ / "picture.exr";
    ASSERT_TRUE(write_file_atomically(path, bytes_of("old")));
    const mode_t before = ::umask(027);
    const auto written = write_atomically(path, [&](const fs::path& temporary) -> Result<void> {
        EXPECT_EQ(temporary.parent_path(), folder_);
        EXPECT_EQ(text_of(path), "old");  // unchanged while the new file is being written
        std::ofstream(temporary) << "new";
        return {};
    });
    ASSERT_TRUE(write_file_atomically(folder_ / "other", bytes_of("x")));
    ::umask(before);
    ASSERT_TRUE(written);
    EXPECT_EQ(text_of(path), "new");
    struct stat info {};
    ASSERT_EQ(::stat((folder_ / "other").c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777u, 0640u);
    EXPECT_EQ(entries(), 2);
}

TEST_F(Files, FailureLeavesTheOldFileAndNothingElse) {
    const fs::path path = folder_ / "picture.exr";
    ASSERT_TRUE(write_file_atomically(path, bytes_of("old")));
    const auto refused = write_atomically(path, [](const fs::path& temporary) -> Result<void> {
        std::ofstream(temporary) << "half";
        return fail(ErrorKind::unwritable, temporary.string(), "", "disk full");
    });
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().line(), path.string() + ": disk full");
    EXPECT_THROW((void)write_atomically(path,
                                        [](const fs::path& temporary) -> Result<void> {
                                            std::ofstream(temporary) << "half";
                                            throw std::bad_alloc();
                                        }),
                 std::bad_alloc);
    EXPECT_EQ(text_of(path), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(Files, RefusesWhatIsNoFile) {
    const auto check = [&](const fs::path& path) {
        const auto written = write_file_atomically(path, bytes_of("x"));
        ASSERT_FALSE(written) << path;
        EXPECT_EQ(written.error().kind, ErrorKind::unwritable);
        EXPECT_EQ(written.error().file, path.string());
    };
    check(folder_);
    check(folder_ / "");
    check("");
    check(folder_ / "missing" / "file");
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    check(folder_ / "pipe");
    EXPECT_TRUE(fs::is_fifo(folder_ / "pipe"));
    EXPECT_EQ(entries(), 1);
}

TEST_F(Files, ChecksBeforehandAndLeavesNothing) {
    const fs::path path = folder_ / "picture.exr";
    EXPECT_TRUE(check_writable(path));
    EXPECT_TRUE(check_writable(path, 1 << 20));
    EXPECT_EQ(entries(), 0);
    ASSERT_TRUE(write_file_atomically(path, bytes_of("old")));
    EXPECT_TRUE(check_writable(path));
    EXPECT_EQ(text_of(path), "old");
    const auto message = [](const fs::path& wanted, std::uint64_t bytes = 1) {
        const auto checked = check_writable(wanted, bytes);
        return checked ? "" : checked.error().message;
    };
    EXPECT_EQ(message(folder_), "can't be written: it is a folder");
    EXPECT_EQ(message(folder_ / "a" / "b"), "can't be written: there is no such folder");
    EXPECT_NE(message("/sys/picture.exr"), "");            // files can't be created there
    EXPECT_NE(message(path, std::uint64_t(1) << 60), "");  // larger than any disk
    EXPECT_EQ(entries(), 1);
}

// Simulates a full disk with a file size limit (RLIMIT_FSIZE): the write fails halfway through.
TEST_F(Files, AFileThatDoesNotFitLeavesTheOldOne) {
    const fs::path path = folder_ / "picture.exr";
    ASSERT_TRUE(write_file_atomically(path, bytes_of("old")));
    ASSERT_NE(::signal(SIGXFSZ, SIG_IGN), SIG_ERR);
    struct rlimit before {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    struct rlimit small = before;
    small.rlim_cur = 4096;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto written = write_file_atomically(path, bytes_of(std::string(10000, 'x')));
    const auto checked = check_writable(path, 10000);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().line(), path.string() + ": can't be written: File too large");
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().line(), written.error().line());
    EXPECT_EQ(text_of(path), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(Files, WritesThroughASymbolicLink) {
    fs::create_directory(folder_ / "sub");
    ASSERT_TRUE(write_file_atomically(folder_ / "sub" / "real", bytes_of("old")));
    fs::create_symlink(folder_ / "sub" / "real", folder_ / "link");
    ASSERT_TRUE(write_file_atomically(folder_ / "link", bytes_of("new")));
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(text_of(folder_ / "sub" / "real"), "new");
}

TEST_F(Files, LongestNameFits) {
    const fs::path path = folder_ / std::string(255, 'n');
    ASSERT_TRUE(write_file_atomically(path, bytes_of("x")));
    EXPECT_EQ(text_of(path), "x");
}

}  // namespace
}  // namespace hm
