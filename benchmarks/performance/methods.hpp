// The programs that compute the five-storey building, with the settings at which they are tried.
#pragma once

#include <optional>
#include <vector>

#include "peers/building.hpp"
#include "peers/ladders.hpp"
#include "peers/opensees.hpp"

namespace moat::performance {

namespace method_names {
inline constexpr const char *moat_adaptive = "moat adaptive",
                            *moat_recorded = "moat adaptive, everything a script records",
                            *moat_checked = "moat adaptive, everything and error bars",
                            *moat_varied = "moat adaptive, everything, error bars and sensitivity",
                            *moat_fixed = "moat fixed step", *moat_exact = "moat exact between events",
                            *moat_exact_recorded = "moat exact between events, everything a script records",
                            *arkode = "ARKODE", *opensees = "OpenSees";
}

/// The ladders of all methods. Case and OpenSees, if it is there, must outlive them.
std::vector<peers::Ladder> methods(const peers::Case& of, const std::optional<peers::OpenSees>& opensees);

/// At settings that leave no visible error: moat twice, and SUNDIALS, whose equations share nothing with moat.
struct References {
  Peaks moat, moat_less_tight, sundials;
};
References references(const peers::Case& of);

}  // namespace moat::performance
