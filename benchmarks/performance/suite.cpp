#include "performance/suite.hpp"

#include <moat.hpp>

#include <cmath>
#include <ctime>

#include "paper/paper_building.hpp"
#include "paper/records.hpp"
#include "performance/measure.hpp"

namespace moat::performance {

using namespace units;

namespace {

struct Motions {
  std::vector<std::string> names;
  std::vector<GroundMotion> motions;
};

Motions four_pulses() {
  Motions list;
  for (const double period : {0.9, 1.3, 1.7, 2.1}) {
    list.names.push_back("pulse of " + to_text(period) + " s");
    list.motions.push_back(near_fault_pulse({.pulse_period = period * s}).scaled_to_pga(0.4 * g));
  }
  return list;
}

StudyResult study(const Motions& list, int gaps, int threads) {
  return run_study({{.name = "gap", .unit = "cm", .values = linearly_spaced(10, 50, gaps)},
                    StudyAxis::of_names("record", list.names)},
                   [&](const StudyCase& each) {
                     StudyModel one{Model{}, list.motions[each.position("record")]};
                     paper::add_pounding(one.model, {}, each.value("gap") * cm);
                     return one;
                   },
                   {.threads = threads});
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
  record.section("suite", "A suite: the study of the gap, 41 gaps x 4 motions");
  const std::string missing = paper::missing_records();
  const Motions list = missing.empty() ? Motions{paper::record_labels(), paper::scaled_records()} : four_pulses();
  if (!missing.empty())
    record.note("Four pulses of 0.9, 1.3, 1.7 and 2.1 s, about 20 s long each, stand in for the records. " + missing);

  const int gaps = options.quick ? 6 : 41;
  const auto histories = static_cast<double>(gaps * 4);
  std::vector<double> one, two, per_second, work_on_one, work_on_two;
  bool same = true;
  // Wall clock: what a second core brings is a matter of waiting, too. CPU time tells how much of a loss is work that
  // two threads make slower, and how much that something else ran on the machine.
  for (int round = -1; round < options.rounds; ++round) {
    double start = seconds(Clock::wall), work = process_seconds();
    const StudyResult on_one = study(list, gaps, 1);
    const double taken_by_one = seconds(Clock::wall) - start, work_by_one = process_seconds() - work;
    start = seconds(Clock::wall);
    work = process_seconds();
    const StudyResult on_two = study(list, gaps, 2);
    const double taken_by_two = seconds(Clock::wall) - start;
    const double work_by_two = process_seconds() - work;
    same = same && equal(on_one, on_two);
    if (round < 0) continue;
    one.push_back(taken_by_one);
    two.push_back(2.0 * taken_by_two);
    work_on_one.push_back(work_by_one);
    work_on_two.push_back(work_by_two);
    per_second.push_back(histories / work_by_one);
  }
  record.add({"suite, histories", single(histories), ""});
  record.add({"suite, histories per second on one core", spread_of(per_second), "1/s"});
  record.add({"suite, time on 1 thread over 2 x time on 2 threads", ratio_of(one, two), "", Target{0.9, false}});
  record.add({"suite, CPU time on 1 thread over CPU time on 2 threads", ratio_of(work_on_one, work_on_two), ""});
  record.add({"suite, results of 1 and 2 threads equal in every bit (1 = yes)", single(same ? 1.0 : 0.0), "",
              Target{1.0, false}});
}

}  // namespace moat::performance
