// Helpers shared by the tests of src/output.
#pragma once

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <string>

#include "in_folder.hpp"
#include "message_of.hpp"

namespace moat::testing_output {

using testing::InFolder;
using testing::message_of;
using testing::read_file;

/// Null if the text is not well-formed XML.
inline vtkSmartPointer<vtkXMLDataElement> parse_xml(const std::string& text) {
  return vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(text.c_str()));
}

}  // namespace moat::testing_output
