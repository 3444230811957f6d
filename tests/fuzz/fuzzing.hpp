// Inputs of libFuzzer as files and texts, and the verdict on a reader.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace moat::fuzz {

/// Calls a reader. It may refuse its input by moat::Error; any other exception ends the program, and libFuzzer keeps
/// the input.
template <class Reader>
int tried(const Reader& reader) {
  try {
    reader();
  } catch (const Error&) {
  }
  return 0;
}

/// A folder of this process, in memory where the system offers that; removed at the end.
class Folder {
 public:
  Folder()
      : path_{std::filesystem::path{std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp"} /
              ("moat_fuzz_" + std::to_string(::getpid()))} {
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// Writes a file and returns its path.
  [[nodiscard]] std::filesystem::path file(const std::string& name, std::string_view content) const {
    std::ofstream{path_ / name, std::ios::binary} << content;
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Lines of this text separate the parts of an input that stands for several files.
inline constexpr std::string_view separator = "\n=====\n";

/// The first `count` parts of an input; missing ones are empty, and the last one is all the rest.
inline std::vector<std::string_view> parts_of(std::string_view text, std::size_t count) {
  std::vector<std::string_view> parts;
  while (parts.size() + 1 < count) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + separator.size());
  }
  parts.push_back(text);
  return parts;
}

}  // namespace moat::fuzz
