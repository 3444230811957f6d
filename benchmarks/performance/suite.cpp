#include <cmath>
#include <ctime>
#include <filesystem>
#include <moat.hpp>

#include "measuring/measure.hpp"
#include "paper/paper_building.hpp"
#include "paper/records.hpp"
#include "performance/sections.hpp"

namespace moat::performance {

using namespace units;

namespace {

/// With a file that keeps its cases.
StudyResult study(const std::vector<GroundMotion>& motions, int gaps, int threads, const Integrator& integrator) {
  const StudyCases cases{{.name = "gap", .unit = "cm", .values = linearly_spaced(10, 50, gaps)},
                         StudyAxis::of_names("record", paper::record_labels())};
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "moat_benchmark_suite";
  std::filesystem::remove_all(folder);
  StudyStore store{folder / "study.db", cases, {}, {}};
  return run_study(cases,
                   [&](const StudyCase& each) {
                     StudyModel one{Model{}, motions[each.position("record")]};
                     paper::add_pounding(one.model, {}, each.value("gap") * cm);
                     return one;
                   },
                   {.threads = threads, .transient = {.integrator = integrator}, .store = &store});
}

/// CPU time of the analyses alone, with their peaks, s.
double analyses(const std::vector<GroundMotion>& motions, int gaps) {
  double taken = 0.0;
  for (const double gap : linearly_spaced(10, 50, gaps))
    for (const GroundMotion& motion : motions) {
      Model model;
      paper::add_pounding(model, {}, gap * cm);
      const double start = seconds();
      Transient transient{model, motion};
      PeakRecorder peaks{model};
      transient.attach(peaks);
      transient.run();
      static_cast<void>(peaks.peaks());
      taken += seconds() - start;
    }
  return taken;
}

/// CPU time of all threads of the process, s.
double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// In every bit, and where a result is missing in both.
bool equal(const StudyResult& a, const StudyResult& b) {
  for (std::size_t column = 0; column < a.table().columns.size(); ++column) {
    const auto &left = a.table().columns[column].values, &right = b.table().columns[column].values;
    for (std::size_t row = 0; row < left.size(); ++row)
      if (left[row] != right[row] && !(std::isnan(left[row]) && std::isnan(right[row]))) return false;
  }
  return a.table().columns.size() == b.table().columns.size();
}

}  // namespace

void suite(Record& record, const Options& options) {
  record.section("suite");
  if (const std::string missing = paper::missing_records(); !missing.empty()) return record.note(missing);
  const std::vector<GroundMotion> motions = paper::scaled_records();
  const int gaps = options.quick ? 6 : 41;
  const auto histories = static_cast<double>(gaps * 4);
  std::vector<double> one, two, per_second, per_second_automatic, work_on_one, work_on_two, alone;
  bool same = true;
  // Wall clock: waiting counts for the gain of a second core, too. CPU time separates work that two threads make slower
  // from other programs on the machine.
  for (int round = -1; round < options.rounds; ++round) {
    double start = seconds(Clock::wall), work = process_seconds();
    const StudyResult on_one = study(motions, gaps, 1, Newmark{});
    const double taken_by_one = seconds(Clock::wall) - start, work_by_one = process_seconds() - work;
    start = seconds(Clock::wall);
    work = process_seconds();
    const StudyResult on_two = study(motions, gaps, 2, Newmark{});
    const double taken_by_two = seconds(Clock::wall) - start, work_by_two = process_seconds() - work;
    work = process_seconds();
    study(motions, gaps, 1, Automatic{});
    const double work_by_automatic = process_seconds() - work;
    const double work_of_analyses = analyses(motions, gaps);
    same = same && equal(on_one, on_two);
    if (round < 0) continue;
    one.push_back(taken_by_one);
    two.push_back(2.0 * taken_by_two);
    work_on_one.push_back(work_by_one);
    alone.push_back(work_of_analyses);
    work_on_two.push_back(work_by_two);
    per_second.push_back(histories / work_by_one);
    per_second_automatic.push_back(histories / work_by_automatic);
  }
  Table table{{"Study of " + std::to_string(gaps) + " gaps x 4 motions", "Measured", "Target"}};
  const auto show = [&](const std::string& name, const Spread& value, std::optional<Target> target = {}) {
    table.put(name, "Measured", cell(record.add({"suite, " + name, value, "", target})));
    if (target) table.put(name, "Target", text(*target));
  };
  show("histories per second on one core", spread_of(per_second));
  show("histories per second on one core, integrator chosen automatically", spread_of(per_second_automatic));
  show("time on 1 thread over 2 x time on 2 threads", ratio_of(one, two), Target{0.9, false});
  show("CPU time of a case, with model and file, over its analysis with peaks alone", ratio_of(work_on_one, alone),
       Target{1.3, true});
  show("CPU time on 1 thread over CPU time on 2 threads", ratio_of(work_on_one, work_on_two));
  show("results of 1 and 2 threads equal in every bit (1 = yes)", single(same ? 1.0 : 0.0), Target{1.0, false});
  record.table(table);
}

}  // namespace moat::performance
