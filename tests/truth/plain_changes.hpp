// Plain problems drawn at random, and other views of one.
#pragma once

#include <cstdint>
#include <iosfwd>

#include "outcome.hpp"
#include "plain_model.hpp"
#include "random_cases.hpp"

namespace moat::testing {

/// A plain problem with the seed of random_model() from which it comes.
struct DrawnPlain {
  std::uint64_t seed = 0;
  PlainModel model;
};
std::ostream& operator<<(std::ostream& out, const DrawnPlain& drawn);

/// Buildings on a line with bilinear bearings and storeys, frames given by matrices, and all impact laws. Smaller ones
/// have fewer gaps, dashpots and buildings, and half of the motion.
rc::Gen<DrawnPlain> plain_problems();

Problem problem_of(const PlainModel& plain);

/// Left and right exchanged: names stay.
PlainModel mirrored(PlainModel plain);
/// In units of which `mass` make a kilogram, `time` a second.
PlainModel in_other_units(PlainModel plain, double mass, double time);
/// Nodes and elements in another order.
PlainModel in_another_order(const PlainModel& plain, std::uint64_t seed);
PlainModel without_gaps(PlainModel plain);
/// Bearings and yielding storeys are springs with their stiffness before yield; no gaps.
PlainModel linear(PlainModel plain);

}  // namespace moat::testing
