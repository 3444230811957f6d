// One parameter that a study varies.
#pragma once

#include <string>
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

}  // namespace moat
