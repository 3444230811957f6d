// Random pounding problems.
#pragma once

#include <cstdint>

#include "plain_model.hpp"

namespace moat::testing {

/// One to three buildings of one to nine nodes side by side, isolated (bearings at the base, some
/// between two storeys) or fixed, with storeys that yield or do not, damping 0.5 to 10 %; rigid and flexible walls
/// beside them on one or both sides; gaps between them at floors and mid-column; light bodies of 100 kg to 10 t,
/// coupled and not; all impact laws, soft and stiff; random_motion(). Clearances are shares of the displacement without
/// gaps, so that most models pound and some do not. The same numbers for a seed everywhere.
PlainModel random_model(std::uint64_t seed);

}  // namespace moat::testing
