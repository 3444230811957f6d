// The results of a study.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "output/files/table.hpp"
#include "study/cases.hpp"
#include "study/outcome.hpp"

namespace moat {

/// All cases of a study as one table: a column for every axis, then one for every result, a row for every case.
/// A result that a case does not have, or that failed or is still open, is NaN. Copies share their contents, so that
/// they need no memory.
class StudyResult {
 public:
  /// An axis that is held: its name and a position on it.
  using Fixed = std::vector<std::pair<std::string, std::size_t>>;

  /// All cases are open.
  explicit StudyResult(StudyCases cases);
  /// One outcome for every case.
  StudyResult(StudyCases cases, const std::vector<CaseOutcome>& outcomes);

  /// Gives a case its outcome, in the place of the former one. Copies that were made before stay as they are.
  void set(std::size_t number, CaseOutcome outcome);

  /// All cases, computed or not.
  [[nodiscard]] const StudyCases& cases() const;
  /// The axes of the cases.
  [[nodiscard]] const std::vector<StudyAxis>& axes() const { return cases().axes(); }
  /// The outcome of one case; it is made of the table, where its results are.
  [[nodiscard]] CaseOutcome outcome(std::size_t number) const;
  /// How far a case has come.
  [[nodiscard]] CaseState state(std::size_t number) const;
  /// The wall clock of a case, s.
  [[nodiscard]] double seconds(std::size_t number) const;
  /// A row for every case: its values of the axes and its results, NaN where it has none. Results
  /// have the order in which the cases bring them, whichever was set first.
  [[nodiscard]] const Table& table() const;
  /// The rows of the cases from `first` to that before `last`, with the number of every case before the axes, and its
  /// state, reason, steps, energy error and seconds behind them, for files.
  [[nodiscard]] Table case_table(std::size_t first, std::size_t last) const;
  /// How many cases are in a state.
  [[nodiscard]] std::size_t count(CaseState state) const;
  /// The cases whose axes stand at the given positions, ascending. Throws InputError for an unknown axis.
  [[nodiscard]] std::vector<std::size_t> numbers(const Fixed& fixed = {}) const;
  /// The values of one result in the order of the cases, from those cases whose axes stand at the given positions:
  ///
  ///     result.values("displacement", "base", {{"record", 2}})   // along the other axes
  ///
  /// Throws InputError for an unknown result or axis, and for a result with two units.
  [[nodiscard]] std::vector<double> values(std::string_view quantity, std::string_view where,
                                           const Fixed& fixed = {}) const;

 private:
  struct Contents;
  std::shared_ptr<Contents> contents_;
};

/// Writes case_table() of all cases as CSV. Throws FileError where the file cannot be written.
void write_csv(const StudyResult& result, const std::filesystem::path& path);

/// Some cases of a study failed. The others were computed: `result` has them.
class StudyError : public Error {
 public:
  /// A case without results.
  struct Failure {
    std::size_t number;       ///< of the case
    std::string description;  ///< its axis values
    std::string message;      ///< of the exception
  };
  /// The message names the cases that failed.
  explicit StudyError(StudyResult computed);

  std::vector<Failure> failures;  ///< in the order of the cases
  StudyResult result;             ///< of all cases
};

/// The cases that failed or did not converge, in their order.
std::vector<StudyError::Failure> failures_of(const StudyResult& result);
/// "2 of 40 cases failed.", then a line with number and axis values for each of the first five; empty if none did.
std::string failure_message(const StudyResult& result);

/// A study ended before its last case because StudyOptions::stop asked for it. `result` has the cases up to then.
class StudyStopped : public Error {
 public:
  /// The message counts the cases that are left.
  explicit StudyStopped(StudyResult computed);

  StudyResult result;  ///< of the cases up to then
};

}  // namespace moat
