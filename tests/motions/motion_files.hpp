// Text files that a test writes for the readers of ground motions, and the messages it gets back.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "in_folder.hpp"
#include "message_of.hpp"

namespace moat {

class MotionFiles : public testing::InFolder {
 protected:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder / name; }

  [[nodiscard]] std::filesystem::path write(const std::string& name, std::string_view content) const {
    std::ofstream{path(name), std::ios::binary} << content;
    return path(name);
  }
};

using testing::message_of;

}  // namespace moat
