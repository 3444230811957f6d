// Text files that a test writes for readers.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "in_folder.hpp"

namespace moat::testing {

class WrittenFiles : public InFolder {
 protected:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder / name; }

  [[nodiscard]] std::filesystem::path write(const std::string& name, std::string_view content) const {
    std::ofstream{path(name), std::ios::binary} << content;
    return path(name);
  }
};

}  // namespace moat::testing
