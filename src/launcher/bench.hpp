// moat bench
#pragma once

#include <string>
#include <vector>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Builds the benchmark that the first word names and becomes it; the other words are its options. Throws Stop for an
/// unknown name and where something does not build.
[[noreturn]] void run_benchmark(const Places& places, const std::vector<std::string>& words);

}  // namespace moat::launcher
