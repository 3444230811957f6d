// The studies of a script: their folder, and their output.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analyses/questions/study.hpp"
#include "app/command_line.hpp"
#include "app/json_output.hpp"
#include "app/script/script_study_options.hpp"
#include "design/design_sheet.hpp"
#include "output/files/provenance.hpp"
#include "study/study_report.hpp"

namespace moat {

/// Runs the studies of one script in one folder, and keeps the contents of its report.
class ScriptStudy {
 public:
  /// Adds the options to the line. json: where the result goes too, or null. Throws InputError for a text that cannot
  /// be.
  ScriptStudy(CommandLine& line, Ranks* ranks, const JsonOutput* json);

  /// Computes the cases that the file of the study lacks, and writes table and report. Ends the program where the study
  /// is stopped by a signal, and after the part that --case or --cases asks for. Throws InputError for a name that is
  /// taken or is no name of a file.
  StudyResult run(const StudyCases& cases, const std::function<StudyResult(const StudyOptions&)>& compute,
                  StudyOptions options, const std::string& name, const Provenance& origin, const std::string& title);

  /// For the report; a sentence is printed too.
  void answer(const std::string& sentence);
  void show(StudyPicture picture) { report_.pictures.push_back(std::move(picture)); }
  void show(StudyTable table) { report_.tables.push_back(std::move(table)); }
  /// Adds the profiles of the last study, whose models are like this one.
  void add_profiles(const Model& like);
  /// Adds charts to the last study.
  void add_charts(const std::vector<Chart>& charts);

  /// Writes the sheets, and the report with the answers and their verdicts, and prints where it is.
  int finish(const std::vector<DesignSheet>& sheets);

 private:
  void check_name(const std::string& name) const;
  void choose_part(const StudyCases& cases);
  [[nodiscard]] StudySession session(const Provenance& origin, const std::string& title, int threads) const;
  void keep(const StudyResult& result, const std::string& name);
  void write_json() const;
  [[noreturn]] void end_of_part(const StudyResult& result, const std::filesystem::path& file,
                                const std::string& name) const;
  [[noreturn]] void end_at_stop(const StudyStopped& stopped, const std::filesystem::path& file,
                                const std::string& name);

  [[nodiscard]] bool speaks() const { return ranks_ == nullptr || ranks_->rank() == 0; }

  CommandLine* line_;
  Ranks* ranks_;
  const JsonOutput* json_;
  ScriptStudyOptions options_;
  StudyReport report_;
};

}  // namespace moat
