// The cases of a study: which combinations of parameters are computed.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace moat {

/// One parameter that a study varies: a gap, a period, a record, a law, an angle of incidence, a property bound.
struct StudyAxis {
  std::string name;            ///< "gap", "isolation period", "record"
  std::string unit;            ///< of the values, as tables and messages write it: "cm"; empty for names and counts
  std::vector<double> values;  ///< at least one, all finite
  /// How messages, tables and files call the values; empty, or one for each value.
  std::vector<std::string> labels{};
  /// SHA-256 of the file behind each value, for example of records; empty, or one for each value. A study that goes on
  /// compares them.
  std::vector<std::string> hashes{};

  /// An axis of names, for example of laws or bounds: its values are the positions 0, 1, 2 ...
  static StudyAxis of_names(std::string name, std::vector<std::string> labels);
};

/// Throws InputError for an axis without values or name, with the name of another column of the table (state, seconds),
/// a value that is not finite, or labels or hashes of another number.
void check(const StudyAxis& axis);

/// `count` values at equal distances, the first `first`, the last `last`. count >= 2.
std::vector<double> linearly_spaced(double first, double last, int count);
/// `count` values at equal ratios; both ends > 0. count >= 2.
std::vector<double> logarithmically_spaced(double first, double last, int count);

/// Numbered combinations of axis values. Axes that belong to one group step together, groups step like the digits of a
/// number, the last one fastest:
///
///     StudyCases{gap, record}                             every gap with every record: two groups
///     StudyCases::list({mass, stiffness})                 first with first, second with second: one group
///     random_samples(variables, 50, 1).times({record})    every sample with every record
class StudyCases {
 public:
  /// Every value of each axis with every value of the others. Throws InputError for no axis, an axis that check()
  /// refuses, a name that appears twice, labels that appear twice (in a list: all labels of a case), and more than 1e9
  /// cases.
  StudyCases(std::initializer_list<StudyAxis> axes) : StudyCases{std::vector<StudyAxis>{axes}} {}
  /// Every combination of the axes.
  StudyCases(std::vector<StudyAxis> axes);

  /// Case i takes the i-th value of every axis. Throws as the constructor, and for axes of different length.
  static StudyCases list(std::vector<StudyAxis> axes);
  /// Every case of this with every case of the other, whose axes run faster. Throws as the constructor.
  [[nodiscard]] StudyCases times(const StudyCases& inner) const;

  /// Number of cases.
  [[nodiscard]] std::size_t count() const;
  /// In the order in which names of cases list them.
  [[nodiscard]] const std::vector<StudyAxis>& axes() const { return axes_; }
  /// The group that each axis belongs to, from 0, ascending.
  [[nodiscard]] const std::vector<std::size_t>& groups() const { return groups_; }
  /// The position of a case on the axis with this index.
  [[nodiscard]] std::size_t position(std::size_t axis, std::size_t number) const;
  /// Throws InputError for an unknown name, with the names that there are.
  [[nodiscard]] std::size_t index_of(std::string_view axis) const;

 private:
  StudyCases(std::vector<StudyAxis> axes, std::vector<std::size_t> groups);
  [[nodiscard]] std::vector<std::size_t> lengths() const;
  void require_different_labels() const;

  std::vector<StudyAxis> axes_;
  std::vector<std::size_t> groups_;  // of every axis
};

/// One combination of axis values.
class StudyCase {
 public:
  /// The cases must outlive this one.
  StudyCase(const StudyCases& cases, std::size_t number) : cases_{&cases}, number_{number} {}
  StudyCase(StudyCases&&, std::size_t) = delete;

  /// The cases that this one belongs to.
  [[nodiscard]] const StudyCases& cases() const { return *cases_; }
  /// Counts from 0.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Position on an axis, from 0. Throws InputError for an unknown name, as the next two do.
  [[nodiscard]] std::size_t position(std::string_view axis) const;
  /// Value on an axis, in the axis' unit.
  [[nodiscard]] double value(std::string_view axis) const;
  /// Returns the label on an axis; without labels the value in its shortest form.
  [[nodiscard]] std::string label(std::string_view axis) const;
  /// "gap = 12 cm, record = KBU000".
  [[nodiscard]] std::string description() const;

 private:
  const StudyCases* cases_;
  std::size_t number_;
};

}  // namespace moat
