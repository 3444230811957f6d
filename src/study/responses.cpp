#include "study/responses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "output/files/engineering_unit.hpp"

namespace moat {

std::vector<StudyResponse> responses_of(const StudyResult& study) {
  constexpr std::size_t most_quantities = 8;
  using Limits = std::numeric_limits<double>;
  std::vector<StudyResponse> list;
  std::map<std::string, std::size_t> known;
  const std::vector<Column>& columns = study.table().columns;
  for (std::size_t c = study.axes().size(); c < columns.size(); ++c) {
    const Column& column = columns[c];
    if (!is_response(column.quantity)) continue;
    const bool smallest = column.quantity == "clearance_left";
    const EngineeringUnit unit = engineering_unit(column.unit);
    const auto [found, added] = known.try_emplace(column.quantity, list.size());
    if (added) {
      const std::string words = in_words(column.quantity);
      const bool of_places = !column.where.empty();
      list.push_back({column.quantity, of_places ? (smallest ? "Smallest " : "Largest ") + words : capitalised(words),
                      words + (unit.symbol == "1" ? "" : " [" + with_raised_digits(unit.symbol) + "]"),
                      std::vector(study.cases().count(), Limits::quiet_NaN())});
    }
    std::vector<double>& values = list[found->second].values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double value = unit.per_si * column.values[i];
      if (std::isnan(values[i]) || (smallest ? value < values[i] : value > values[i])) values[i] = value;
    }
  }
  const auto collapsed = std::ranges::find(columns, "collapsed", &Column::quantity);
  for (StudyResponse& response : list)
    for (std::size_t i = 0; i < response.values.size() && collapsed != columns.end(); ++i)
      if (collapsed->values[i] > 0.0 && !is_of_pounding(response.quantity)) response.values[i] = Limits::infinity();
  std::stable_partition(list.begin(), list.end(),
                        [](const StudyResponse& each) { return is_of_pounding(each.quantity); });
  if (list.size() > most_quantities) list.resize(most_quantities);
  return list;
}

}  // namespace moat
