#include "base/files_read.hpp"

#include <algorithm>
#include <map>
#include <mutex>

namespace moat {
namespace {

thread_local FilesOfThisThread* innermost = nullptr;

struct FilesOfTheProgram {
  std::mutex mutex;
  std::map<std::string, std::string> sha256_of_path;
};

FilesOfTheProgram& files_of_the_program() {
  static FilesOfTheProgram files;
  return files;
}

}  // namespace

FilesOfThisThread::FilesOfThisThread() : outer_{innermost} { innermost = this; }
FilesOfThisThread::~FilesOfThisThread() { innermost = outer_; }

void note_file_read(const FileRead& file) {
  if (innermost != nullptr) {
    std::vector<FileRead>& files = innermost->files_;
    if (std::ranges::find(files, file) == files.end()) files.push_back(file);
    return;
  }
  FilesOfTheProgram& all = files_of_the_program();
  const std::lock_guard lock{all.mutex};
  all.sha256_of_path[file.path] = file.sha256;
}

std::vector<FileRead> files_read_by_program() {
  FilesOfTheProgram& all = files_of_the_program();
  const std::lock_guard lock{all.mutex};
  std::vector<FileRead> list;
  for (const auto& [path, sha256] : all.sha256_of_path) list.push_back({path, sha256});
  return list;
}

}  // namespace moat
