#include "streets.hpp"

#include <moat.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "error_distribution.hpp"
#include "measuring/street.hpp"
#include "output/peaks/peak_recorder.hpp"
#include "output/recorders/impact_recorder.hpp"

namespace moat {
namespace {

using namespace units;

struct Run {
  std::vector<Peak> peaks;
  std::vector<Impact> impacts;
  SolverStatistics solver;
};

struct Street {
  int buildings;
  std::string law;  // of all gaps, by name
  Time end;
  Run located, at_end;
  double change_of_reference = 0.0;  // largest of a peak, relative
  std::vector<double> errors;        // of all peaks, relative, ascending
  std::vector<double> of_rebounds;   // errors of all impacts that end in both runs, ascending
};

Run run(const Street& street, TransientOptions options) {
  const Model model = performance::street(street.buildings, performance::street_law(street.law));
  options.end = street.end;
  PeakRecorder peaks{model};
  ImpactRecorder impacts;
  Transient analysis{model, performance::street_motion(), performance::street_at_start(model), options};
  analysis.attach(peaks);
  analysis.attach(impacts);
  analysis.run();
  return {peaks.peaks(), impacts.impacts(), analysis.statistics()};
}

// Relative errors of all peaks, ascending. Both runs list the same peaks in the same order.
std::vector<double> errors_of_peaks(const Run& run, const Run& truth) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < truth.peaks.size(); ++i)
    if (truth.peaks[i].value != 0.0)
      errors.push_back(std::abs(run.peaks[i].magnitude() / truth.peaks[i].magnitude() - 1.0));
  std::ranges::sort(errors);
  return errors;
}

using ImpactsOfGaps = std::map<std::string, std::vector<Impact>>;

ImpactsOfGaps by_gap(const Run& run) {
  ImpactsOfGaps of_gaps;
  for (const Impact& impact : run.impacts) of_gaps[impact.where].push_back(impact);
  return of_gaps;
}

double separation_speed(const Impact& impact) { return impact.rebound_ratio * impact.approach_speed; }

// Returns errors of separation speeds over the gap's largest approach speed, where impacts are as many in both runs.
std::vector<double> errors_of_rebounds(const Run& run, const Run& truth) {
  std::vector<double> errors;
  const ImpactsOfGaps found = by_gap(run);
  for (const auto& [gap, impacts] : by_gap(truth)) {
    const auto same = found.find(gap);
    if (same == found.end() || same->second.size() != impacts.size()) continue;
    const double fastest = std::ranges::max(impacts, {}, &Impact::approach_speed).approach_speed;
    for (std::size_t i = 0; i < impacts.size(); ++i) {
      const double error = std::abs(separation_speed(same->second[i]) - separation_speed(impacts[i])) / fastest;
      if (!std::isnan(error)) errors.push_back(error);
    }
  }
  std::ranges::sort(errors);
  return errors;
}

Street measure(int buildings, const std::string& law, Time end) {
  Street street{
      .buildings = buildings, .law = law, .end = end, .located = {}, .at_end = {}, .errors = {}, .of_rebounds = {}};
  TransientOptions tight{.tolerance = 1e-5, .steps_per_contact = 128};
  street.located = run(street, tight);
  tight.tolerance *= 0.1;
  tight.steps_per_contact *= 2;
  const Run tighter = run(street, tight);
  street.change_of_reference = errors_of_peaks(street.located, tighter).back();
  street.at_end = run(street, {.events = EventTreatment::at_end_of_step});
  street.errors = errors_of_peaks(street.at_end, street.located);
  street.of_rebounds = errors_of_rebounds(street.at_end, street.located);
  return street;
}

std::string whole(std::size_t number) { return std::to_string(number); }

// Returns the errors of every law that a name chooses.
std::string table_of_laws() {
  std::string table =
      "| law | impacts, located | at the end | error of a peak: 99th percentile | largest | of a rebound |\n"
      "|---|---|---|---|---|---|\n";
  for (const std::string& law : impact_law_names()) {
    const Street street = measure(200, law, 1 * s);
    table += "| `" + law + "` | " + whole(street.located.impacts.size()) + " | " + whole(street.at_end.impacts.size()) +
             " | " + percent(quantile(street.errors, 0.99)) + " | " + percent(street.errors.back()) + " | " +
             percent(street.of_rebounds.back()) + " |\n";
  }
  return table;
}

}  // namespace

std::string run_streets() {
  std::vector<Street> streets;
  for (const auto& [buildings, end] : {std::pair{10, 5 * s}, {100, 5 * s}, {1000, 2 * s}})
    streets.push_back(measure(buildings, "hertz_damp", end));
  std::string table = "| |", line = "|---|";
  for (const Street& street : streets) {
    table += " " + std::to_string(street.buildings) + " buildings |";
    line += "---|";
  }
  table += "\n" + line + "\n";
  const auto row = [&](const std::string& label, const std::function<std::string(const Street&)>& value) {
    table += "| " + label + " |";
    for (const Street& street : streets) table += " " + value(street) + " |";
    table += "\n";
  };
  using S = Street;
  row("seconds of motion", [](const S& s) { return to_text(s.end.si()); });
  row("steps, located", [](const S& s) { return std::to_string(s.located.solver.accepted_steps); });
  row("steps, at the end", [](const S& s) { return std::to_string(s.at_end.solver.accepted_steps); });
  row("impacts, located", [](const S& s) { return whole(s.located.impacts.size()); });
  row("impacts, at the end", [](const S& s) { return whole(s.at_end.impacts.size()); });
  row("peaks compared", [](const S& s) { return whole(s.errors.size()); });
  row("change of located peaks with a tenth of the tolerance",
      [](const S& s) { return percent(s.change_of_reference); });
  row("error of a peak: median", [](const S& s) { return percent(quantile(s.errors, 0.5)); });
  row("99th percentile", [](const S& s) { return percent(quantile(s.errors, 0.99)); });
  row("largest", [](const S& s) { return percent(s.errors.back()); });
  row("rebounds compared", [](const S& s) { return whole(s.of_rebounds.size()); });
  row("error of a rebound: median", [](const S& s) { return percent(quantile(s.of_rebounds, 0.5)); });
  row("99th percentile", [](const S& s) { return percent(quantile(s.of_rebounds, 0.99)); });
  row("largest", [](const S& s) { return percent(s.of_rebounds.back()); });
  return table + "\n200 buildings, 1 s of motion, every law of `NamedImpactLaw`:\n\n" + table_of_laws();
}

}  // namespace moat
