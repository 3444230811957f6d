#include "study/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/check.hpp"

namespace moat {

StudyAxis StudyAxis::of_names(std::string name, std::vector<std::string> labels) {
  StudyAxis axis{.name = std::move(name), .unit = "", .values = {}, .labels = std::move(labels)};
  for (std::size_t i = 0; i < axis.labels.size(); ++i) axis.values.push_back(static_cast<double>(i));
  return axis;
}

void check(const StudyAxis& axis) {
  const Check check{"StudyAxis", axis.name};
  check.that(!axis.values.empty(), "there are no values.", "Give at least one.");
  check.that(axis.labels.empty() || axis.labels.size() == axis.values.size(),
             "the numbers of labels and values differ.", "Give one label for every value, or none.");
  check.that(axis.hashes.empty() || axis.hashes.size() == axis.values.size(),
             "the numbers of hashes and values differ.", "Give one hash for every value, or none.");
  for (const double value : axis.values) check.finite("a value", value, axis.unit);
  check.that(!axis.name.empty(), "it has no name.", "Give it one, for example \"gap\".");
  // The other columns of the table of a study.
  constexpr std::array<std::string_view, 6> taken{"case", "state", "reason", "steps", "energy_error", "seconds"};
  check.that(std::ranges::find(taken, axis.name) == taken.end(), "tables of studies have a column of this name.",
             "Give it another name.");
}

std::vector<double> linearly_spaced(double first, double last, int count) {
  Check{"linearly_spaced", ""}.that(count >= 2, "count", count, "1", ">= 2");
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(first + (last - first) * i / (count - 1));
  return values;
}

std::vector<double> logarithmically_spaced(double first, double last, int count) {
  const Check check{"logarithmically_spaced", ""};
  check.positive("first", first, "1");
  check.positive("last", last, "1");
  std::vector<double> values = linearly_spaced(std::log10(first), std::log10(last), count);
  for (double& value : values) value = std::pow(10.0, value);
  values.front() = first;
  values.back() = last;
  return values;
}

}  // namespace moat
