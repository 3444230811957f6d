#include "output/files/file_io.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

#include "base/error.hpp"

namespace moat {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int reason) {
  throw FileError{path.string() + ": " + what + " (" + std::strerror(reason) +
                  "). Check that the folder exists, may be written to, and that the disk is not full."};
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view contents) {
  write_file(path, [&](std::ostream& file) { file << contents; });
}

void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  write_file(path, [&](const std::string& unfinished) {
    std::ofstream file{unfinished, std::ios::binary};
    if (!file) fail(path, "cannot be created", errno);
    write(file);
    // A full disk may show only at the end.
    file.close();
    return file ? 0 : errno;
  });
}

void write_file(const std::filesystem::path& path, const std::function<int(const std::string&)>& write) {
  const std::string unfinished = path.string() + unfinished_ending + std::to_string(getpid());
  int reason = 0;
  try {
    reason = write(unfinished);
  } catch (...) {
    std::remove(unfinished.c_str());
    throw;
  }
  const char* what = "cannot be written completely";
  if (reason == 0) {
    if (std::rename(unfinished.c_str(), path.c_str()) == 0) return;
    reason = errno;
    what = "cannot be put in its place";
  }
  std::remove(unfinished.c_str());
  fail(path, what, reason);
}

std::string file_name_of(std::string_view title) {
  constexpr std::size_t longest = 100;  // file systems take 255, with numbers and endings
  std::string name;
  for (const char c : title) {
    if (name.size() == longest) break;
    const bool upper = c >= 'A' && c <= 'Z';
    if (upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      name += upper ? static_cast<char>(c - 'A' + 'a') : c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  if (name.ends_with('_')) name.pop_back();
  return name.empty() ? "chart" : name;
}

}  // namespace moat
