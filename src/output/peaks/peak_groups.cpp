#include "output/peaks/peak_groups.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"

namespace moat {
namespace {

constexpr const char* clearance_left = "clearance_left";

// The decimals that a number as text has, with the point.
std::string_view decimals_of(std::string_view number) {
  const std::size_t point = number.find('.');
  return point == std::string_view::npos ? std::string_view{} : number.substr(point);
}

// "0.3170" for m/s^2; empty for units without a second one. largest: of the group, in its unit.
std::string in_second_unit(const Peak& peak, double largest) {
  const EngineeringUnit first = engineering_unit(peak.unit), second = second_unit(peak.unit);
  if (second.symbol.empty()) return "";
  const int decimals = std::min(decimals_for(second.per_si / first.per_si * largest),
                                rounded_error(second.per_si * peak.error).decimals);
  return with_decimals(rounded_to(second.per_si * peak.value, decimals), std::max(decimals, 0));
}

void align_points(std::vector<PeakRow>& rows) {
  std::string_view longest;
  for (const PeakRow& row : rows)
    if (decimals_of(row.value).size() > longest.size()) longest = decimals_of(row.value);
  const std::string zeros = "." + std::string(longest.empty() ? 0 : longest.size() - 1, '0');
  if (longest.empty()) return;
  for (PeakRow& row : rows) row.missing = zeros.substr(decimals_of(row.value).size());
}

struct Turn {
  double time, value;
};

// The last two turns of a history with equal intervals, the later one first, on parabolas through three rows.
std::vector<Turn> last_turns(const std::vector<double>& times, const std::vector<double>& values) {
  std::vector<Turn> turns;
  for (std::size_t i = values.size(); i-- > 2 && turns.size() < 2;) {
    const double before = values[i - 1] - values[i - 2], after = values[i] - values[i - 1];
    if (before == 0.0 || before * after > 0.0) continue;
    const double shift = 0.5 * (before + after) / (before - after);
    turns.push_back(
        {times[i - 1] + shift * (times[i] - times[i - 1]), values[i - 1] + 0.25 * (before + after) * shift});
  }
  return turns;
}

// Nothing where it has come to rest, or never turned twice.
std::optional<double> mean_of_last_turns(const std::vector<double>& times, const std::vector<double>& values) {
  constexpr double at_rest = 1e-4;  // m/s
  const std::vector<Turn> turns = last_turns(times, values);
  if (turns.size() < 2) return std::nullopt;
  const double half_period = turns[0].time - turns[1].time;
  bool moves = false;
  for (std::size_t i = values.size() - 1; i > 0 && times[i] > times.back() - half_period; --i)
    moves |= std::abs(values[i] - values[i - 1]) > at_rest * (times[i] - times[i - 1]);
  return moves ? std::optional{0.5 * (turns[0].value + turns[1].value)} : std::nullopt;
}

std::vector<PeakGroup> groups_of(const std::vector<const Peak*>& peaks,
                                 const std::function<void(PeakGroup&)>& shorten) {
  std::vector<PeakGroup> groups;
  std::vector<char> done(peaks.size(), 0);
  for (std::size_t first = 0; first < peaks.size(); ++first) {
    if (done[first] != 0) continue;
    const EngineeringUnit unit = engineering_unit(peaks[first]->unit);
    std::vector<const Peak*> members;
    double largest = 0.0;
    for (std::size_t i = first; i < peaks.size(); ++i) {
      if (peaks[i]->quantity != peaks[first]->quantity || peaks[i]->unit != peaks[first]->unit) continue;
      done[i] = 1;
      members.push_back(peaks[i]);
      largest = std::max(largest, std::abs(unit.per_si * peaks[i]->value));
    }
    PeakGroup group{in_words(peaks[first]->quantity), unit.symbol, second_unit(peaks[first]->unit).symbol, {}};
    for (const Peak* peak : members) {
      const RoundedError error = rounded_error(unit.per_si * peak->error);
      const int decimals = std::min(decimals_for(largest), error.decimals);
      group.rows.push_back({peak->where,
                            with_decimals(rounded_to(unit.per_si * peak->value, decimals), std::max(decimals, 0)),
                            {},
                            error.text,
                            in_second_unit(*peak, largest),
                            with_decimals(peak->time, 3),
                            peak->side,
                            peak->quantity == clearance_left ? peak->value : peak->magnitude()});
    }
    align_points(group.rows);
    if (shorten) shorten(group);
    group.rows.shrink_to_fit();
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace

std::vector<PeakGroup> groups_of_tables(const CaseResult& result, const std::function<void(PeakGroup&)>& shorten) {
  const std::set<std::string> constant = constant_quantities(result.histories);
  const std::set<std::string> of_contact{"impact_force", "indentation", "friction_force"};
  const auto bearings = single_bearings(result.model);
  // A light wall rings after every hit; its accelerations are of no use beside those of floors.
  std::set<std::string> walls;
  for (const BuildingParts& building : result.buildings)
    for (const GapOfBuilding& gap : building.gaps) walls.insert(gap.wall);
  std::vector<const Peak*> shown;
  for (const Peak& peak : result.peaks)
    if (!constant.contains(peak.quantity) && !bearings.contains(peak.where) &&
        !(peak.quantity == "absolute_acceleration" && walls.contains(peak.where)) &&
        !(peak.value == 0.0 && of_contact.contains(peak.quantity)))
      shown.push_back(&peak);
  return groups_of(shown, shorten);
}

std::map<std::string, const ElementFacts*> single_bearings(const ModelFacts& model) {
  std::map<std::string, const ElementFacts*> bearings;
  for (const ElementFacts& element : model.elements)
    if (element.kind == "bearing" && element.place != element.name && !element.place.empty())
      bearings[element.name] = &element;
  return bearings;
}

std::vector<PeakGroup> group_peaks(const std::vector<Peak>& peaks) {
  std::vector<const Peak*> all;
  for (const Peak& peak : peaks) all.push_back(&peak);
  return groups_of(all, {});
}

PeakGroup clearance_group(const std::vector<GapClearance>& clearances) {
  std::vector<Peak> peaks;
  for (const GapClearance& gap : clearances) {
    const EngineeringUnit unit = engineering_unit("m");
    peaks.push_back({clearance_left, gap.where, gap.left, "m", gap.time, gap.error,
                     "of " + to_significant(unit.per_si * gap.clearance, 4) + " " + unit.symbol});
  }
  return peaks.empty() ? PeakGroup{} : group_peaks(peaks).front();
}

std::vector<Peak> isolators_at_the_end(const Table& histories) {
  std::vector<Peak> offsets;
  if (histories.rows() == 0) return offsets;
  const double time = histories.values("time").back();
  for (const Column& column : histories.columns)
    if (column.quantity == "isolator_deformation")
      offsets.push_back({"isolator_deformation_at_the_end", column.where, column.values.back(), column.unit, time});
  return offsets;
}

std::vector<Peak> residual_displacements(const Table& histories) {
  std::vector<Peak> residuals = isolators_at_the_end(histories);
  std::map<std::string_view, std::vector<const Column*>> deformations;  // by the place
  for (const Column& column : histories.columns)
    if (column.quantity.starts_with("isolator_deformation")) deformations[column.where].push_back(&column);
  for (Peak& residual : residuals) {
    residual.quantity = "residual_displacement";
    double squares = 0.0;  // of components in plan
    for (const Column* each : deformations[residual.where]) {
      const Column& column = *each;
      const std::optional<double> mean = mean_of_last_turns(histories.values("time"), column.values);
      if (mean) residual.side = "still moving";
      const double value = mean.value_or(column.values.back());
      if (column.quantity == "isolator_deformation")
        residual.value = value;
      else
        squares += value * value;
    }
    if (squares > 0.0) residual.value = std::sqrt(squares);
  }
  return residuals;
}

std::set<std::string> constant_quantities(const Table& histories) {
  std::set<std::string> constant, changing;
  for (const Column& column : histories.columns) {
    const auto is_first = [&](double value) { return value == column.values.front(); };
    const bool stays =
        column.values.size() > 1 && column.values.front() != 0.0 && std::ranges::all_of(column.values, is_first);
    (stays ? constant : changing).insert(column.quantity);
  }
  std::erase_if(constant, [&](const std::string& quantity) { return changing.contains(quantity); });
  return constant;
}

RoundedError rounded_error(double error) {
  constexpr int any_number = std::numeric_limits<int>::max(), most_decimals_as_number = 6;
  if (!std::isfinite(error)) return {"", any_number};
  if (error <= 0.0) return {"0", any_number};
  constexpr double round_off = 1e-9, rounds_to_two = 1.9;  // 0.02 stays 0.02
  int decimals = -static_cast<int>(std::floor(std::log10(error)));
  if (error * std::pow(10.0, decimals) < rounds_to_two + round_off) ++decimals;
  const double rounded = std::ceil(error * std::pow(10.0, decimals) - round_off) * std::pow(10.0, -decimals);
  return {
      decimals <= most_decimals_as_number ? with_decimals(rounded, std::max(decimals, 0)) : to_significant(rounded, 2),
      decimals};
}

double rounded_to(double value, int decimals) {
  if (decimals >= 0) return value;  // printing rounds
  const double unit = std::pow(10.0, -decimals);
  return unit * std::round(value / unit);
}

}  // namespace moat
