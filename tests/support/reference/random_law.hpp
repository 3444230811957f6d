// Random impact laws.
#pragma once

#include "plain_model.hpp"
#include "random_draws.hpp"

namespace moat::testing {

/// Any of the laws between two bodies of about the effective mass, kg; soft to stiff, restitution 0.15 to 0.95.
PlainLaw random_law(RandomDraws& draws, double effective_mass);

}  // namespace moat::testing
