#include "mesher/io/atomic_file.hpp"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "mesher/geometry/error.hpp"

namespace anisofront {

namespace {

constexpr mode_t kDefaultMode = 0666;

std::filesystem::path without_links(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  return error ? path : target;
}

/// Creates a file beside `path` whose name nobody uses; sets `name`.
int create_beside(const std::filesystem::path& path, std::filesystem::path& name) {
  for (int attempt = 0;; ++attempt) {
    name = path;
    name += ".part" + std::to_string(::getpid()) + "-" + std::to_string(attempt);
    const int descriptor =
        ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kDefaultMode);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path)
    : path_(without_links(path)), buffer_(kCapacity) {
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail();
    return;
  }
  std::filesystem::path name;
  descriptor_ = create_beside(path_, name);
  if (descriptor_ < 0) fail();
  // A failure to keep the permissions of the old file is no reason not to write.
  if (exists) static_cast<void>(::fchmod(descriptor_, status.st_mode & 07777) == 0);
  temporary_ = name;
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::text(std::string_view bytes) {
  if (bytes.size() > kCapacity) {
    flush();
    return write_fully(bytes);
  }
  std::memcpy(room(bytes.size()), bytes.data(), bytes.size());
  used_ += bytes.size();
}

void AtomicFile::commit() {
  flush();
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) fail();
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail();
  temporary_.clear();
}

void AtomicFile::flush() {
  write_fully({buffer_.data(), used_});
  used_ = 0;
}

void AtomicFile::write_fully(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void AtomicFile::fail() const {
  throw InputError("cannot write " + path_.string() + ": " + std::strerror(errno));
}

}  // namespace anisofront
