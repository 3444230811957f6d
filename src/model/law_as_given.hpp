// The law of an element, for reports.
#pragma once

#include <string>
#include <vector>

#include "base/parameter.hpp"

namespace moat {

/// Name and parameters of a law, for reports.
struct LawAsGiven {
  std::string name;                   ///< as the script calls it
  std::vector<Parameter> parameters;  ///< in SI units
};

}  // namespace moat
