#include "output/files/summary.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

#include "output/files/file_io.hpp"
#include "output/files/json_object_writer.hpp"
#include "output/peaks/peak_groups.hpp"
#include "output/recorders/energy_columns.hpp"
#include "output/recorders/impact_columns.hpp"

namespace moat {
namespace {

using Json = JsonObjectWriter::Json;

Json text_or_null(const std::string& text) { return text.empty() ? Json{} : Json(text); }

// [ json(item), ... ]
template <class Items, class ToJson>
Json list_of(const Items& items, const ToJson& json) {
  Json list = Json::array();
  for (const auto& each : items) list.push_back(json(each));
  return list;
}

// { name: { "value", "unit" } }
Json json_of_parameters(const auto& parameters) {
  Json json = Json::object();
  for (const auto& each : parameters) json[std::string{each.name}] = {{"value", each.value}, {"unit", each.unit}};
  return json;
}

Json json_of(const AnalysisFacts& analysis) {
  return {{"integrator", text_or_null(analysis.integrator)},
          {"events", text_or_null(analysis.events)},
          {"error_bars", text_or_null(analysis.error_bars)},
          {"contact_sensitivity", text_or_null(analysis.contact_sensitivity)},
          {"options", json_of_parameters(analysis.options)}};
}

Json json_of(const Provenance& provenance) {
  Json options = Json::object();
  for (const auto& [name, value] : provenance.options) options[name] = value;
  return {{"command_line", text_or_null(provenance.command_line)},
          {"script", text_or_null(provenance.script)},
          {"script_sha256", text_or_null(provenance.script_sha256)},
          {"options", std::move(options)},
          {"moat_version", provenance.moat_version},
          {"git_commit", text_or_null(provenance.git_commit)},
          {"date", text_or_null(provenance.date)}};
}

Json json_of(const MotionFacts& motion) {
  const MotionComponent first = motion.components.empty() ? MotionComponent{} : motion.components.front();
  const auto component = [](const MotionComponent& each) {
    return Json{{"name", each.name},
                {"file", text_or_null(each.file.path)},
                {"sha256", text_or_null(each.file.sha256)},
                {"scale_factor", each.scale_factor}};
  };
  return {{"name", motion.name},
          {"peak_acceleration", motion.peak_acceleration},
          {"peak_velocity", motion.peak_velocity},
          {"time_step", motion.time_step},
          {"duration", motion.duration},
          {"file", text_or_null(first.file.path)},
          {"sha256", text_or_null(first.file.sha256)},
          {"scale_factor", first.scale_factor},
          {"components", list_of(motion.components, component)},
          {"notes", motion.notes},
          {"units", {{"peak_acceleration", "m/s^2"}, {"peak_velocity", "m/s"}, {"time_step", "s"}, {"duration", "s"}}}};
}

Json json_of(PlanVector vector) { return {vector.x, vector.y}; }

// Floors in plan, and the corners that can hit edges.
void add_plan(JsonObjectWriter& json, const ModelFacts& model) {
  json.add("plan_units", {{"radius_of_gyration", "m"},
                          {"centre_of_mass", "m"},
                          {"outline", "m"},
                          {"first_position", "m"},
                          {"second_position", "m"},
                          {"direction", "1"},
                          {"position", "m"},
                          {"normal", "1"},
                          {"edge_begin", "m"},
                          {"edge_end", "m"},
                          {"clearance", "m"}});
  json.add_list("diaphragms", model.diaphragms, [](const DiaphragmFacts& each) {
    return Json{{"name", each.name},
                {"radius_of_gyration", each.gyration},
                {"centre_of_mass", json_of(each.centre_of_mass)},
                {"outline", list_of(each.outline, [](PlanVector corner) { return json_of(corner); })}};
  });
  json.add_list("corners", model.corners, [](const CornerFacts& each) {
    return Json{{"element", each.element},
                {"corner", each.corner},
                {"edge", each.edge},
                {"position", json_of(each.position)},
                {"normal", json_of(each.normal)},
                {"edge_begin", json_of(each.edge_begin)},
                {"edge_end", json_of(each.edge_end)},
                {"clearance", each.clearance}};
  });
}

Json json_of(const ElementFacts& element) {
  Json json{
      {"name", element.name},   {"kind", element.kind},     {"law", text_or_null(element.law)},
      {"first", element.first}, {"second", element.second}, {"parameters", json_of_parameters(element.parameters)}};
  // An end between two nodes: the share of the way from the node above to the other.
  if (!element.first_other.empty())
    json["first_point"] = {{"other", element.first_other}, {"share", element.first_share}};
  if (!element.second_other.empty())
    json["second_point"] = {{"other", element.second_other}, {"share", element.second_share}};
  if (!element.plan_places) return json;
  const auto& [first, second, direction] = *element.plan_places;
  json["first_position"] = json_of(first);
  json["second_position"] = json_of(second);
  // An element without one direction acts in both.
  if (dot(direction, direction) > 0.0) json["direction"] = json_of(direction);
  return json;
}

void add_model(JsonObjectWriter json, const ModelFacts& model, const std::vector<BuildingParts>& buildings) {
  const auto node = [](const NodeFacts& each) {
    return Json{{"name", each.name},
                {"mass", each.mass},
                {"x", each.x},
                {"height", each.height},
                {"initial_displacement", each.initial_displacement},
                {"initial_velocity", each.initial_velocity}};
  };
  const auto building = [](const BuildingParts& each) {
    return Json{
        {"name", each.name}, {"base", text_or_null(each.base)}, {"floors", each.floors}, {"isolators", each.isolators}};
  };
  json.add_list("nodes", model.nodes, node);
  json.add("node_units",
           {{"mass", "kg"}, {"x", "m"}, {"height", "m"}, {"initial_displacement", "m"}, {"initial_velocity", "m/s"}});
  json.add_list("elements", model.elements, [](const ElementFacts& each) { return json_of(each); });
  json.add_list("buildings", buildings, building);
  if (!model.diaphragms.empty()) add_plan(json, model);
  json.end();
}

Json json_of(const EnergyBalance& energy) {
  const auto by_place = [](const DissipatedEnergy& each) { return Json{{"where", each.where}, {"value", each.value}}; };
  Json json{{"unit", "J"}};
  for (const EnergyColumn& column : energy_columns(energy.in_plan, energy.weights_change))
    json[column.name] = energy.*column.value;
  for (const EnergyColumn& column : energy_errors) json[column.name] = energy.*column.value;
  json["worst_element"] = energy.worst_element;
  json["worst_element_error"] = energy.worst_element_error;
  json["bearings"] = list_of(energy.bearings, by_place);
  json["gaps"] = list_of(energy.gaps, by_place);
  return json;
}

Json json_of(const SolverStatistics& solver) {
  return {{"accepted_steps", solver.accepted_steps},
          {"rejected_steps", solver.rejected_steps},
          {"repeated_steps", solver.repeated_steps},
          {"event_solves", solver.event_solves},
          {"events", solver.events},
          {"passed_changes", solver.passed_changes},
          {"newton_iterations", solver.newton_iterations},
          {"factorisations", solver.factorisations},
          {"cpu_seconds", solver.cpu_seconds},
          {"longest_step", solver.longest_step}};
}

Json json_of(const ErrorBars& bars) {
  Json json{{"checked", bars.checked},      {"method", error_bar_method},  {"companion", bars.companion},
            {"companion_impacts", nullptr}, {"companion_solver", nullptr}, {"unsettled", nullptr},
            {"reason", bars.reason}};
  if (bars.checked) {
    json["companion_impacts"] = bars.companion_impacts;
    json["companion_solver"] = json_of(bars.companion_solver);
    json["unsettled"] = bars.unsettled;
  }
  json["unsettled_peaks"] = list_of(bars.unsettled_peaks, [](const Peak& peak) {
    return Json{{"quantity", peak.quantity}, {"where", peak.where}};
  });
  return json;
}

Json json_of(const ContactVariation& variation) {
  Json json{{"parameter", variation.parameter}, {"places", nullptr}, {"impacts", variation.impacts}};
  if (variation.parameter == "restitution") {
    json["difference"] = variation.difference;
    json["restitutions"] = variation.restitutions;
  } else {
    json["factor"] = variation.factor;
  }
  json["contact"] = Json::object();
  for (const auto& [place, change] : variation.contact) json["contact"][place] = change;
  json["failure"] = text_or_null(variation.failure);
  return json;
}

void add_sensitivity(JsonObjectWriter json, const ContactSensitivity& sensitivity) {
  const auto peak = [](const ChangedPeak& each) {
    return Json{{"quantity", each.quantity}, {"where", each.where}, {"unit", each.unit},
                {"value", each.value},       {"error", each.error}, {"changed", each.changed}};
  };
  json.add("computed", sensitivity.computed);
  json.add("reason", text_or_null(sensitivity.reason));
  json.add("unsettled", sensitivity.unsettled);
  json.add("rigid_walls", sensitivity.rigid_walls);
  json.add("impacts", sensitivity.impacts);
  json.add_list("changes", sensitivity.changes, [](const ContactVariation& each) { return json_of(each); });
  json.add_list("peaks", sensitivity.peaks, peak);
  json.add("unchanged_laws", sensitivity.unchanged_laws);
  json.end();
}

void write_summary(const CaseResult& result, std::ostream& file) {
  JsonObjectWriter json{file};
  json.add("title", result.title);
  json.add("moat_version", result.provenance.moat_version);
  json.add("provenance", json_of(result.provenance));
  json.add("motion", json_of(result.motion));
  add_model(json.add_object("model"), result.model, result.buildings);
  json.add("analysis", json_of(result.analysis));
  json.add_list("periods", result.periods, [](const NamedPeriod& period) {
    return Json{{"name", period.name}, {"value", period.value}, {"unit", "s"}};
  });
  json.add("assumptions", result.assumptions);
  json.add_list("peaks", result.peaks, [](const Peak& peak) {
    return Json{{"quantity", peak.quantity}, {"where", peak.where}, {"value", peak.value}, {"unit", peak.unit},
                {"time", peak.time},         {"error", peak.error}, {"side", peak.side}};
  });
  json.add_list("clearances", result.clearances, [](const GapClearance& gap) {
    return Json{{"where", gap.where}, {"clearance", gap.clearance}, {"clearance_left", gap.left},
                {"unit", "m"},        {"time", gap.time},           {"error", gap.error}};
  });
  const std::vector<Peak> residuals = residual_displacements(result.histories);
  auto residual = residuals.begin();
  json.add_list("isolators_at_the_end", isolators_at_the_end(result.histories), [&](const Peak& isolator) {
    return Json{{"where", isolator.where},
                {"deformation", isolator.value},
                {"residual_displacement", (residual++)->value},
                {"unit", "m"},
                {"time", isolator.time}};
  });
  json.add("constant_quantities", constant_quantities(result.histories));
  json.add("error_bars", json_of(result.error_bars));
  if (result.clearances.empty())
    json.add("contact_sensitivity", nullptr);
  else
    add_sensitivity(json.add_object("contact_sensitivity"), result.contact_sensitivity);
  json.add("impacts", result.impacts.size());
  const std::vector<ImpactColumn> columns = columns_of(result.impacts);
  Json units = Json::object();
  for (const ImpactColumn& column : columns) units[column.name] = column.unit;
  json.add("impact_units", units);
  json.add_list("impact_table", result.impacts, [&](const Impact& impact) {
    Json row{{"where", impact.where}};
    for (const ImpactColumn& column : columns) row[column.name] = impact.*column.value;
    if (are_in_plan(result.impacts))
      for (const ImpactName& name : impact_names_in_plan) row[name.name] = impact.*name.value;
    return row;
  });
  if (!result.torsion.empty())
    json.add_list("torsion", result.torsion, [](const BuildingTorsion& torsion) {
      return Json{{"where", torsion.where},
                  {"corner_displacement", torsion.corner},
                  {"displacement", torsion.centre},
                  {"amplification", torsion.amplification()},
                  {"eccentricity", torsion.eccentricity},
                  {"period_ratio", torsion.period_ratio},
                  {"of_formula", torsion.of_formula},
                  {"of_code", torsion.of_code}};
    });
  json.add("energy", json_of(result.energy));
  json.add("warnings", result.warnings);
  json.add("solver", json_of(result.solver));
  json.end();
  file << "\n";
}

}  // namespace

void write_summary_json(const CaseResult& result, const std::filesystem::path& path) {
  write_file(path, [&](std::ostream& file) { write_summary(result, file); });
}

}  // namespace moat
