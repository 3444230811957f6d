// A plain problem made into one of moat's, with its public elements.
#pragma once

#include <string_view>

#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "plain_model.hpp"

namespace moat::testing {

/// Names of nodes and elements are those of the plain problem.
Model moat_model(const PlainModel& plain);

/// The name of moat's law of that kind.
std::string_view moat_law_name(PlainLawKind kind);

GroundMotion moat_motion(const PlainMotion& plain);

}  // namespace moat::testing
