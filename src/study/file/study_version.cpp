#include "study/file/store.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace moat {
namespace {

std::string shortened(const std::string& value) {
  constexpr std::size_t hash_length = 64, shown = 12;
  if (value.empty()) return "none";
  return value.size() == hash_length ? value.substr(0, shown) + "..." : value;
}

std::string names_of(const StudyCases& cases) {
  std::string text;
  for (const StudyAxis& axis : cases.axes()) text += (text.empty() ? "" : ", ") + axis.name;
  return text;
}

/// Values that `one` has and `other` lacks: "KBU000, KBU090".
std::string only_in(const StudyAxis& one, const StudyAxis& other) {
  constexpr std::size_t most_named = 5;
  std::string text;
  std::size_t found = 0;
  for (std::size_t i = 0; i < one.values.size(); ++i) {
    const bool known = one.labels.empty() ? std::ranges::find(other.values, one.values[i]) != other.values.end()
                                          : std::ranges::find(other.labels, one.labels[i]) != other.labels.end();
    if (known || ++found > most_named) continue;
    text += (text.empty() ? "" : ", ") + (one.labels.empty() ? to_text(one.values[i]) : one.labels[i]);
  }
  return found > most_named ? text + " ..." : text;
}

std::string value_differences(const StudyAxis& before, const StudyAxis& now) {
  std::string text = "\n  axis " + now.name + ": its values (" + std::to_string(before.values.size()) + " -> " +
                     std::to_string(now.values.size()) + ")";
  if (const std::string added = only_in(now, before); !added.empty()) text += ", new: " + added;
  if (const std::string gone = only_in(before, now); !gone.empty()) text += ", missing: " + gone;
  return text;
}

}  // namespace

StudyIdentity with_hashes_of_axes(StudyIdentity identity, const StudyCases& cases) {
  for (const StudyAxis& axis : cases.axes())
    for (std::size_t i = 0; i < axis.hashes.size(); ++i)
      identity[axis.name + " " + (axis.labels.empty() ? to_text(axis.values[i]) : axis.labels[i])] = axis.hashes[i];
  return identity;
}

std::string differences(const StudyIdentity& before, const StudyIdentity& now) {
  std::map<std::string, std::pair<std::string, std::string>> all;
  for (const auto& [name, value] : before) all[name].first = value;
  for (const auto& [name, value] : now) all[name].second = value;
  std::string text;
  for (const auto& [name, values] : all)
    if (values.first != values.second)
      text += "\n  " + name + ": " + shortened(values.first) + " -> " + shortened(values.second);
  return text;
}

std::string differences(const StudyCases& before, const StudyCases& now) {
  if (names_of(before) != names_of(now)) return "\n  axes: " + names_of(before) + " -> " + names_of(now);
  std::string text;
  for (std::size_t i = 0; i < before.axes().size(); ++i) {
    const StudyAxis &old = before.axes()[i], &axis = now.axes()[i];
    if (old.unit != axis.unit) text += "\n  axis " + axis.name + ": unit " + old.unit + " -> " + axis.unit;
    if (old.values != axis.values || old.labels != axis.labels) text += value_differences(old, axis);
  }
  if (text.empty() && before.groups() != now.groups()) text = "\n  the way in which axes are combined";
  return text;
}

}  // namespace moat
