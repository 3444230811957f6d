#include "output/file_io.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "base/error.hpp"

namespace moat {

void write_file(const std::filesystem::path& path, std::string_view contents) {
  std::filesystem::path unfinished = path;
  unfinished += ".unfinished-" + std::to_string(getpid());
  const auto fail = [&](const char* what) {
    const int reason = errno;
    std::remove(unfinished.c_str());
    throw FileError{path.string() + ": " + what + " (" + std::strerror(reason) +
                    "). Check that the folder exists, may be written to, and that the disk is not full."};
  };
  errno = 0;
  std::FILE* file = std::fopen(unfinished.c_str(), "wb");
  if (file == nullptr) fail("cannot be created");
  const bool written = std::fwrite(contents.data(), 1, contents.size(), file) == contents.size();
  const int write_error = errno;
  // A full disk may show only when the buffer is flushed.
  const bool closed = std::fclose(file) == 0;
  if (!written) errno = write_error;
  if (!written || !closed) fail("cannot be written completely");
  if (std::rename(unfinished.c_str(), path.c_str()) != 0) fail("cannot be put in its place");
}

}  // namespace moat
