// Everything that computes the five-storey building, with the settings it is tried at.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measuring/five_peaks.hpp"
#include "motions/ground_motion.hpp"

namespace moat::performance {

struct Setting {
  std::string name;
  std::function<Peaks()> run;
};

/// Settings that differ in one thing, from the loosest to the tightest.
using Ladder = std::vector<Setting>;

struct Method {
  std::string name;
  std::vector<Ladder> ladders;
};

namespace method_names {
inline constexpr const char *moat_adaptive = "moat adaptive",
                            *moat_recorded = "moat adaptive, everything a script records",
                            *moat_checked = "moat adaptive, everything and error bars", *moat_fixed = "moat fixed step",
                            *moat_exact = "moat exact between events",
                            *moat_exact_recorded = "moat exact between events, everything a script records",
                            *cvode_bdf = "CVODE BDF", *cvode_adams = "CVODE Adams", *arkode = "ARKODE",
                            *cvode_on_model = "CVODE on moat's elements",
                            *arkode_on_model = "ARKODE on moat's elements", *bare_newmark = "bare Newmark, fixed step",
                            *bare_runge_kutta = "bare Runge-Kutta";
}

/// All of them for one motion, which must outlive them. `quick`: every third setting of a ladder.
std::vector<Method> methods(const GroundMotion& motion, bool quick);

/// moat and the bare explicit loop at settings that leave no visible error.
struct References {
  Peaks moat, moat_less_tight, bare;
};
References references(const GroundMotion& motion);

}  // namespace moat::performance
