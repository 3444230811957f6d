// One run of a street in a process of its own.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace moat::performance {

struct StreetSetting {
  int buildings = 2;
  int steps_before = 24;  ///< not measured
  int steps = 40;
};

struct StreetReport {
  int degrees_of_freedom = 0;
  double build_seconds = 0.0;           ///< of the model
  std::vector<double> step_seconds;     ///< wall clock, of every accepted step measured
  std::vector<double> step_iterations;  ///< Newton iterations of the same steps
  double peak_bytes = 0.0;              ///< peak resident, of the whole process

  NLOHMANN_DEFINE_TYPE_INTRUSIVE(StreetReport, degrees_of_freedom, build_seconds, step_seconds, step_iterations,
                                 peak_bytes)
};

/// In this process.
StreetReport measure_street(const StreetSetting& setting);

/// By the sub-command `street` of this program, so that the peak of memory is that of this one street. Throws Error
/// where that fails.
StreetReport run_street(int buildings);

}  // namespace moat::performance
