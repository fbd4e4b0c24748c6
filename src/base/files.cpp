#include "base/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <exception>
#include <string>
#include <system_error>
#include <utility>

namespace hm {
namespace {

namespace fs = std::filesystem;

// RAII owner of a file descriptor.
struct Descriptor {
    explicit Descriptor(int opened) : fd(opened) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
    int fd;
};

// A temporary file in the target's folder. The destructor removes it unless it was renamed.
struct TemporaryFile {
    // Process id and counter make the name unique. It does not include the target's name, because
    // the result could exceed the file system's limit on name lengths.
    explicit TemporaryFile(const fs::path& target)
        : path(target.parent_path() / fmt::format(".himalaya-{}-{}.part", ::getpid(), counter++)) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        std::error_code ignored;
        if (!renamed) fs::remove(path, ignored);
    }
    static inline std::atomic<unsigned> counter = 0;
    fs::path path;
    bool renamed = false;
};

std::string error_text(int number) {
    return std::generic_category().message(number);
}

tl::unexpected<Error> unreadable(const fs::path& path, std::string message) {
    return fail(ErrorKind::unreadable, path.string(), "", std::move(message));
}

tl::unexpected<Error> unwritable(const fs::path& path, std::string message) {
    return fail(ErrorKind::unwritable, path.string(), "", "can't be written: " + message);
}

Result<void> write_bytes(const fs::path& path, std::span<const std::byte> bytes) {
    // Permissions are 0666 minus the umask, the default for new files.
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.fd < 0) return unwritable(path, error_text(errno));
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.fd, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return unwritable(path, error_text(errno));
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    // Network file systems may report a full disk only on close.
    if (::close(std::exchange(file.fd, -1)) != 0) return unwritable(path, error_text(errno));
    return {};
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// The file that writing to `path` replaces: for a symbolic link its target, not the link itself.
Result<fs::path> replaceable_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) return unwritable(path, "it is a folder");
    // Renaming onto a device or pipe would replace it.
    if (fs::exists(status) && !fs::is_regular_file(status))
        return unwritable(path, "it exists and is not a regular file");
    if (!path.has_filename()) return unwritable(path, "it names no file");
    if (!fs::is_directory(folder_of(path), error))
        return unwritable(path, "there is no such folder");
    if (!fs::exists(status) || !fs::is_symlink(fs::symlink_status(path, error))) return path;
    const fs::path target = fs::canonical(path, error);
    if (error) return unwritable(path, error.message());
    return target;
}

// Flushes the file's data from the page cache to disk.
Result<void> sync_file(const fs::path& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.fd < 0 || (::fsync(file.fd) != 0 && errno != EINVAL))
        return unwritable(path, error_text(errno));
    return {};
}

// Flushes the directory entry (the file's new name) too. Errors are ignored: some file systems
// don't support it, and the file is complete anyway.
void sync_folder(const fs::path& folder) {
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.fd >= 0) ::fsync(opened.fd);
}

}  // namespace

Result<ByteArray> read_file(const fs::path& path) {
    // O_NONBLOCK: opening a named pipe must not block until its other end is opened.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.fd < 0) return unreadable(path, "can't be opened: " + error_text(errno));
    struct stat info {};
    if (::fstat(file.fd, &info) != 0) return unreadable(path, error_text(errno));
    if (S_ISDIR(info.st_mode)) return unreadable(path, "is a folder, not a file");
    if (!S_ISREG(info.st_mode)) return unreadable(path, "is not a regular file");

    ByteArray bytes;
    try {
        bytes.resize(static_cast<std::size_t>(info.st_size));
    } catch (const std::exception&) {  // bad_alloc or length_error
        return unreadable(path, fmt::format("its {} bytes do not fit in memory", info.st_size));
    }
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t got = ::read(file.fd, bytes.data() + done, bytes.size() - done);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return unreadable(path, "can't be read: " + error_text(errno));
        if (got == 0) return unreadable(path, "became shorter while it was read");
        done += static_cast<std::size_t>(got);
    }
    return bytes;
}

Result<void> check_writable(const fs::path& path, std::uint64_t bytes) {
    HM_TRY_ASSIGN(const fs::path target, replaceable_file(path));
    const TemporaryFile temporary(target);
    const Descriptor file(
        ::open(temporary.path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.fd < 0) return unwritable(path, error_text(errno));
    if (::fallocate(file.fd, 0, 0, static_cast<off_t>(bytes)) == 0) return {};
    // Fallback for file systems without fallocate: writing one byte succeeds unless the disk is
    // full.
    if (errno != EOPNOTSUPP && errno != EINTR) return unwritable(path, error_text(errno));
    if (::write(file.fd, "", 1) != 1) return unwritable(path, error_text(errno));
    return {};
}

Result<void> write_atomically(const fs::path& path,
                              const std::function<Result<void>(const fs::path&)>& write) {
    HM_TRY_ASSIGN(const fs::path target, replaceable_file(path));
    TemporaryFile temporary(target);
    Result<void> written = write(temporary.path);
    if (written) written = sync_file(temporary.path);
    if (!written) {
        // Report `path`, which the user knows, instead of the temporary name.
        Error why = std::move(written.error());
        if (why.file == temporary.path.string()) why.file = path.string();
        return tl::unexpected<Error>(std::move(why));
    }
    std::error_code error;
    fs::rename(temporary.path, target, error);
    if (error) return unwritable(path, error.message());
    temporary.renamed = true;
    sync_folder(folder_of(target));
    return {};
}

Result<void> write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
    return write_atomically(
        path, [&](const fs::path& temporary) { return write_bytes(temporary, bytes); });
}

}  // namespace hm
