// The limits of the laws of a model, for its report.
#pragma once

#include <string>
#include <vector>

#include "output/files/model_facts.hpp"

namespace moat {

/// "HertzDamp: ..." for every law of the model that states an assumption, in the order of the lists of laws; then a
/// sentence for every law that lists no parameters.
std::vector<std::string> law_assumptions(const ModelFacts& model);

}  // namespace moat
