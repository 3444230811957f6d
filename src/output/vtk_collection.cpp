#include "output/vtk_collection.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>

#include "base/error.hpp"
#include "output/file_io.hpp"

namespace moat {
namespace {

constexpr std::string_view start =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
    "byte_order=\"LittleEndian\">\n<Collection>\n";
constexpr std::string_view finish = "</Collection>\n</VTKFile>\n";

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw FileError{path.string() + ": cannot be written (" + std::strerror(errno) +
                  "). Check the folder's rights and the disk space."};
}

}  // namespace

VtkCollection::VtkCollection(const std::filesystem::path& path) : path_{path}, end_{start.size()} {
  write_file(path, std::string{start}.append(finish));
  file_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file_ < 0) fail(path_);
}

VtkCollection::~VtkCollection() { close(file_); }

void VtkCollection::append(double time, std::string_view file_name) {
  std::array<char, 32> digits;
  const auto digits_end = std::to_chars(digits.data(), digits.data() + digits.size(), time).ptr;
  std::string entry = "<DataSet timestep=\"" + std::string(digits.data(), digits_end) + "\" part=\"0\" file=\"";
  entry.append(file_name).append("\"/>\n");
  const std::size_t length = entry.size();
  // Over the closing tags together with new ones, in a single write.
  entry += finish;
  if (pwrite(file_, entry.data(), entry.size(), static_cast<off_t>(end_)) != static_cast<ssize_t>(entry.size())) {
    const int error = errno;
    // The disk may be full. The list without the entry is readable again; these bytes have their place already.
    const bool restored =
        pwrite(file_, finish.data(), finish.size(), static_cast<off_t>(end_)) == static_cast<ssize_t>(finish.size()) &&
        ftruncate(file_, static_cast<off_t>(end_ + finish.size())) == 0;
    static_cast<void>(restored);
    errno = error;
    fail(path_);
  }
  end_ += length;
}

}  // namespace moat
