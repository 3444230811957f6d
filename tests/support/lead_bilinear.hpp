// A bilinear spring led along a path by hand.
#pragma once

#include "materials/bilinear.hpp"

namespace moat::testing {

/// Leads the law straight from one deformation to another, m, with every change of regime at its exact place. Returns
/// its response there and leaves its history in `state`.
inline Response lead(const Bilinear& law, Bilinear::State& state, double from, double to) {
  const double rate = to - from;
  if (state.direction * rate < 0.0) state = law.next_regime(state, from, rate);
  const double reach = rate > 0.0 ? law.yield_displacement.si() : -law.yield_displacement.si();
  if (state.direction == 0 && (to - state.slip - reach) * rate > 0.0)
    state = law.next_regime(state, state.slip + reach, rate);
  Bilinear::State after;
  const Response response = law.evaluate(state, to, rate, after);
  state = after;
  return response;
}

}  // namespace moat::testing
