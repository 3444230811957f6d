// The studies of a script: their options, their folder, and what they print.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analyses/study.hpp"
#include "app/command_line.hpp"
#include "app/json_output.hpp"
#include "output/provenance.hpp"
#include "study/study_report.hpp"

namespace moat {

/// Options of a script with studies.
struct ScriptStudyOptions {
  std::filesystem::path folder;
  int threads = 0;
  bool quiet = false, retry = false;
  std::optional<std::pair<std::size_t, std::size_t>> part;
};

/// Runs the studies of one script in one folder, and keeps what its report will show.
class ScriptStudy {
 public:
  /// Adds the options to the line. json: where the result goes too, or null. Throws InputError for a text that cannot
  /// be.
  ScriptStudy(CommandLine& line, Ranks* ranks, const JsonOutput* json);

  /// Computes the cases that the file of the study lacks. Ends the program where the study is stopped by a signal, and
  /// after the part that --case or --cases asks for.
  StudyResult run(const StudyCases& cases, const std::function<StudyResult(const StudyOptions&)>& compute,
                  StudyOptions options, const std::string& name, const Provenance& origin, const std::string& title);

  /// For the report; a sentence is printed too.
  void answer(const std::string& sentence);
  void show(StudyPicture picture) { report_.pictures.push_back(std::move(picture)); }

  /// Writes the report and prints where it is.
  int finish(const Provenance& origin, const std::string& title);

  [[nodiscard]] const ScriptStudyOptions& options() const { return options_; }

 private:
  [[nodiscard]] StudyIdentity identity(const Provenance& origin) const;
  [[nodiscard]] std::string engine(const StudyOptions& options) const;
  static void print_failures(const StudyResult& result, const std::string& name);
  void write_json(const std::string& title) const;
  [[noreturn]] void end_of_part(const StudyResult& result, const std::filesystem::path& file,
                                const std::string& name) const;

  [[nodiscard]] bool speaks() const { return ranks_ == nullptr || ranks_->rank() == 0; }

  CommandLine* line_;
  Ranks* ranks_;
  const JsonOutput* json_;
  ScriptStudyOptions options_;
  StudyReport report_;
};

}  // namespace moat
