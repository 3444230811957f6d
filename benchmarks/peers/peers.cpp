// moat beside OpenSees on the same models, in turns. Called by ./moat bench peers.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <moat.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/command_line.hpp"
#include "measuring/measure.hpp"
#include "measuring/record.hpp"
#include "measuring/street.hpp"
#include "output/peaks/peak_recorder.hpp"
#include "peers/building.hpp"
#include "peers/ladders.hpp"
#include "peers/opensees.hpp"

namespace moat::peers {
namespace {

using namespace units;
using performance::Figure;
using performance::Peaks;

NodeId node_named(const Model& model, const std::string& name) {
  for (int i = 0; i < model.degrees_of_freedom(); ++i)
    if (model.node_name(NodeId{i}) == name) return NodeId{i};
  throw InputError{"The model has no node " + name + "."};
}

History moat_history(const Case& of, TransientOptions options) {
  options.end = of.end * s;
  AnalysisState at_start = of.start(of.model);
  const double start = performance::seconds();
  Transient analysis{of.model, of.motion, std::move(at_start), options};
  PeakRecorder recorder{of.model};
  analysis.attach(recorder);
  analysis.run();
  History history{{}, performance::seconds() - start};
  const std::string base{of.model.node_name(of.base)}, top{of.model.node_name(of.top)};
  for (const Peak& peak : recorder.peaks()) {
    const bool of_base = peak.where == base, of_top = peak.where == top;
    if (peak.quantity == "displacement" && (of_base || of_top)) history.peaks[of_base ? 0 : 1] = peak.magnitude();
    if (peak.quantity == "absolute_acceleration" && (of_base || of_top))
      history.peaks[of_base ? 2 : 3] = peak.magnitude();
    if (peak.quantity == "impact_force") history.peaks[4] = std::max(history.peaks[4], peak.magnitude());
  }
  return history;
}

// Contacts are divided in step with the tolerance.
Ladder moat_ladder(const Case& of, const std::string& name, Integrator integrator) {
  Ladder ladder{name, {}};
  for (const int steps : {4, 6, 8, 11, 16, 23, 32, 45, 64})
    ladder.settings.push_back(
        {std::to_string(steps) + " steps per contact", [&of, integrator, steps] {
           const double tolerance = std::min(0.12 / (static_cast<double>(steps) * steps), 1e-2);
           return moat_history(of, {.integrator = integrator, .tolerance = tolerance, .steps_per_contact = steps});
         }});
  return ladder;
}

struct Options {
  std::filesystem::path records, folder = "results/peers";
  int rounds = 9;
};

std::vector<Case> buildings(const Options& options) {
  std::vector<Case> cases;
  for (const auto& [name, motion] : motions(!options.records.empty())) {
    cases.push_back(
        five_storeys(name + ", linear contact", LinearElastic{.stiffness = paper::linear_impact_stiffness}, motion));
    cases.push_back(five_storeys(name + ", Hertz-damp contact", hertz_damp(), motion));
  }
  return cases;
}

void compare_buildings(performance::Record& record, const OpenSees& opensees, const Options& options) {
  record.section("peers-building");
  constexpr double error = 1e-3;
  const std::vector<Case> cases = buildings(options);
  std::vector<std::string> header{"CPU time in ms for an error of 0.1 %"};
  for (const Case& each : cases) header.push_back(each.name);
  performance::Table table{header};
  for (const Case& each : cases) {
    std::vector<Ladder> ladders{moat_ladder(each, "moat adaptive", Newmark{}),
                                moat_ladder(each, "moat --integrator automatic", Automatic{})};
    for (const OpenSeesSetting& setting : opensees_settings())
      ladders.push_back(opensees_ladder("OpenSees, " + setting.description, opensees, each, setting));
    const Peaks reference = moat_history(each, {.tolerance = 1e-8, .steps_per_contact = 2048}).peaks;
    const std::vector<Cost> found = costs(ladders, reference, error, options.rounds);
    const Cost& first = found.front();
    for (const Cost& cost : found) {
      if (cost.seconds.empty()) {
        record.note(each.name + ", " + cost.name + ": no setting that was tried is as exact as 0.1 %.");
        continue;
      }
      const Figure& figure = record.add(
          {each.name + ", " + cost.name, performance::scaled(performance::spread_of(cost.seconds), 1e3), "ms"});
      table.put(cost.name, each.name, performance::cell(figure));
      if (&cost == &first || first.seconds.empty()) continue;
      const Figure& ratio = record.add(
          {each.name + ", " + cost.name + " / " + first.name, performance::ratio_of(cost.seconds, first.seconds)});
      table.put("ratio of " + cost.name + " to " + first.name, each.name, performance::cell(ratio));
    }
  }
  record.table(table);
}

void compare_streets(performance::Record& record, const OpenSees& opensees, const Options& options) {
  record.section("peers-street");
  constexpr double end = 1.0, step = 0.0025;  // s
  performance::Table table{
      {"CPU time in s for one second of a street", "600 DOF", "600 DOF, error", "6,000 DOF", "6,000 DOF, error"}};
  for (const int buildings : {100, 1000}) {
    const std::string size = buildings == 100 ? "600 DOF" : "6,000 DOF", middle = std::to_string(buildings / 2) + " ";
    Model model = performance::street(buildings);
    const NodeId base = node_named(model, middle + "base"), top = node_named(model, middle + "floor 5");
    const Case street{
        size, std::move(model), base, top, performance::street_motion(), end, performance::street_at_start};
    const Peaks reference = moat_history(street, {.tolerance = 1e-6, .steps_per_contact = 256}).peaks;
    std::vector<Ladder> all{{"moat, default", {{"", [&street] { return moat_history(street, {}); }}}}};
    for (const OpenSeesSetting& setting : opensees_settings())
      all.push_back({"OpenSees, " + setting.description + ", steps of 2.5 ms",
                     {{"", [&, setting] { return opensees_history(opensees, street, setting, step); }}}});
    std::vector<std::vector<double>> seconds(all.size());
    std::vector<double> errors(all.size());
    for (int round = -1; round < options.rounds; ++round)
      for (std::size_t i = 0; i < all.size(); ++i) {
        const History history = all[i].settings.front().run();
        errors[i] = performance::largest_error(history.peaks, reference);
        if (round >= 0) seconds[i].push_back(history.seconds);
      }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Figure& figure = record.add({size + ", " + all[i].name, performance::spread_of(seconds[i]), "s"});
      table.put(all[i].name, size, performance::cell(figure));
      const Figure& error = record.add(
          {size + ", " + all[i].name + ", largest error of five peaks", performance::single(100.0 * errors[i]), "%"});
      table.put(all[i].name, size + ", error", performance::cell(error) + " %");
    }
  }
  record.table(table);
}

int run(const Options& options, bool write_docs) {
  const std::optional<OpenSees> opensees = OpenSees::find(options.folder);
  if (!opensees) {
    std::puts(
        "OpenSees is not installed: nothing was compared. Put its Tcl interpreter on the path as `OpenSees`, or give\n"
        "its path: OPENSEES=/opt/opensees/bin/OpenSees ./moat bench peers");
    return 0;
  }
  if (write_docs && options.records.empty())
    throw InputError{"--write-docs needs the recorded motions (MOAT_RECORDS)."};
  performance::Record record;
  compare_buildings(record, *opensees, options);
  compare_streets(record, *opensees, options);
  record.write(options.folder);
  if (write_docs) record.write_documentation(MOAT_PERFORMANCE_DOCUMENT);
  std::printf("\nNumbers: %s\n", options.folder.c_str());
  return 0;
}

}  // namespace
}  // namespace moat::peers

int main(int argc, char** argv) {
  CLI::App app{"moat beside OpenSees on the same models, in turns", "moat bench peers"};
  app.footer(
      "OpenSees is the program that OPENSEES names, else `OpenSees` on the path. It is given moat's own models,\n"
      "written in Tcl, and the steps that benchmarks/peers/history.tcl describes. Without it nothing is compared.");
  moat::peers::Options options;
  bool write_docs = false;
  app.add_option("--out", options.folder, "folder for the figures and OpenSees' files")->capture_default_str();
  app.add_option("--rounds", options.rounds, "interleaved rounds whose median counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_flag("--write-docs", write_docs, "also bring docs/performance.md up to date");
  return moat::run_command(app, "moat bench peers", argc, argv, [&] {
    if (const char* records = std::getenv("MOAT_RECORDS")) options.records = records;
    return moat::peers::run(options, write_docs);
  });
}
