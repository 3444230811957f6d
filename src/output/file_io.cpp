#include "output/file_io.hpp"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace moat {
namespace {

using Pieces = std::span<const std::string_view>;
using Write = std::function<bool(int file)>;  // as write_all()

constexpr int permissions = 0666;  // less the umask

[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int reason) {
  throw FileError{path.string() + ": " + what + " (" + std::strerror(reason) +
                  "). Check that the folder exists, may be written to, and that the disk is not full."};
}

/// False with errno set where not everything could be written.
bool write_all(int file, Pieces pieces) {
  constexpr std::size_t most_at_once = 1024;  // of the kernel
  std::vector<iovec> parts;
  parts.reserve(pieces.size());
  for (const std::string_view piece : pieces)
    // writev does not change its input.
    if (!piece.empty()) parts.push_back({const_cast<char*>(piece.data()), piece.size()});
  for (std::size_t first = 0; first < parts.size();) {
    const auto written = writev(file, &parts[first], static_cast<int>(std::min(most_at_once, parts.size() - first)));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    // One call may write less than it is given.
    auto rest = static_cast<std::size_t>(written);
    while (first < parts.size() && rest >= parts[first].iov_len) rest -= parts[first++].iov_len;
    if (rest == 0) continue;
    parts[first].iov_base = static_cast<char*>(parts[first].iov_base) + rest;
    parts[first].iov_len -= rest;
  }
  return true;
}

/// Writes and closes the file that is open at `place`; removes it where that fails, with an error about `path`.
void fill(int file, const std::string& place, const Write& write, const std::filesystem::path& path) {
  const bool written = write(file);
  const int write_error = errno;
  // A full disk may show only at the end.
  const bool closed = close(file) == 0;
  if (written && closed) return;
  const int reason = written ? errno : write_error;
  std::remove(place.c_str());
  fail(path, "cannot be written completely", reason);
}

void replace_file(const std::filesystem::path& path, const Write& write) {
  const std::string unfinished = path.string() + ".unfinished-" + std::to_string(getpid());
  const int file = open(unfinished.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, permissions);
  if (file < 0) fail(path, "cannot be created", errno);
  fill(file, unfinished, write, path);
  if (std::rename(unfinished.c_str(), path.c_str()) == 0) return;
  const int reason = errno;
  std::remove(unfinished.c_str());
  fail(path, "cannot be put in its place", reason);
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view contents) {
  write_file(path, Pieces{&contents, 1});
}

void write_file(const std::filesystem::path& path, Pieces pieces) {
  replace_file(path, [&](int file) { return write_all(file, pieces); });
}

void write_file(const std::filesystem::path& path, const std::function<std::string_view()>& more) {
  replace_file(path, [&](int file) {
    std::string_view piece = more();
    while (!piece.empty() && write_all(file, Pieces{&piece, 1})) piece = more();
    return piece.empty();
  });
}

void write_unlisted_file(const std::filesystem::path& path, Pieces pieces) {
  const auto create = [&] { return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions); };
  int file = create();
  if (file < 0 && errno == EEXIST && unlink(path.c_str()) == 0) file = create();
  if (file < 0) fail(path, "cannot be created", errno);
  fill(
      file, path.string(), [&](int opened) { return write_all(opened, pieces); }, path);
}

}  // namespace moat
