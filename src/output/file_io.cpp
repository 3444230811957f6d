#include "output/file_io.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/error.hpp"

namespace moat {

void write_file(const std::filesystem::path& path, std::string_view contents) {
  const auto fail = [&path](const char* what) {
    throw FileError{path.string() + ": " + what + " (" + std::strerror(errno) +
                    "). Check that the folder exists, may be written to, and that the disk is not full."};
  };
  errno = 0;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) fail("cannot be created");
  const bool written = std::fwrite(contents.data(), 1, contents.size(), file) == contents.size();
  const int write_error = errno;
  // A full disk may show only when the buffer is flushed.
  const bool closed = std::fclose(file) == 0;
  if (!written) errno = write_error;
  if (!written || !closed) fail("cannot be written completely");
}

}  // namespace moat
