// How the peaks of a run move when its contacts change.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace moat {

/// A change of all contacts of the model together, and the run with it.
struct ContactVariation {
  std::string parameter;    ///< "stiffness", "restitution", "clearance" or "soil"
  double factor = 1.0;      ///< of the parameter; 1 of "restitution"
  double difference = 0.0;  ///< added to the restitution
  /// The restitutions of the laws in this run, ascending, each once; those that have reached an end of their range
  /// changed by less than the difference. Empty for other parameters.
  std::vector<double> restitutions{};
  std::size_t impacts = 0;  ///< in this run
  /// Place and "same", "fewer" or "more" for its impacts, "appears" where the nominal run had none, "vanishes" where
  /// this one has none; places without impacts in both runs are left out.
  std::vector<std::pair<std::string, std::string>> contact{};
  std::string failure{};  ///< why this run has no results; empty where it has

  /// Whether the parameter is larger than in the nominal run.
  [[nodiscard]] bool increases() const { return factor > 1.0 || difference > 0.0; }

  void archive(auto& archive) {  ///< StateArchive.
    archive(parameter, factor, difference, restitutions, impacts, contact, failure);
  }
};

/// A peak of the nominal run, and its values in the runs with changed contacts.
struct ChangedPeak {
  std::string quantity, where, unit;  ///< as those of Peak
  double value = 0.0;                 ///< with its sign
  /// Estimated numerical error of the value; NaN where it is not known.
  double error = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> changed{};  ///< one for every change, with their signs; NaN where that run failed
  bool of_wall = false;           ///< of a wall or another single body beside buildings

  void archive(auto& archive) { archive(quantity, where, unit, value, error, changed, of_wall); }  ///< StateArchive.
};

/// The runs with changed contacts.
struct ContactSensitivity {
  bool computed = false;          ///< The question is answered, by runs, or without them where nothing came near.
  std::string reason{};           ///< why there are no runs, one sentence; empty with runs and without contacts
  std::size_t runs_left_out = 0;  ///< by the default for large runs; --sensitivity makes them
  bool unsettled = false;         ///< The nominal run is not settled (ErrorBars).
  bool rigid_walls = false;       ///< A contact ends at the ground, which does not give way.
  std::size_t impacts = 0;        ///< in the nominal run
  std::vector<ContactVariation> changes{};    ///< a decrease and an increase of each parameter
  std::vector<ChangedPeak> peaks{};           ///< all peaks of the nominal run
  std::vector<std::string> unchanged_laws{};  ///< laws of contacts without a parameter that can be changed

  void archive(auto& archive) {  ///< StateArchive.
    archive(computed, reason, runs_left_out, unsettled, rigid_walls, impacts, changes, peaks, unchanged_laws);
  }
};

}  // namespace moat
