#include "performance/profile.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <moat.hpp>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "performance/command_output.hpp"
#include "performance/measure.hpp"
#include "performance/moat_five_storeys.hpp"
#include "performance/street_run.hpp"

namespace moat::performance {
namespace {

const std::string everything_else = "everything else";

// What a function of the program or a library is part of.
std::string item_of(const std::string& function) {
  static const std::pair<std::regex, std::string> items[] = {
      {std::regex{"ExactBetweenEvents|multiply"}, "exact steps"},
      {std::regex{"LinkBlock<.*::(evaluate|dissipat|stored)"}, "elements, evaluate"},
      {std::regex{"LinkBlock<.*::add_forces|internal_forces"}, "elements, sum up forces"},
      {std::regex{"LinkBlock<.*::add_tangent|assemble_tangent"}, "elements, assemble the tangent"},
      {std::regex{"LinkBlock<.*::(commit|account)|Model::commit"}, "elements, commit"},
      {std::regex{"scan_regimes|shortest_contact|scan_element"}, "elements, look for events"},
      {std::regex{"^klu_|Factor"}, "KLU, refactor and solve"},
      {std::regex{"NOX|Nox|Newton|ForceBalance|Teuchos"}, "NOX and what it is told"},
      {std::regex{"StepEquations"}, "step equations of Newmark"},
      {std::regex{"Transient|StepControl"}, "step control"},
      {std::regex{"Observer|Peak|Ledger|add_energies"}, "peaks and energies"}};
  for (const auto& [pattern, item] : items)
    if (std::regex_search(function, pattern)) return item;
  return everything_else;
}

struct Item {
  std::string name;
  double percent = 0.0;   // of the samples
  std::string functions;  // its largest
};

std::string without_arguments(const std::string& function) {
  constexpr std::size_t longest = 60;
  return function.substr(0, std::min(function.find_first_of("(< ", 1), longest));
}

// The largest first, what belongs nowhere last.
std::vector<Item> items_in(const std::string& report) {
  const std::regex line{R"( +([0-9.]+)% +\[.\] +(.+?)(  .*)?\n)"};
  constexpr int shown = 3;
  std::map<std::string, Item> sums;
  std::map<std::string, int> counts;
  // perf lists the largest functions first.
  for (std::sregex_iterator match{report.begin(), report.end(), line}, end; match != end; ++match) {
    const std::string function = (*match)[2].str(), name = item_of(function);
    Item& item = sums[name];
    item.name = name;
    item.percent += std::stod((*match)[1].str());
    if (name == everything_else && counts[name]++ < shown)
      item.functions += (item.functions.empty() ? "" : ", ") + without_arguments(function);
  }
  std::vector<Item> items;
  for (const auto& [name, item] : sums) items.push_back(item);
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    const bool a_is_last = a.name == everything_else, b_is_last = b.name == everything_else;
    return a_is_last != b_is_last ? b_is_last : a.percent > b.percent;
  });
  return items;
}

void repeat(const Options& options, bool locate_yield, const TransientOptions& transient_options) {
  constexpr int histories = 1000;
  const Model model = five_storey_model(locate_yield);
  const GroundMotion motion =
      (options.records.empty() ? near_fault_pulse() : read_motion(options.records / "RSN1161_KOCAELI_GBZ000.AT2"))
          .scaled_to_pga(0.4 * units::g);
  const double start = seconds();
  for (int i = 0; i < histories; ++i) moat_peaks(model, motion, transient_options);
  std::printf("%d histories, %.3g ms each\n", histories, 1e3 * (seconds() - start) / histories);
}

}  // namespace

void profile_building(const Options& options) { repeat(options, false, {}); }

void profile_exact(const Options& options) { repeat(options, true, {.integrator = ExactBetweenEvents{}}); }

void profile_street() {
  const StreetReport report = measure_street(
      {.buildings = 16667, .location_tolerance = street_location_tolerance, .steps_before = 4, .steps = 400});
  std::printf("%d degrees of freedom, %.3g ms a step, %.3g s to build the model\n", report.degrees_of_freedom,
              1e3 * spread_of(report.step_seconds).median, report.build_seconds);
}

void profile(Record& record, const Options& options) {
  record.section("profile", "Profile of the hot loops");
  if (options.quick || std::system("command -v perf >/dev/null 2>&1") != 0) {
    record.note(options.quick ? "No profile with --quick." : "perf is not installed: no profile.");
    return;
  }
  std::filesystem::create_directories(options.folder);
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  for (const auto& [loop, name] : {std::pair<std::string, std::string>{"building", "building of five storeys"},
                                   {"exact", "building of five storeys, exact between events"},
                                   {"street", "street of 1e5 degrees of freedom"}}) {
    const std::string data = "'" + (options.folder / ("profile_" + loop + ".data")).string() + "'";
    const auto items = items_in(output_of("perf record -q -o " + data + " '" + program + "' --profile " + loop +
                                          " >/dev/null 2>&1 && perf report -i " + data +
                                          " --no-children --sort symbol --stdio 2>/dev/null; rm -f " + data));
    if (items.empty()) record.note("perf could not watch the " + name + ".");
    for (const Item& item : items) record.add({name + ", " + item.name, single(item.percent), "%", {}, item.functions});
  }
  record.note("By perf record and perf report, functions summed up by what they are part of.");
}

}  // namespace moat::performance
