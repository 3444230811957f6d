#include "study/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/text/number_format.hpp"
#include "output/files/engineering_unit.hpp"
#include "report/html.hpp"
#include "study/responses.hpp"
#include "study/study_charts.hpp"

namespace moat {
namespace {

// The quantities that a report shows, in its order.
constexpr std::array<std::string_view, 18> main_quantities{
    "clearance_left",      "impact_force",     "isolator_deformation", "corner_displacement", "displacement",
    "isolator_force",      "total_base_shear", "total_base_shear_x",   "total_base_shear_y",  "storey_shear",
    "storey_shear_x",      "storey_shear_y",   "drift_ratio",          "corner_drift_ratio",  "absolute_acceleration",
    "corner_acceleration", "uplift_deficit",   "bearing_unstable"};

// Statistics look for the largest; of a clearance left the smallest decides.
double sense_of(std::string_view quantity) { return quantity == "clearance_left" ? -1.0 : 1.0; }

Statistics in_sense(Statistics of, double sense) {
  for (double* value : {&of.mean, &of.median, &of.fractile_84, &of.largest}) *value *= sense;
  // A clearance is no lognormal variable: it changes its sign.
  if (sense < 0.0) of.lognormal_median = of.lognormal_84 = of.dispersion = Statistics::unknown;
  return of;
}

// The positions of a case on all axes but one.
std::string other_axes(const StudyCase& each, std::string_view axis) {
  std::string text;
  for (const StudyAxis& other : each.cases().axes()) {
    if (other.name == axis || other.values.size() < 2) continue;
    text += (text.empty() ? "" : ", ") + other.name + " = " + each.label(other.name) +
            (other.labels.empty() && !other.unit.empty() ? " " + other.unit : "");
  }
  return text;
}

// Returns the envelope in the sense of the quantity. NaN, the value of a group without results, exceeds nothing.
RecordStatistics envelope_of(std::span<const RecordStatistics> groups, double sense) {
  const auto exceeds = [sense](double value, double other) {
    return !std::isnan(value) && (std::isnan(other) || sense * value > sense * other);
  };
  const RecordStatistics* governing = &groups.front();
  for (const RecordStatistics& group : groups)
    if (exceeds(group.design, governing->design)) governing = &group;
  RecordStatistics envelope = *governing;
  envelope.envelope = true;
  Statistics& of = envelope.statistics;
  of.lognormal_median = of.lognormal_84 = of.dispersion = Statistics::unknown;
  for (const RecordStatistics& group : groups) {
    const Statistics& its = group.statistics;
    envelope.solved = std::min(envelope.solved, group.solved);
    envelope.collapsed = std::max(envelope.collapsed, group.collapsed);
    envelope.unsolved = std::max(envelope.unsolved, group.unsolved);
    if (exceeds(its.largest, of.largest)) envelope.record = group.record;
    for (double Statistics::*value :
         {&Statistics::mean, &Statistics::median, &Statistics::fractile_84, &Statistics::largest})
      if (exceeds(its.*value, of.*value)) of.*value = its.*value;
  }
  return envelope;
}

// "3 of 7 records touch. ", in any of their cases; empty for models without gaps.
std::string touching_records(const StudyResult& study, const std::string& axis) {
  const std::vector<Column>& columns = study.table().columns;
  if (std::ranges::none_of(columns, [](const Column& each) { return each.quantity == "clearance_left"; })) return "";
  const std::size_t index = study.cases().index_of(axis);
  const std::vector<double>& impacts = study.table().values("impacts");
  std::set<std::size_t> touching;
  for (std::size_t number = 0; number < impacts.size(); ++number)
    if (impacts[number] > 0.0) touching.insert(study.cases().position(index, number));
  return std::to_string(touching.size()) + " of " + std::to_string(study.axes()[index].values.size()) +
         " records touch. ";
}

// Says which statistic the groups with values have as design value: some may have the mean, and others the largest.
std::string rule_of_design_values(const std::vector<RecordStatistics>& list) {
  bool any_mean = false, any_largest = false;
  for (const RecordStatistics& each : list)
    if (!each.envelope && each.solved > 0) (each.solved >= fewest_for_mean ? any_mean : any_largest) = true;
  if (any_mean && any_largest) return "The design value is the mean of at least seven records, of fewer the largest";
  return any_mean ? "The design value is the mean of the records"
                  : "The design value is the largest: the mean needs seven records";
}

std::string in_report(double value, const std::string& unit) {
  return std::isinf(value) ? "infinite" : html::escaped(html::number_with_unit(value, unit));
}

}  // namespace

StudyGroups groups_over(const StudyResult& study, std::string_view axis) {
  StudyGroups groups;
  std::unordered_map<std::string, std::size_t> places;
  for (std::size_t number = 0; number < study.cases().count(); ++number) {
    const std::string name = other_axes(StudyCase{study.cases(), number}, axis);
    const auto [found, is_new] = places.try_emplace(name, groups.size());
    if (is_new) groups.push_back({name, {}});
    groups[found->second].second.push_back(number);
  }
  return groups;
}

Statistics statistics_of(std::span<const double> magnitudes) {
  Statistics of;
  if (magnitudes.empty()) return of;
  const auto count = static_cast<double>(magnitudes.size());
  const std::vector<double> values{magnitudes.begin(), magnitudes.end()};
  constexpr double upper = 0.84;
  of.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  of.median = fractile(values, 0.5);
  of.fractile_84 = fractile(values, upper);
  const auto largest = std::ranges::max_element(values);
  of.largest = *largest;
  of.at_largest = static_cast<std::size_t>(largest - values.begin());
  if (values.size() < 2 || !std::ranges::all_of(values, [](double each) { return each > 0.0 && std::isfinite(each); }))
    return of;
  double mean = 0.0, squares = 0.0;
  for (const double each : values) mean += std::log(each) / count;
  for (const double each : values) squares += (std::log(each) - mean) * (std::log(each) - mean);
  of.dispersion = std::sqrt(squares / (count - 1.0));
  of.lognormal_median = std::exp(mean);
  of.lognormal_84 = std::exp(mean + of.dispersion);
  return of;
}

std::vector<RecordStatistics> statistics_over(const StudyResult& study, std::string_view axis) {
  const std::string name{axis};
  static_cast<void>(study.cases().index_of(axis));
  const StudyGroups groups = groups_over(study, axis);
  const std::vector<Column>& columns = study.table().columns;
  const auto collapsed = std::ranges::find(columns, "collapsed", &Column::quantity);
  std::vector<RecordStatistics> list;
  for (std::size_t c = study.axes().size(); c < columns.size(); ++c) {
    const Column& column = columns[c];
    if (!is_response(column.quantity)) continue;
    const double sense = sense_of(column.quantity);
    const std::size_t first = list.size();
    for (const auto& [group, numbers] : groups) {
      RecordStatistics each{.quantity = column.quantity, .where = column.where, .unit = column.unit, .group = group};
      std::vector<double> values;
      std::vector<std::size_t> of_values;
      for (const std::size_t number : numbers) {
        if (study.state(number) != CaseState::done) ++each.unsolved;
        if (std::isnan(column.values[number])) continue;
        const bool fell = collapsed != columns.end() && collapsed->values[number] > 0.0;
        if (fell) ++each.collapsed;
        values.push_back(fell && !is_of_pounding(column.quantity) ? std::numeric_limits<double>::infinity()
                                                                  : sense * column.values[number]);
        of_values.push_back(number);
      }
      // Models of a combination may lack the place; one without any solved case is a row all the same.
      if (values.empty() && each.unsolved < numbers.size()) continue;
      each.solved = values.size();
      each.statistics = in_sense(statistics_of(values), sense);
      each.design = each.solved >= fewest_for_mean ? each.statistics.mean : each.statistics.largest;
      if (!values.empty()) each.record = StudyCase{study.cases(), of_values[each.statistics.at_largest]}.label(name);
      list.push_back(std::move(each));
    }
    if (groups.size() > 1 && list.size() > first) list.push_back(envelope_of(std::span{list}.subspan(first), sense));
  }
  return list;
}

std::string axis_of_records(const StudyResult& study) {
  const auto found = std::ranges::find_if(study.axes(), [](const StudyAxis& axis) { return !axis.hashes.empty(); });
  return found == study.axes().end() ? "" : found->name;
}

Table table_of(const std::vector<RecordStatistics>& list) {
  Table table;
  const auto add_text = [&](const char* name, const auto& text_of_row) {
    Column& column = table.columns.emplace_back(Column{name, "", "1", std::vector(list.size(), Statistics::unknown)});
    for (const RecordStatistics& each : list) column.labels.push_back(text_of_row(each));
  };
  const auto add_number = [&](const char* name, const auto& number_of_row) {
    Column& column = table.columns.emplace_back(Column{name, "", "unit", {}});
    for (const RecordStatistics& each : list) column.values.push_back(static_cast<double>(number_of_row(each)));
  };
  using Row = const RecordStatistics&;
  add_text("quantity", [](Row each) { return each.quantity; });
  add_text("where", [](Row each) { return each.where; });
  add_text("unit", [](Row each) { return each.unit; });
  add_text("group", [](Row each) { return each.envelope ? "envelope" : each.group; });
  add_number("records", [](Row each) { return each.solved; });
  add_number("collapsed", [](Row each) { return each.collapsed; });
  add_number("unsolved", [](Row each) { return each.unsolved; });
  add_number("mean", [](Row each) { return each.statistics.mean; });
  add_number("median", [](Row each) { return each.statistics.median; });
  add_number("fractile_84", [](Row each) { return each.statistics.fractile_84; });
  add_number("largest", [](Row each) { return each.statistics.largest; });
  add_text("record", [](Row each) { return each.record; });
  add_number("design_value", [](Row each) { return each.design; });
  add_number("lognormal_median", [](Row each) { return each.statistics.lognormal_median; });
  add_number("lognormal_84", [](Row each) { return each.statistics.lognormal_84; });
  add_number("dispersion", [](Row each) { return each.statistics.dispersion; });
  return table;
}

std::string statistics_section(const StudyResult& study, const std::vector<RecordStatistics>& list) {
  const std::string axis = axis_of_records(study);
  if (axis.empty() || study.axes()[study.cases().index_of(axis)].values.size() < 2) return "";
  const bool has_envelope = std::ranges::any_of(list, &RecordStatistics::envelope);
  // Every quantity has the place with the largest design value.
  std::vector<const RecordStatistics*> rows;
  for (const std::string_view quantity : main_quantities) {
    const RecordStatistics* decides = nullptr;
    for (const RecordStatistics& each : list)
      if (each.quantity == quantity && each.envelope == has_envelope &&
          (decides == nullptr || sense_of(quantity) * each.design > sense_of(quantity) * decides->design))
        decides = &each;
    if (decides != nullptr) rows.push_back(decides);
  }
  if (rows.empty()) return "";
  std::string html = "<div class=\"wide\"><table class=\"sortable dense\">\n<tr><th>quantity</th><th>where</th>";
  for (const char* heading : {"design value", "mean", "median", "84 %", "largest", "record"})
    html += std::string{"<th>"} + heading + "</th>";
  html += has_envelope ? "<th>governed by</th></tr>\n" : "</tr>\n";
  std::size_t unsolved = 0, collapsed = 0;
  for (const RecordStatistics* row : rows) {
    const Statistics& of = row->statistics;
    html += "<tr>" + html::cell(capitalised(in_words(row->quantity))) + html::cell(row->where) +
            "<td class=\"number\"><strong>" + in_report(row->design, row->unit) + "</strong></td>";
    for (const double value : {of.mean, of.median, of.fractile_84, of.largest})
      html += "<td class=\"number\">" + in_report(value, row->unit) + "</td>";
    html += html::cell(row->record) + (has_envelope ? html::cell(row->group) : "") + "</tr>\n";
    unsolved = std::max(unsolved, row->unsolved);
    collapsed = std::max(collapsed, row->collapsed);
  }
  html += "</table></div>\n<p>" + touching_records(study, axis) +
          "Each quantity at the place that decides; all places are in the table of statistics. " +
          rule_of_design_values(list) + (has_envelope ? ", in the group with the largest. " : ". ");
  if (collapsed > 0) html += std::to_string(collapsed) + " collapsed, which counts as infinite. ";
  if (unsolved > 0)
    html += std::to_string(unsolved) + " have no result and do not count: this is not the whole suite. ";
  for (const auto& [group, numbers] : groups_over(study, axis))
    if (std::ranges::all_of(numbers, [&](std::size_t i) { return study.state(i) != CaseState::done; }))
      html += html::escaped(group) + " has no result at all. ";
  return html + "</p>\n";
}

}  // namespace moat
