// Truth by random trial: moat beside an independent reference on random models.
#pragma once

#include <cstdint>
#include <string>

#include "analyses/time_history/transient_options.hpp"

namespace moat {

struct RandomModelsOptions {
  int models = 200;
  std::uint64_t seed = 1;  ///< of the first; the others follow it
  int threads = 2;
  double tolerance = TransientOptions{}.tolerance;  ///< of all settings but the tight one
  std::string csv;                                  ///< file with a row per model and setting; none if empty
};

/// Runs them with default, tight and exact settings, and returns the results as Markdown. No model is left out without
/// notice: models whose reference did not settle, and models that moat refused, are named by their seeds.
std::string run_random_models(const RandomModelsOptions& options);

}  // namespace moat
