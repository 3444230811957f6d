// The distribution of moat's errors over random models.
#pragma once

#include <cstdint>
#include <string>

namespace moat {

struct RandomModelsOptions {
  int models = 200;
  std::uint64_t seed = 1;  ///< of the first; the others follow it
  int threads = 2;
  std::string csv;  ///< file with a row per model and setting; none if empty
};

/// Runs them and returns the tables as Markdown.
std::string run_random_models(const RandomModelsOptions& options);

}  // namespace moat
