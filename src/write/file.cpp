#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "plumbline/error.hpp"
#include "plumbline/write.hpp"

namespace plumbline {
namespace {

/// A temporary file beside its target, removed unless it was renamed to it.
class Temporary {
 public:
  explicit Temporary(const std::filesystem::path& target)
      : target_(target), name_(target.string() + ".XXXXXX"), file_(::mkstemp(name_.data())) {
    if (file_ < 0) fail("cannot create a file here");
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (file_ >= 0) ::close(file_);
    if (!renamed_) ::unlink(name_.c_str());
  }

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written = ::write(file_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail("cannot write the file");
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void rename() {
    if (::fchmod(file_, permissions()) != 0) fail("cannot set the file's permissions");
    if (::fsync(file_) != 0 && errno != EINVAL) fail("cannot write the file");
    if (::rename(name_.c_str(), target_.c_str()) != 0) fail("cannot replace the file");
    renamed_ = true;
  }

 private:
  /// Those of the file that is replaced, or of a new one.
  ::mode_t permissions() const {
    struct ::stat old = {};
    if (::stat(target_.c_str(), &old) == 0) return old.st_mode & 07777;
    const ::mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
  }

  [[noreturn]] void fail(const std::string& what) const {
    const std::string reason = std::strerror(errno);
    if (file_ >= 0) ::unlink(name_.c_str());
    throw Error(ErrorCode::BadFile, what + " (" + reason + ")", {target_.string(), 0, 0});
  }

  std::filesystem::path target_;
  std::string name_;
  int file_;
  bool renamed_ = false;
};

/// Pipes and devices cannot be replaced; they are written to.
void write_stream(const std::filesystem::path& file, std::string_view content) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  if (!stream.flush()) throw Error(ErrorCode::BadFile, "cannot write", {file.string(), 0, 0});
}

}  // namespace

void write_file(const std::filesystem::path& file, std::string_view content) {
  namespace fs = std::filesystem;
  if (fs::is_directory(file)) {
    throw Error(ErrorCode::BadFile, "cannot write a file: a directory has this name",
                {file.string(), 0, 0});
  }
  if (fs::exists(file) && !fs::is_regular_file(file)) {
    write_stream(file, content);
    return;
  }
  // A link stays a link: the file that it names is replaced.
  Temporary temporary(fs::exists(file) ? fs::canonical(file) : file);
  temporary.write(content);
  temporary.rename();
}

}  // namespace plumbline
