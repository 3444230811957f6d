// Helpers shared by the tests of src/output.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "base/error.hpp"

namespace moat::testing_output {

/// A fresh folder per test, removed afterwards.
class InFolder : public ::testing::Test {
 protected:
  InFolder() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder = std::filesystem::temp_directory_path() /
             (std::string{"moat_"} + info->test_suite_name() + "_" + info->name() + "_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~InFolder() override { std::filesystem::remove_all(folder); }

  std::filesystem::path folder;
};

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// Null if the text is not well-formed XML.
inline vtkSmartPointer<vtkXMLDataElement> parse_xml(const std::string& text) {
  return vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(text.c_str()));
}

template <class Exception, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Exception& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace moat::testing_output
