#include "output/summary.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "output/file_io.hpp"
#include "output/impact_columns.hpp"
#include "output/peak_groups.hpp"

namespace moat {
namespace {

using Json = nlohmann::ordered_json;

std::size_t letters(const std::string& text) {
  // Continuation bytes of UTF-8 take no room on the screen.
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padding(std::size_t width, const std::string& text) {
  return std::string(width - std::min(width, letters(text)), ' ');
}

Json json_of(const SolverStatistics& solver) {
  return {{"accepted_steps", solver.accepted_steps},
          {"rejected_steps", solver.rejected_steps},
          {"repeated_steps", solver.repeated_steps},
          {"event_solves", solver.event_solves},
          {"events", solver.events},
          {"newton_iterations", solver.newton_iterations},
          {"factorisations", solver.factorisations},
          {"cpu_seconds", solver.cpu_seconds},
          {"longest_step", solver.longest_step}};
}

Json json_of(const ErrorBars& bars) {
  Json json{{"checked", bars.checked},      {"method", error_bar_method},  {"companion", bars.companion},
            {"companion_impacts", nullptr}, {"companion_solver", nullptr}, {"sensitive", nullptr},
            {"reason", bars.reason}};
  if (bars.checked) {
    json["companion_impacts"] = bars.companion_impacts;
    json["companion_solver"] = json_of(bars.companion_solver);
    json["sensitive"] = bars.sensitive;
  }
  json["unsettled"] = Json::array();
  for (const Peak& peak : bars.unsettled)
    json["unsettled"].push_back(Json{{"quantity", peak.quantity}, {"where", peak.where}});
  return json;
}

}  // namespace

void write_summary_json(const CaseResult& result, const std::filesystem::path& path) {
  Json json;
  json["title"] = result.title;
  json["moat_version"] = MOAT_VERSION;
  json["motion"] = {{"name", result.motion.name},
                    {"peak_acceleration", result.motion.peak_acceleration},
                    {"peak_velocity", result.motion.peak_velocity},
                    {"time_step", result.motion.time_step},
                    {"duration", result.motion.duration}};
  json["periods"] = Json::array();
  for (const NamedPeriod& period : result.periods)
    json["periods"].push_back(Json{{"name", period.name}, {"value", period.value}});
  json["assumptions"] = result.assumptions;
  json["peaks"] = Json::array();
  for (const Peak& peak : result.peaks)
    json["peaks"].push_back(Json{{"quantity", peak.quantity},
                                 {"where", peak.where},
                                 {"value", peak.value},
                                 {"unit", peak.unit},
                                 {"time", peak.time},
                                 {"error", peak.error}});
  json["error_bars"] = json_of(result.error_bars);
  json["impacts"] = result.impacts.size();
  json["impact_table"] = Json::array();
  for (const Impact& impact : result.impacts) {
    Json row{{"where", impact.where}};
    for (const ImpactColumn& column : impact_columns) row[column.name] = impact.*column.value;
    json["impact_table"].push_back(std::move(row));
  }
  const EnergyBalance& energy = result.energy;
  const auto by_place = [](const std::vector<DissipatedEnergy>& list) {
    Json entries = Json::array();
    for (const DissipatedEnergy& entry : list) entries.push_back(Json{{"where", entry.where}, {"value", entry.value}});
    return entries;
  };
  json["energy"] = {{"unit", "J"},
                    {"input", energy.input},
                    {"kinetic", energy.kinetic},
                    {"strain", energy.strain},
                    {"viscous", energy.viscous},
                    {"hysteretic", energy.hysteretic},
                    {"impact", energy.impact},
                    {"equation_residual", energy.equation_residual},
                    {"integration_error", energy.integration_error},
                    {"largest_input", energy.largest_input},
                    {"largest_kinetic", energy.largest_kinetic},
                    {"worst_element", energy.worst_element},
                    {"worst_element_error", energy.worst_element_error},
                    {"bearings", by_place(energy.bearings)},
                    {"gaps", by_place(energy.gaps)}};
  json["warnings"] = result.warnings;
  json["solver"] = json_of(result.solver);
  // A title in another encoding must not cost the results of a run.
  write_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string peak_table(const CaseResult& result) {
  const std::vector<PeakGroup> groups = group_peaks(result.peaks);
  std::size_t where_width = 0, value_width = 0, error_width = 0, time_width = 0;
  for (const PeakGroup& group : groups) {
    for (const PeakRow& row : group.rows) {
      where_width = std::max(where_width, letters(row.where));
      value_width = std::max(value_width, row.value.size() + row.missing.size());
      error_width = std::max(error_width, row.error.size());
      time_width = std::max(time_width, row.time.size());
    }
  }
  const auto error_column = [&](const PeakRow& row) {
    if (error_width == 0) return std::string{};
    return (row.error.empty() ? "    " : " +- ") + row.error + padding(error_width, row.error);
  };
  std::string text;
  for (const PeakGroup& group : groups) {
    text += "peak " + group.quantity + " [" + group.unit + "]\n";
    for (const PeakRow& row : group.rows)
      text += "  " + row.where + padding(where_width + 2, row.where) + padding(value_width, row.value + row.missing) +
              row.value + std::string(row.missing.size(), ' ') + error_column(row) + "   at " +
              padding(time_width, row.time) + row.time + " s\n";
  }
  return text;
}

}  // namespace moat
