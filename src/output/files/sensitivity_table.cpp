#include "output/files/sensitivity_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/text/number_format.hpp"
#include "base/text/utf8_text.hpp"
#include "output/files/engineering_unit.hpp"

namespace moat {
namespace {

// In the order of the lines.
constexpr std::array<std::string_view, 10> compared_quantities{
    "displacement", "corner_displacement", "absolute_acceleration", "corner_acceleration", "drift",
    "corner_drift", "storey_shear",        "impact_force",          "wall_deformation",    "backfill_force"};

// The nominal magnitude; where that is zero, the largest with other contacts.
std::pair<double, double> size_of(const ChangedPeak& peak) {
  double changed = 0.0;
  for (const double value : peak.changed)
    if (std::isfinite(value)) changed = std::max(changed, std::abs(value));
  return {std::abs(peak.value), changed};
}

std::string in_per_cent(const ChangedPeak& peak, std::size_t change) {
  if (!std::isfinite(peak.changed[change])) return "-";
  if (peak.value == 0.0) return peak.changed[change] == 0.0 ? "0" : "appears";
  if (peak.changed[change] == 0.0) return "none";
  const double per_cent = std::round(100.0 * relative_change(peak, change).value_or(0.0));
  return per_cent == 0.0 ? "0" : (per_cent > 0.0 ? "+" : "") + to_fixed(per_cent, 0) + " %";
}

std::string value_of(const ChangedPeak& peak, double value) {
  const EngineeringUnit unit = engineering_unit(peak.unit);
  const double readable = unit.per_si * value;
  return with_decimals(readable, decimals_for(std::abs(readable))) + " " + unit.symbol;
}

// "; impact force 1148 kN -> none; displacement, base 14.23 cm -> 14.98 cm"
std::string values_of(const ContactSensitivity& sensitivity, std::size_t change, const std::string& place) {
  std::string text;
  for (const ChangedPeak& peak : sensitivity.peaks) {
    const auto value = [&](double each) { return each == 0.0 ? "none" : value_of(peak, each); };
    if (peak.quantity == "impact_force" && peak.where == place)
      text += "; impact force " + value(peak.value) + " -> " + value(peak.changed[change]);
  }
  for (const ChangedPeak& peak : largest_changed_peaks(sensitivity))
    if (peak.quantity == "displacement")
      text += "; " + name_of(peak) + " " + value_of(peak, peak.value) + " -> " + value_of(peak, peak.changed[change]);
  return text;
}

std::string line_of(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string line = "  " + cells[0] + std::string(widths[0] - characters_in(cells[0]), ' ');
  for (std::size_t i = 1; i < cells.size(); ++i)
    line += "  " + std::string(widths[i] - characters_in(cells[i]), ' ') + cells[i];
  return line + "\n";
}

}  // namespace

std::string label_of(const ContactVariation& variation) {
  const auto per_cent = [](double factor) {
    return (factor > 1.0 ? "+" : "") + to_fixed(100.0 * (factor - 1.0), 0) + "%";
  };
  if (variation.parameter == "restitution") return variation.difference > 0.0 ? "e+.1" : "e-.1";
  if (variation.parameter == "clearance") return "gap" + per_cent(variation.factor);
  const std::string symbol = variation.parameter == "soil" ? "soil" : "k";
  return variation.factor > 1.0 ? to_significant(variation.factor, 2) + symbol
                                : symbol + "/" + to_significant(1.0 / variation.factor, 2);
}

std::string name_of(const ChangedPeak& peak) {
  const std::string quantity =
      peak.quantity == "absolute_acceleration" ? std::string{"acceleration"} : in_words(peak.quantity);
  return quantity + ", " + peak.where;
}

std::vector<ChangedPeak> largest_changed_peaks(const ContactSensitivity& sensitivity) {
  std::vector<ChangedPeak> list;
  for (const std::string_view quantity : compared_quantities) {
    // The face of a wall jumps when it is hit: its acceleration would hide those of floors.
    const bool is_of_wall = quantity == "wall_deformation";
    const ChangedPeak* largest = nullptr;
    for (const ChangedPeak& peak : sensitivity.peaks)
      if (peak.quantity == quantity && peak.of_wall == is_of_wall && size_of(peak) > std::pair{0.0, 0.0} &&
          (largest == nullptr || size_of(peak) > size_of(*largest)))
        largest = &peak;
    if (largest != nullptr) list.push_back(*largest);
  }
  return list;
}

std::optional<double> relative_change(const ChangedPeak& peak, std::size_t change) {
  const double nominal = std::abs(peak.value), difference = std::abs(peak.changed[change]) - nominal;
  if (peak.value == 0.0 || peak.changed[change] == 0.0 || !std::isfinite(difference)) return std::nullopt;
  return std::abs(difference) < 3.0 * peak.error ? 0.0 : difference / nominal;
}

std::vector<std::string> sensitivity_notes(const ContactSensitivity& sensitivity) {
  std::vector<std::string> notes;
  if (!sensitivity.reason.empty()) notes.push_back(sensitivity.reason);
  if (sensitivity.unsettled)
    notes.emplace_back("The case itself is not settled numerically: small changes among these may have no meaning.");
  for (std::size_t i = 0; i < sensitivity.changes.size(); ++i) {
    const ContactVariation& change = sensitivity.changes[i];
    const std::string label = label_of(change);
    if (!change.failure.empty()) {
      notes.push_back(label + ": no results, " + change.failure);
      continue;
    }
    for (const auto& [place, contact] : change.contact)
      if (contact == "appears" || contact == "vanishes")
        notes.push_back(label + ": contact " + contact + " at " + place + values_of(sensitivity, i, place) + ".");
    constexpr double smallest = 1e-3, largest = 1.0;
    if (change.restitutions.empty()) continue;
    if (change.increases() && change.restitutions.back() >= largest)
      notes.push_back(label + ": a restitution reached 1, its largest value.");
    if (!change.increases() && change.restitutions.front() <= smallest)
      notes.push_back(label + ": a restitution reached 0.001, its smallest value.");
  }
  if (sensitivity.computed && sensitivity.rigid_walls && sensitivity.impacts > 0)
    notes.emplace_back("Rigid walls: a wall that gives way changes this more than k.");
  for (const std::string& law : sensitivity.unchanged_laws)
    notes.push_back("The law " + law +
                    " has no parameter that moat can change: it has no fields stiffness and "
                    "restitution.");
  return notes;
}

std::string sensitivity_table(const ContactSensitivity& sensitivity, double seconds) {
  if (sensitivity.runs_left_out > 0)
    return "\nSensitivity to contact parameters: not computed" +
           (seconds > 0.0
                ? ", at most " + to_significant(static_cast<double>(sensitivity.runs_left_out) * seconds, 2) + " s"
                : std::string{}) +
           "; --sensitivity\n";
  if (!sensitivity.computed) return "";
  std::vector<std::vector<std::string>> lines{{"if contact differs"}};
  for (const ContactVariation& change : sensitivity.changes) lines.front().push_back(label_of(change));
  for (const ChangedPeak& peak : largest_changed_peaks(sensitivity)) {
    lines.push_back({"  " + name_of(peak)});
    for (std::size_t i = 0; i < sensitivity.changes.size(); ++i) lines.back().push_back(in_per_cent(peak, i));
  }
  if (!sensitivity.changes.empty()) {
    lines.push_back({"  impacts " + std::to_string(sensitivity.impacts)});
    for (const ContactVariation& change : sensitivity.changes)
      lines.back().push_back(change.failure.empty() ? std::to_string(change.impacts) : "-");
  }
  std::vector<std::size_t> widths(lines.front().size(), 5);
  for (const std::vector<std::string>& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], characters_in(line[i]));
  std::string text = "\n";
  for (const std::vector<std::string>& line : lines) text += line_of(line, widths);
  for (const std::string& note : sensitivity_notes(sensitivity)) text += "    " + note + "\n";
  return text;
}

}  // namespace moat
