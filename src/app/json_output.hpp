// Standard output for one JSON text alone.
#pragma once

#include <filesystem>
#include <string>

#include "study/study_report.hpp"

namespace moat {

/// As long as it lives, all that the program prints goes to standard error, also by std::printf and by libraries, and
/// standard output is kept for write().
class JsonOutput {
 public:
  /// Throws FileError where standard output cannot be used.
  JsonOutput();
  ~JsonOutput();
  JsonOutput(const JsonOutput&) = delete;
  JsonOutput& operator=(const JsonOutput&) = delete;

  /// Throws FileError where standard output cannot be written.
  void write(const std::string& text) const;

 private:
  int standard_output_;
};

/// The studies in a folder, how far they are, and their answers: the text that Script::finish() describes.
std::string json_of(const StudyReport& report, const std::filesystem::path& folder);

/// summary.json of a folder of results, with the folder in front of its other members: "results_folder".
std::string summary_with_folder(const std::filesystem::path& folder);

}  // namespace moat
