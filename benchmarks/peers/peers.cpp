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
#include "peers/bouc_wen.hpp"
#include "peers/building.hpp"
#include "peers/contest.hpp"
#include "peers/ladders.hpp"
#include "peers/moat_histories.hpp"
#include "peers/opensees.hpp"
#include "peers/pendulum.hpp"
#include "peers/plan.hpp"
#include "peers/rebound.hpp"

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

struct Options {
  std::filesystem::path records, folder = "results/peers";
  int rounds = 9;
  std::vector<std::string> only = {"building", "rebound", "models", "street"};
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

// The models of isolators and storeys, under the pulse and two records; in plan, where OpenSees is slowest, one.
std::vector<Case> models(const Options& options) {
  std::vector<Case> cases;
  for (const auto& [name, motion] : motions(!options.records.empty())) {
    if (name == "WVC270") continue;
    cases.push_back(on_pendulums(name + ", friction pendulums", motion));
    if (name == "pulse")
      cases.push_back(on_pendulums(name + ", the same by the base's acceleration too", motion, Compared::impacts));
    if (name != "GBZ000") cases.push_back(on_bearings_in_plan(name + ", LRB in plan", motion));
    cases.push_back(bouc_wen_storeys(name + ", Bouc-Wen storeys", motion));
  }
  return cases;
}

std::vector<Case> rebound_cases() {
  return {rebounds("rebound, Hertz-damp", hertz_damp()),
          rebounds("rebound, bilinear", BilinearImpact::from_stiffnesses(1 * GN / m, 0.25 * GN / m, 5 * mm))};
}

std::vector<Outcome> compare_streets(performance::Record& record, const OpenSees& opensees, const Options& options) {
  std::vector<Outcome> outcomes;
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
    Outcome& outcome = outcomes.emplace_back(Outcome{"street, " + size});
    outcome.textbook = performance::ratio_of(seconds[1], seconds[0]);
    std::size_t best = 1;
    for (std::size_t i = 2; i < all.size(); ++i)
      if (performance::spread_of(seconds[i]).median < performance::spread_of(seconds[best]).median) best = i;
    outcome.best = performance::ratio_of(seconds[best], seconds[0]);
    outcome.best_setting = opensees_settings()[best - 1].description;
    outcome.remark = "errors " + performance::short_text(100.0 * errors[best]) + " % and " +
                     performance::short_text(100.0 * errors[0]) + " %";
  }
  record.table(table);
  return outcomes;
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
  const char* commit = std::getenv("OPENSEES_COMMIT");
  const std::string version = "OpenSees " + opensees->version() + ", " +
                              (commit != nullptr ? std::string{"commit "} + commit : "commit unknown");
  std::printf("%s\n%s\n", version.c_str(), performance::machine().c_str());
  performance::Record record;
  std::vector<Outcome> outcomes;
  const auto append = [&](const std::vector<Outcome>& more) {
    outcomes.insert(outcomes.end(), more.begin(), more.end());
  };
  const auto asked = [&](const char* part) { return std::ranges::find(options.only, part) != options.only.end(); };
  if (asked("building"))
    append(compare(record, *opensees, buildings(options),
                   {.section = "peers-building", .rounds = options.rounds, .textbook = 35.0, .best = 10.0}));
  if (asked("rebound"))
    append(compare(record, *opensees, rebound_cases(),
                   {.section = "peers-rebound", .rounds = options.rounds, .finer = true}));
  if (asked("models"))
    append(compare(record, *opensees, models(options),
                   {.section = "peers-models", .rounds = options.rounds, .finer = true}));
  if (asked("street")) append(compare_streets(record, *opensees, options));
  summarise(record, outcomes);
  record.note(version + ".");
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
      "written in Tcl, and the steps that benchmarks/peers/history.tcl describes. OPENSEES_COMMIT names the commit it "
      "was\n"
      "built from. Without OpenSees nothing is compared.");
  moat::peers::Options options;
  bool write_docs = false;
  app.add_option("--out", options.folder, "folder for the figures and OpenSees' files")->capture_default_str();
  app.add_option("--rounds", options.rounds, "interleaved rounds whose median counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--only", options.only, "building, rebound, models, street: some of them")
      ->check(CLI::IsMember(moat::peers::Options{}.only));
  app.add_flag("--write-docs", write_docs, "also bring docs/performance.md up to date");
  return moat::run_command(app, "moat bench peers", argc, argv, [&] {
    if (const char* records = std::getenv("MOAT_RECORDS")) options.records = records;
    return moat::peers::run(options, write_docs);
  });
}
