// Everything one run of one model under one motion produced, in SI units.
#pragma once

#include <string>
#include <vector>

#include "output/table.hpp"

namespace moat {

/// The largest magnitude a quantity reached over continuous time.
struct Peak {
  std::string quantity;  ///< "displacement", "absolute_acceleration", "drift", "impact_force", ...
  std::string where;     ///< "base", "floor 1", "storey 1", "bearings", "moat", ...
  double value = 0.0;    ///< magnitude, >= 0
  std::string unit;      ///< SI: "m", "m/s^2", "N"
  double time = 0.0;     ///< s; when it was reached
};

/// One contact from touch until the gap opens again.
struct Impact {
  std::string where;                 ///< the gap, for example "moat left"
  double start = 0.0;                ///< s
  double duration = 0.0;             ///< s
  double approach_speed = 0.0;       ///< m/s, at first touch
  double largest_indentation = 0.0;  ///< m
  double largest_force = 0.0;        ///< N
  double rebound_ratio = 0.0;        ///< separation speed over approach speed, as it happened in the building
};

/// What the solution cost.
struct SolverStatistics {
  long accepted_steps = 0;
  long rejected_steps = 0;     ///< cut because Newton did not converge
  long event_solves = 0;       ///< solved again to land on a touch or separation
  long events = 0;             ///< touches, separations and other located changes of regime
  long newton_iterations = 0;
  long factorisations = 0;
  double cpu_seconds = 0.0;
};

/// The motion as it was applied.
struct MotionFacts {
  std::string name;
  double peak_acceleration = 0.0;  ///< m/s^2
  double peak_velocity = 0.0;      ///< m/s
  double time_step = 0.0;          ///< s
  double duration = 0.0;           ///< s
};

/// A period with the name of what vibrates.
struct NamedPeriod {
  std::string name;
  double value = 0.0;  ///< s
};

struct CaseResult {
  std::string title;
  MotionFacts motion;
  std::vector<NamedPeriod> periods;
  std::vector<Peak> peaks;
  std::vector<Impact> impacts;
  Table histories;
  SolverStatistics solver;
  std::vector<std::string> assumptions;  ///< one sentence each: scheme, step, damping, sign conventions ...
};

}  // namespace moat
