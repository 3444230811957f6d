// A folder for the files of a test, and their texts.
#pragma once

#include <string>

#include "../support/in_folder.hpp"

namespace moat::paper {

class InFolder : public testing::InFolder {
 protected:
  [[nodiscard]] std::string text_of(const std::string& name) const { return testing::read_file(folder / name); }
};

}  // namespace moat::paper
