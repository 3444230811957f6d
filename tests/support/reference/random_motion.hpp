// Random ground motions: filtered noise, near-fault pulses, boxes.
#pragma once

#include "plain_model.hpp"
#include "random_draws.hpp"

namespace moat::testing {

/// Sampled at 5, 10 or 20 ms over 4 to 20 s, peak 0.1 to 0.8 g. Half of them are noise, filtered between about 0.2 and
/// 4 Hz, under an envelope; most others near-fault pulses, the rest a constant acceleration with jumps at both ends.
/// Some are cut while they shake: their last sample is not zero.
PlainMotion random_motion(RandomDraws& draws);

}  // namespace moat::testing
