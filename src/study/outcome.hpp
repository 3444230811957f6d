// The outcome of one case of a study.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/files_read.hpp"

namespace moat {

/// One result of a case.
struct NamedNumber {
  std::string quantity;  ///< "displacement"
  std::string where;     ///< "base"; may be empty
  std::string unit;      ///< SI symbol
  double value = 0.0;    ///< in that unit
};
/// The numbers of one case.
using StudyRecord = std::vector<NamedNumber>;

/// The value of one entry. Throws InputError if there is none of this name and place.
double value_of(const StudyRecord& record, std::string_view quantity, std::string_view where);

/// How far a case has come.
enum class CaseState {
  open,           ///< not computed yet
  done,           ///< has its results
  failed,         ///< an exception: bad input, a missing file
  not_converged,  ///< a step of the analysis did not converge; neither a pass nor a failure of the structure
};

/// The end of one case.
struct CaseOutcome {
  CaseState state = CaseState::open;  ///< how far it came
  std::string reason{};               ///< the message of the exception; empty if the case is done
  StudyRecord results{};              ///< empty unless it is done
  /// The files of its motion, and those that were read while it was computed.
  std::vector<FileRead> files{};
  long steps = 0;  ///< of its analysis; 0: not known
  /// Error of the energy balance as a fraction of the largest input or kinetic energy; NaN: not known.
  double energy_error = std::numeric_limits<double>::quiet_NaN();
  double seconds = 0.0;  ///< wall clock
};

/// "open", "done", "failed", "not converged".
std::string_view name_of(CaseState state);

}  // namespace moat
