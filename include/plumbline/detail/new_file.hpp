#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "plumbline/error.hpp"

namespace plumbline {

/// A file that is whole or not there: its content goes to a temporary beside it, which `commit`
/// renames to it. A new file has the permissions that the umask leaves, one that is replaced keeps
/// its own (hard links to it keep the old content). A link stays a link: what it names is replaced.
/// Pipes and devices, which can't be replaced, are written to as they are.
class NewFile {
 public:
  /// Waits for nothing. Throws: Error BadFile, as the others.
  explicit NewFile(const std::filesystem::path& target);
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  /// Removes the temporary, unless it was renamed.
  ~NewFile();

  /// The name of the temporary, which no other file had; empty for pipes and devices.
  const std::string& temporary() const { return temporary_; }
  void write(std::string_view content);
  /// Waits until the content is on the disk, then puts it in place of the target.
  void commit();

 private:
  void create_beside(unsigned permissions);
  void open_stream();
  [[noreturn]] void fail(const std::string& what) const;

  std::filesystem::path target_;
  std::string temporary_;
  int file_ = -1;
};

/// Writes a file whole or not at all, as a NewFile. Throws: Error BadFile.
void write_file(const std::filesystem::path& file, std::string_view content);

}  // namespace plumbline
