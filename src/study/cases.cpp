#include "study/cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moat {
namespace {

constexpr double most_cases = 1e9;

std::vector<std::size_t> one_group_each(std::size_t axes) {
  std::vector<std::size_t> groups(axes);
  for (std::size_t i = 0; i < axes; ++i) groups[i] = i;
  return groups;
}

}  // namespace

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

StudyCases::StudyCases(std::vector<StudyAxis> axes) : StudyCases{std::move(axes), {}} {}

StudyCases::StudyCases(std::vector<StudyAxis> axes, std::vector<std::size_t> groups)
    : axes_{std::move(axes)}, groups_{groups.empty() ? one_group_each(axes_.size()) : std::move(groups)} {
  Check{"Study", ""}.that(!axes_.empty(), "there is no axis.", "Give at least one StudyAxis.");
  std::set<std::string> names;
  for (const StudyAxis& axis : axes_) {
    Check{"StudyAxis", axis.name}.that(names.insert(axis.name).second, "the name appears twice.",
                                       "Give every axis a name of its own.");
    check(axis);
  }
  for (std::size_t i = 1; i < axes_.size(); ++i)
    if (groups_[i] == groups_[i - 1])
      Check{"StudyAxis", axes_[i].name}.that(axes_[i].values.size() == axes_[i - 1].values.size(),
                                             "it has " + std::to_string(axes_[i].values.size()) +
                                                 " values, and axis \"" + axes_[i - 1].name + "\" has " +
                                                 std::to_string(axes_[i - 1].values.size()) + ".",
                                             "Axes of a list step together: give them equally many.");
  require_different_labels();
  double cases = 1.0;
  for (const std::size_t length : lengths()) cases *= static_cast<double>(length);
  Check{"Study", ""}.that(cases <= most_cases, "number of cases", cases, "1", "<= 1e9", "Give the axes fewer values.");
}

StudyCases StudyCases::list(std::vector<StudyAxis> axes) {
  std::vector<std::size_t> groups(axes.size(), 0);
  return {std::move(axes), std::move(groups)};
}

StudyCases StudyCases::times(const StudyCases& inner) const {
  std::vector<StudyAxis> axes = axes_;
  axes.insert(axes.end(), inner.axes_.begin(), inner.axes_.end());
  std::vector<std::size_t> groups = groups_;
  for (const std::size_t group : inner.groups_) groups.push_back(groups_.back() + 1 + group);
  return {std::move(axes), std::move(groups)};
}

void StudyCases::require_different_labels() const {
  for (std::size_t first = 0; first < axes_.size();) {
    std::size_t last = first;
    bool named = true;
    for (; last < axes_.size() && groups_[last] == groups_[first]; ++last) named = named && !axes_[last].labels.empty();
    std::set<std::vector<std::string>> known;
    for (std::size_t i = 0; named && i < axes_[first].labels.size(); ++i) {
      std::vector<std::string> labels;
      for (std::size_t axis = first; axis < last; ++axis) labels.push_back(axes_[axis].labels[i]);
      Check{"StudyAxis", axes_[first].name}.that(known.insert(labels).second,
                                                 "the label \"" + labels.front() + "\" appears twice.",
                                                 "Give every value a label of its own.");
    }
    first = last;
  }
}

std::vector<std::size_t> StudyCases::lengths() const {
  std::vector<std::size_t> list(groups_.back() + 1);
  for (std::size_t i = 0; i < axes_.size(); ++i) list[groups_[i]] = axes_[i].values.size();
  return list;
}

std::size_t StudyCases::count() const {
  std::size_t cases = 1;
  for (const std::size_t length : lengths()) cases *= length;
  return cases;
}

std::size_t StudyCases::position(std::size_t axis, std::size_t number) const {
  std::size_t group = groups_[axis];
  for (std::size_t i = axes_.size(); i-- > 0 && groups_[i] > group;)
    if (i + 1 == axes_.size() || groups_[i + 1] != groups_[i]) number /= axes_[i].values.size();
  return number % axes_[axis].values.size();
}

std::size_t StudyCases::index_of(std::string_view axis) const {
  const auto found = std::ranges::find(axes_, axis, &StudyAxis::name);
  if (found != axes_.end()) return static_cast<std::size_t>(found - axes_.begin());
  std::string known;
  for (const StudyAxis& each : axes_) known.append(known.empty() ? "" : ", ").append(each.name);
  throw InputError{"The study has no axis \"" + std::string{axis} + "\". Its axes are: " + known + "."};
}

std::size_t StudyCase::position(std::string_view axis) const {
  return cases_->position(cases_->index_of(axis), number_);
}

double StudyCase::value(std::string_view axis) const {
  return cases_->axes()[cases_->index_of(axis)].values[position(axis)];
}

std::string StudyCase::label(std::string_view axis) const {
  const StudyAxis& found = cases_->axes()[cases_->index_of(axis)];
  const std::size_t at = position(axis);
  return found.labels.empty() ? to_text(found.values[at]) : found.labels[at];
}

std::string StudyCase::description() const {
  std::string text;
  for (const StudyAxis& axis : cases_->axes()) {
    text += (text.empty() ? "" : ", ") + axis.name + " = " + label(axis.name);
    if (axis.labels.empty() && !axis.unit.empty()) text += " " + axis.unit;
  }
  return text;
}

}  // namespace moat
