// The options of an analysis, for files and reports.
#pragma once

#include <string>
#include <vector>

#include "base/parameter.hpp"

namespace moat {

/// The options of an analysis, as they were given in code and on the command line.
struct AnalysisFacts {
  std::string integrator{};          ///< its name, or its description where it has parameters
  std::string events{};              ///< "located" or "at_end_of_step"
  std::string error_bars{};          ///< "automatic", "always" or "never"
  std::vector<Parameter> options{};  ///< all numbers of TransientOptions, CaseOptions and the scheme, by their names
};

}  // namespace moat
