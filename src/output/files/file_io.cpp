#include "output/files/file_io.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "base/error.hpp"

namespace moat {
namespace {

using Write = std::function<bool(int file)>;  // as write_all()

constexpr int permissions = 0666;  // less the umask

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int reason) {
  throw FileError{path.string() + ": " + what + " (" + std::strerror(reason) +
                  "). Check that the folder exists, may be written to, and that the disk is not full."};
}

/// False with errno set where not everything could be written.
bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const auto written = write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    // One call may write less than it is given.
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void replace_file(const std::filesystem::path& path, const Write& write) {
  write_file(path, [&](const std::string& unfinished) {
    const int file = open(unfinished.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, permissions);
    if (file < 0) fail(path, "cannot be created", errno);
    int reason = 0;
    try {
      reason = write(file) ? 0 : errno;
    } catch (...) {
      close(file);
      throw;
    }
    // A full disk may show only at the end.
    return close(file) != 0 && reason == 0 ? errno : reason;
  });
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view contents) {
  replace_file(path, [&](int file) { return write_all(file, contents); });
}

void write_file(const std::filesystem::path& path, const std::function<std::string_view()>& more) {
  replace_file(path, [&](int file) {
    std::string_view piece = more();
    while (!piece.empty() && write_all(file, piece)) piece = more();
    return piece.empty();
  });
}

void write_file(const std::filesystem::path& path, const std::function<int(const std::string&)>& write) {
  const std::string unfinished = path.string() + ".unfinished-" + std::to_string(getpid());
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

}  // namespace moat
