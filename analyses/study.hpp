// Parameter studies: the same question for every combination of some parameters.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analyses/transient.hpp"
#include "base/error.hpp"
#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "output/table.hpp"

namespace moat {

/// One parameter that a study varies.
struct StudyAxis {
  std::string name;            ///< "gap", "isolation period", "record"
  std::string unit;            ///< of the values, as tables and messages write it: "cm"; empty for names and counts
  std::vector<double> values;  ///< at least one, all finite
  /// How messages and tables call the values; empty, or one for each value.
  std::vector<std::string> labels{};

  /// An axis of names, for example of records: its values are the positions 0, 1, 2 ...
  static StudyAxis of_names(std::string name, std::vector<std::string> labels);
};

/// `count` values at equal distances, the first `first`, the last `last`. count >= 2.
std::vector<double> linearly_spaced(double first, double last, int count);
/// `count` values at equal ratios; both ends > 0. count >= 2.
std::vector<double> logarithmically_spaced(double first, double last, int count);

/// One combination of axis values.
class StudyCase {
 public:
  StudyCase(const std::vector<StudyAxis>& axes, std::size_t number) : axes_{&axes}, number_{number} {}

  /// Counts from 0; the last axis runs fastest.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Position on an axis, from 0. Throws InputError for an unknown name, as the next two do.
  [[nodiscard]] std::size_t position(std::string_view axis) const;
  /// Value on an axis, in the axis' unit.
  [[nodiscard]] double value(std::string_view axis) const;
  /// "gap = 12 cm, record = KBU000".
  [[nodiscard]] std::string description() const;

 private:
  const std::vector<StudyAxis>* axes_;
  std::size_t number_;
};

/// One result of a case.
struct NamedNumber {
  std::string quantity;  ///< "displacement"
  std::string where;     ///< "base"; may be empty
  std::string unit;      ///< SI symbol
  double value = 0.0;
};
using StudyRecord = std::vector<NamedNumber>;

/// The model and the motion of one case.
struct StudyModel {
  Model model;
  GroundMotion motion;
};

struct StudyOptions {
  /// >= 0. Threads that compute cases; 0: one per core. Results do not depend on it.
  int threads = 0;
  /// How the time history of a StudyModel is computed.
  TransientOptions transient{};
  /// Whether every StudyModel runs a second time with finer steps (analyses/error_bars.hpp), which costs two to three
  /// times as much again. Every peak then has its error, as a result of its own ("displacement_error" of "base"), and
  /// every case the result "sensitive": 1 if it is, 0 if not. Both are NaN where the second run failed.
  bool error_bars = false;
  /// Called after every case with the number of cases done and of all cases, by one thread at a time.
  std::function<void(std::size_t done, std::size_t all)> progress{};
};

/// All cases of a study as one table: a column for every axis, then one for every result, a row for every case.
/// A result that a case does not have, or that failed, is NaN.
class StudyResult {
 public:
  /// An axis that is held: its name and a position on it.
  using Fixed = std::vector<std::pair<std::string, std::size_t>>;

  StudyResult(std::vector<StudyAxis> axes, Table table) : axes_{std::move(axes)}, table_{std::move(table)} {}

  [[nodiscard]] const std::vector<StudyAxis>& axes() const { return axes_; }
  [[nodiscard]] const Table& table() const { return table_; }
  /// The values of one result in the order of the cases, from those cases whose axes stand at the given positions:
  ///
  ///     result.values("displacement", "base", {{"record", 2}})   // along the other axes
  ///
  /// Throws InputError for an unknown result or axis.
  [[nodiscard]] std::vector<double> values(std::string_view quantity, std::string_view where,
                                           const Fixed& fixed = {}) const;

 private:
  std::vector<StudyAxis> axes_;
  Table table_;
};

/// Some cases of a study failed. The others were computed: `result` has them.
class StudyError : public Error {
 public:
  struct Failure {
    std::size_t number;       ///< of the case
    std::string description;  ///< its axis values
    std::string message;      ///< of the exception
  };
  StudyError(std::vector<Failure> failed, StudyResult computed);

  std::vector<Failure> failures;  ///< in the order of the cases
  StudyResult result;
};

/// Computes `compute` for every combination of axis values, on all cores.
///
///     const StudyResult result = run_study(
///         {{.name = "gap", .unit = "cm", .values = linearly_spaced(10, 50, 41)},
///          StudyAxis::of_names("record", {"KBU000", "JEN022"})},
///         [&](const StudyCase& each) {
///           StudyModel study{Model{}, motions[each.position("record")]};
///           const auto building = add(study.model, ShearBuilding{...});
///           add(study.model, Moat{.around = building.base, .clearance = each.value("gap") * cm, ...});
///           return study;
///         });
///
/// The function is called from several threads at once: it may only read shared data. The order of the table is that of
/// the cases. No number depends on the number of threads.
///
/// Throws InputError for an axis without values or a name that appears twice; StudyError after the last case if any
/// case threw.
StudyResult run_study(const std::vector<StudyAxis>& axes, const std::function<StudyRecord(const StudyCase&)>& compute,
                      const StudyOptions& options = {});

/// The same for models: the results are the magnitudes of all peaks, as PeakRecorder names them, the `clearance_left`
/// of every gap (negative: indented by so much) and the number of `impacts`; with StudyOptions::error_bars also their
/// errors:
///
///     result.values("impact_force", "moat");           // N
///     result.values("impact_force_error", "moat");     // N, the first holds to +- this
///     result.values("clearance_left", "moat right");   // m
///     result.values("sensitive", "");                  // 0 or 1
///
/// No histories are kept.
StudyResult run_study(const std::vector<StudyAxis>& axes, const std::function<StudyModel(const StudyCase&)>& make,
                      const StudyOptions& options = {});

/// The results of one case of a study: magnitudes of the peaks of one model under one motion, clearances left, and the
/// number of impacts. With error_bars also "..._error" of peaks and clearances, and "sensitive" (StudyOptions).
StudyRecord peaks_of(Model& model, const GroundMotion& motion, const TransientOptions& options = {},
                     bool error_bars = false);

/// The value of one entry. Throws InputError if there is none of this name and place.
double value_of(const StudyRecord& record, std::string_view quantity, std::string_view where);

}  // namespace moat
