// The files that a program has read.
#pragma once

#include <string>
#include <vector>

namespace moat {

/// A file as it was read.
struct FileRead {
  std::string path{};    ///< absolute; empty for data made in the program
  std::string sha256{};  ///< of its content: 64 hexadecimal digits

  friend bool operator==(const FileRead&, const FileRead&) = default;
};

/// Readers of files call it, from any thread.
void note_file_read(const FileRead& file);

/// The files read so far outside of any FilesOfThisThread, in the order of their paths; of a file that was read twice
/// the content read last.
std::vector<FileRead> files_read_by_program();

/// Keeps the files that this thread reads while it lives, so that each case of a study knows its own. One may live
/// inside another; the inner one then has the files.
class FilesOfThisThread {
 public:
  FilesOfThisThread();
  ~FilesOfThisThread();
  FilesOfThisThread(const FilesOfThisThread&) = delete;
  FilesOfThisThread& operator=(const FilesOfThisThread&) = delete;

  /// In the order in which they were first read.
  [[nodiscard]] const std::vector<FileRead>& files() const { return files_; }

 private:
  friend void note_file_read(const FileRead& file);

  std::vector<FileRead> files_;
  FilesOfThisThread* outer_;
};

}  // namespace moat
