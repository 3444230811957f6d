// moat beside OpenSees on the same models, in turns. Called by ./moat bench peers.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <moat.hpp>
#include <string>
#include <vector>

#include "measuring/error_curve.hpp"
#include "measuring/five_peaks.hpp"
#include "measuring/measure.hpp"
#include "measuring/record.hpp"
#include "measuring/street.hpp"
#include "output/peak_recorder.hpp"
#include "paper/paper_building.hpp"
#include "peers/opensees.hpp"

namespace moat::peers {
namespace {

using namespace units;
using performance::CurvePoint;
using performance::Figure;
using performance::Peaks;
using performance::ReadOff;
using performance::Spread;

// A model with the nodes whose peaks are compared.
struct Case {
  std::string name;
  Model model;
  NodeId base, top;
  GroundMotion motion;
  double end;  // s
};

// One history: its five peaks and its CPU seconds.
struct History {
  Peaks peaks{};
  double seconds = 0.0;
};

// Settings of one program, from the loosest to the tightest.
struct Ladder {
  std::string name;
  std::vector<std::function<History()>> settings;
};

Model five_storeys(bool linear_contact) {
  Model model;
  const Building building =
      add(model, ShearBuilding{.storeys = 5,
                               .floor_mass = paper::floor_mass,
                               .storey_stiffness = 1 * GN / m,
                               .damping = RayleighDamping{.ratio = 0.05},
                               .base_mass = paper::base_mass,
                               .isolation = LeadRubberBearing{.yield_force = 1.93 * MN,
                                                              .yield_displacement = 1 * cm,
                                                              .post_yield_stiffness = 19.3 * MN / m}});
  if (linear_contact)
    add(model, Moat{.around = building.base,
                    .clearance = paper::paper_gap,
                    .law = LinearElastic{.stiffness = paper::linear_impact_stiffness}});
  else
    add(model, Moat{.around = building.base,
                    .clearance = paper::paper_gap,
                    .law = HertzDamp{.stiffness = paper::hertz_impact_stiffness, .restitution = paper::restitution}});
  return model;
}

NodeId node_named(const Model& model, const std::string& name) {
  for (int i = 0; i < model.node_count(); ++i)
    if (model.node_name(NodeId{i}) == name) return NodeId{i};
  throw InputError{"The model has no node " + name + "."};
}

// Balanced at the start of the motion, so that OpenSees starts with the same accelerations.
Case balanced(std::string name, Model model, const std::string& base, const std::string& top, GroundMotion motion,
              double end) {
  const Transient at_start{model, motion};
  const NodeId base_node = node_named(model, base), top_node = node_named(model, top);
  return {std::move(name), std::move(model), base_node, top_node, std::move(motion), end};
}

History moat_history(const Case& of, TransientOptions options) {
  options.end = of.end * s;
  Model model = of.model;
  const double start = performance::seconds();
  Transient analysis{model, of.motion, options};
  PeakRecorder recorder{model};
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
    ladder.settings.push_back([&of, integrator, steps] {
      const double tolerance = std::min(0.12 / (static_cast<double>(steps) * steps), 1e-2);
      return moat_history(of, {.integrator = integrator, .tolerance = tolerance, .steps_per_contact = steps});
    });
  return ladder;
}

// A history that OpenSees does not solve has no peaks, and the largest error.
History opensees_history(const OpenSees& opensees, const Case& of, const OpenSeesSetting& setting, double step) {
  const OpenSeesRun run = opensees.run(of.model, of.motion, step, of.end, setting, of.base, of.top);
  History history{{}, run.cpu_seconds};
  if (run.solved && run.peaks.size() == history.peaks.size()) std::ranges::copy(run.peaks, history.peaks.begin());
  return history;
}

Ladder opensees_ladder(const OpenSees& opensees, const Case& of, const OpenSeesSetting& setting) {
  Ladder ladder{"OpenSees, " + setting.description, {}};
  for (const int divisions : {1, 2, 3, 4, 5, 8, 12, 20})
    ladder.settings.push_back([&opensees, &of, setting, divisions] {
      return opensees_history(opensees, of, setting, of.motion.time_step() / divisions);
    });
  return ladder;
}

const std::vector<OpenSeesSetting>& settings() {
  static const std::vector<OpenSeesSetting> list{
      {"textbook", "Newmark, Newton, test on displacements"},
      {"force_test", "Newmark with beta = 1/6, Newton, test on forces"},
      {"explicit", "NewmarkExplicit, factored once"},
  };
  return list;
}

// Times of all rounds for an error, read off between two settings that run in turns with those of all other ladders.
class TimesInTurns {
 public:
  TimesInTurns(const std::vector<Ladder>& ladders, const Peaks& reference, double error) {
    for (const Ladder& ladder : ladders) {
      std::vector<CurvePoint> points;
      for (std::size_t i = 0; i < ladder.settings.size(); ++i) {
        const History history = ladder.settings[i]();
        points.push_back({i, performance::largest_error(history.peaks, reference), history.seconds});
      }
      if (const auto read = performance::read_off(points, error))
        found_.push_back({&ladder, *read, {}});
      else
        missing_.push_back(ladder.name);
    }
  }
  void run(int rounds) {
    for (int round = -1; round < rounds; ++round)  // the first warms up
      for (Found& each : found_) {
        const double looser = each.ladder->settings[each.read.looser]().seconds;
        const double tighter = each.ladder->settings[each.read.tighter]().seconds;
        if (round >= 0) each.seconds.push_back(each.read.time(looser, tighter));
      }
  }
  struct Found {
    const Ladder* ladder;
    ReadOff read;
    std::vector<double> seconds;
  };
  [[nodiscard]] const std::vector<Found>& found() const { return found_; }
  [[nodiscard]] const std::vector<std::string>& missing() const { return missing_; }

 private:
  std::vector<Found> found_;
  std::vector<std::string> missing_;
};

struct Options {
  std::filesystem::path records, folder = "results/peers";
  int rounds = 9;
};

std::vector<Case> buildings(const Options& options) {
  std::vector<std::pair<std::string, GroundMotion>> motions{{"pulse", near_fault_pulse()}};
  if (!options.records.empty())
    for (const auto& [name, file] :
         {std::pair{"GBZ000", "RSN1161_KOCAELI_GBZ000.AT2"}, std::pair{"JEN022", "RSN982_NORTHR_JEN022.AT2"}})
      motions.emplace_back(name, read_motion(options.records / file));
  std::vector<Case> cases;
  for (const auto& [name, motion] : motions)
    for (const bool linear_contact : {true, false}) {
      const GroundMotion scaled = motion.scaled_to_pga(0.4 * g);
      cases.push_back(balanced(name + (linear_contact ? ", linear contact" : ", Hertz-damp contact"),
                               five_storeys(linear_contact), "base", "floor 5", scaled, scaled.duration()));
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
    for (const OpenSeesSetting& setting : settings()) ladders.push_back(opensees_ladder(opensees, each, setting));
    const Peaks reference = moat_history(each, {.tolerance = 1e-8, .steps_per_contact = 2048}).peaks;
    TimesInTurns times{ladders, reference, error};
    times.run(options.rounds);
    for (const std::string& name : times.missing())
      record.note(each.name + ", " + name + ": no setting that was tried is as exact as 0.1 %.");
    const auto& found = times.found();
    for (const auto& one : found) {
      const Figure& figure = record.add(
          {each.name + ", " + one.ladder->name, performance::scaled(performance::spread_of(one.seconds), 1e3), "ms"});
      table.put(one.ladder->name, each.name, performance::cell(figure));
      if (&one == &found.front()) continue;
      const Figure& ratio = record.add({each.name + ", " + one.ladder->name + " / " + found.front().ladder->name,
                                        performance::ratio_of(one.seconds, found.front().seconds)});
      table.put("ratio of " + one.ladder->name + " to " + found.front().ladder->name, each.name,
                performance::cell(ratio));
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
    const Case street = balanced(size, performance::street(buildings), middle + "base", middle + "floor 5",
                                 performance::street_motion(), end);
    const Peaks reference = moat_history(street, {.tolerance = 1e-6, .steps_per_contact = 256}).peaks;
    std::vector<Ladder> all{{"moat, default", {[&street] { return moat_history(street, {}); }}}};
    for (const OpenSeesSetting& setting : settings())
      all.push_back({"OpenSees, " + setting.description + ", steps of 2.5 ms",
                     {[&, setting] { return opensees_history(opensees, street, setting, step); }}});
    std::vector<std::vector<double>> seconds(all.size());
    std::vector<double> errors(all.size());
    for (int round = -1; round < options.rounds; ++round)
      for (std::size_t i = 0; i < all.size(); ++i) {
        const History history = all[i].settings.front()();
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
  constexpr int exit_usage = 2;
  CLI::App app{"moat beside OpenSees on the same models, in turns"};
  app.name("./moat bench peers");
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  }
  try {
    if (const char* records = std::getenv("MOAT_RECORDS")) options.records = records;
    return moat::peers::run(options, write_docs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "moat: error: %s\n", error.what());
    return 1;
  }
}
