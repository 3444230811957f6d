// One run of a street in a process of its own.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace moat::performance {

struct StreetSetting {
  int buildings = 2;
  int steps_before = 24;  ///< not measured
  int steps = 40;
  /// Also the parts of an iteration, beside the speed of memory.
  bool parts = false;
};

/// Times of one part of an iteration, s, and the bytes that it must touch.
struct StreetPart {
  std::string name;
  double bytes = 0.0;
  std::vector<double> seconds;

  NLOHMANN_DEFINE_TYPE_INTRUSIVE(StreetPart, name, bytes, seconds)
};

struct StreetReport {
  int degrees_of_freedom = 0;
  double build_seconds = 0.0;           ///< of the model
  std::vector<double> step_seconds;     ///< wall clock, of every accepted step measured
  std::vector<double> step_iterations;  ///< Newton iterations of the same steps
  double model_bytes = 0.0;             ///< peak resident, of the whole process up to the finished model
  double peak_bytes = 0.0;              ///< the same, up to the last step
  std::vector<StreetPart> parts;
  std::vector<double> seconds_per_byte;  ///< copying memory, in turn with the parts

  NLOHMANN_DEFINE_TYPE_INTRUSIVE(StreetReport, degrees_of_freedom, build_seconds, step_seconds, step_iterations,
                                 model_bytes, peak_bytes, parts, seconds_per_byte)
};

/// In this process.
StreetReport measure_street(const StreetSetting& setting);

/// By the sub-command `street` of this program, so that the peak of memory is that of this one street. Throws Error
/// where that fails.
StreetReport run_street(const StreetSetting& setting);

}  // namespace moat::performance
