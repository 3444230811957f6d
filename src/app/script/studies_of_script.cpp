// The studies of an input script, and their answers.
#include <algorithm>
#include <string>

#include "analyses/case/case_run.hpp"
#include "analyses/questions/suite.hpp"
#include "app/script/script.hpp"
#include "app/script/script_parts.hpp"
#include "base/error.hpp"
#include "output/charts/suite_charts.hpp"
#include "report/charts/result_charts.hpp"
#include "study/statistics.hpp"

namespace moat {

ScriptStudy& Script::study_parts() {
  if (!parts_->study) parts_->study.emplace(parts_->line, parts_->ranks, parts_->json ? &*parts_->json : nullptr);
  check_options();
  return *parts_->study;
}

StudyResult Script::study(const StudyCases& cases, const std::function<StudyModel(const StudyCase&)>& make,
                          const StudyOptions& options, const std::string& name) {
  StudyResult result = study_parts().run(
      cases, [&](const StudyOptions& each) { return run_study(cases, make, each); }, options, name, parts_->origin,
      parts_->line.title());
  // A case that went well is taken: its model can be made.
  std::size_t done = 0;
  while (done < cases.count() && result.state(done) != CaseState::done) ++done;
  if (parts_->speaks() && !axis_of_records(result).empty() && done < cases.count())
    parts_->study->add_profiles(make(StudyCase{cases, done}).model);
  return result;
}

StudyResult Script::suite(const Suite& suite, const std::function<Model(const SuiteCase&)>& make,
                          const std::string& name) {
  const std::function<StudyModel(const StudyCase&)> model = [&](const StudyCase& each) {
    return suite.model(each, make);
  };
  StudyResult result = study(suite.cases(), model, suite.study(), name);
  // Cases of a study keep no histories: those of the loops are computed once more.
  if (parts_->speaks())
    for (const std::size_t number : cases_with_largest_deformation(result)) {
      const StudyCase each{result.cases(), number};
      const StudyModel widest = model(each);
      std::vector<Chart> loops = isolator_loops(run_case(
          widest.model, widest.motion, {.transient = suite.study().transient, .error_bars = ErrorBarMode::never}));
      for (Chart& loop : loops) loop.title += ", " + each.description();
      parts_->study->add_charts(loops);
    }
  if (const std::optional<ScaledSuite>& scaled = suite.records().scaled()) {
    std::string scaling;
    for (const std::string& line : scaled->description()) scaling += line + ". ";
    answer(scaling.substr(0, scaling.size() - 1));
    for (const std::string& warning : scaled->warnings) answer(warning);
    show("Scaling", scaling_table(*scaled));
    for (const Chart& chart : suite_charts(*scaled)) show(chart);
  }
  return result;
}

StudyResult Script::study(const StudyCases& cases, const std::function<StudyRecord(const StudyCase&)>& compute,
                          const StudyOptions& options, const std::string& name) {
  return study_parts().run(
      cases, [&](const StudyOptions& each) { return run_study(cases, compute, each); }, options, name, parts_->origin,
      parts_->line.title());
}

void Script::answer(const std::string& sentence) { studies_done().answer(sentence); }

void Script::show(const Chart& chart) {
  studies_done().show(StudyPicture{chart.title, svg_text({chart}, 1000, 420), table_of(chart)});
}

void Script::show(const std::string& title, const Table& table) { studies_done().show(StudyTable{title, table}); }

void Script::show(const HeatMap& map) { studies_done().show(StudyPicture{map.title, svg_text(map)}); }

ScriptStudy& Script::studies_done() {
  if (!parts_->study) throw InputError{"Script: answers and pictures belong to a study. Call study() before."};
  return *parts_->study;
}

int Script::finish() {
  if (parts_->study) return parts_->study->finish(parts_->sheets);
  check_options();
  return 0;
}

}  // namespace moat
