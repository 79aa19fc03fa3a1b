#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>

#include "plumbline/detail/new_file.hpp"
#include "plumbline/error.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr ::mode_t kPermissions = 0777;
constexpr ::mode_t kNewFile = 0666;  ///< before the umask

/// What the name stands for, links followed; nothing where there is no such file.
std::optional<struct ::stat> status_of(const fs::path& file) {
  struct ::stat result = {};
  if (::stat(file.c_str(), &result) != 0) return std::nullopt;
  return result;
}

/// Where links lead to, also to a file that is not there.
fs::path link_target(fs::path file) {
  constexpr int kMostLinks = 40;  // as the kernel's
  std::error_code is_no_link;
  for (int i = 0; i < kMostLinks; ++i) {
    const fs::path next = fs::read_symlink(file, is_no_link);
    if (is_no_link) break;
    file = file.parent_path() / next;
  }
  return file;
}

}  // namespace

NewFile::NewFile(const fs::path& target) : target_(target) {
  const auto old = status_of(target);
  if (!old && errno != ENOENT) fail("cannot create the file");
  if (old && S_ISDIR(old->st_mode)) {
    errno = EISDIR;
    fail("cannot write the file");
  }
  if (!old || S_ISREG(old->st_mode)) {
    if (old && ::access(target.c_str(), W_OK) != 0) fail("cannot replace the file");
    // Never readable by others than the file that it replaces.
    create_beside(old ? old->st_mode & kPermissions : kNewFile);
  }
}

NewFile::~NewFile() {
  if (file_ >= 0) ::close(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

/// Its name does not hold the target's, which may be as long as names can be.
void NewFile::create_beside(unsigned permissions) {
  constexpr int kMostNames = 1000;
  const fs::path file = link_target(target_);
  const std::string begin =
      (file.parent_path() / (".plumbline-" + std::to_string(::getpid()) + "-")).string();
  for (int i = 0; i < kMostNames && file_ < 0; ++i) {
    std::string name = begin + std::to_string(i);
    file_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
    if (file_ >= 0) temporary_ = std::move(name);
    if (file_ < 0 && errno != EEXIST) break;
  }
  if (file_ < 0) fail("cannot create the file");
}

/// Only now: a pipe waits for its reader.
void NewFile::open_stream() {
  file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  if (file_ < 0) fail("cannot write");
}

void NewFile::write(std::string_view content) {
  if (file_ < 0) open_stream();
  while (!content.empty()) {
    const ssize_t written = ::write(file_, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write the file");
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

void NewFile::commit() {
  if (file_ < 0) open_stream();
  const int file = file_;
  if (temporary_.empty()) {
    file_ = -1;
    if (::close(file) != 0) fail("cannot write the file");
    return;
  }
  if (const auto old = status_of(target_)) {
    if (::fchmod(file, old->st_mode & kPermissions) != 0) fail("cannot set the file's permissions");
  }
  if (::fsync(file) != 0 && errno != EINVAL) fail("cannot write the file");
  file_ = -1;
  if (::close(file) != 0) fail("cannot write the file");
  if (::rename(temporary_.c_str(), link_target(target_).c_str()) != 0) {
    fail("cannot replace the file");
  }
  temporary_.clear();
}

void NewFile::fail(const std::string& what) const {
  throw Error(ErrorCode::BadFile, what + " (" + std::strerror(errno) + ")",
              {target_.string(), 0, 0});
}

void write_file(const fs::path& file, std::string_view content) {
  NewFile result(file);
  result.write(content);
  result.commit();
}

}  // namespace plumbline
