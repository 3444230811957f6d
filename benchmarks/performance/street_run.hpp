// One run of a street in a process of its own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace moat::performance {

/// What is run.
struct StreetSetting {
  int buildings = 2;
  /// m; TransientOptions::location_tolerance.
  double location_tolerance = 1e-12;
  int steps_before = 0;  ///< not measured
  int steps = 1;
  /// Also the parts of an iteration, beside the speed of memory.
  bool parts = false;
};

/// m; longer than the way of a step, so that touches are taken at the end of the step that sees them.
inline constexpr double street_location_tolerance = 4e-3;

/// Times of one part of an iteration, s, and the bytes that it must touch.
struct StreetPart {
  std::string name;
  double bytes = 0.0;
  std::vector<double> seconds;
};

struct StreetReport {
  int degrees_of_freedom = 0;
  double build_seconds = 0.0, start_seconds = 0.0;  ///< model; analysis up to its first step
  std::vector<double> step_seconds;                 ///< wall clock, of every accepted step measured
  std::vector<double> step_iterations;              ///< Newton iterations of the same steps
  double motion_seconds = 0.0;                      ///< of the motion covered by them
  double solves = 0.0, factorisations = 0.0, events = 0.0, changes = 0.0, contacts_at_end = 0.0;
  double peak_bytes = 0.0;        ///< resident, of the whole process up to the last step
  std::uint64_t fingerprint = 0;  ///< of all bits of the final state
  std::vector<StreetPart> parts;
  std::vector<double> seconds_per_byte;  ///< copying, in turn with the parts
};

/// Without peak_bytes being that of this street alone.
StreetReport measure_street(const StreetSetting& setting);

/// Runs this program again with hidden arguments: the peak of memory is then that of this one street.
/// Throws Error where that fails.
StreetReport run_street(const StreetSetting& setting);

/// What main() does first: where the arguments are those hidden ones, runs the street, writes its report to the
/// standard output and returns the exit code.
std::optional<int> street_process(int argc, char** argv);

}  // namespace moat::performance
