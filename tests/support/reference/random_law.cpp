#include "random_law.hpp"

#include <algorithm>

namespace moat::testing {
namespace {

bool may_pull(PlainLawKind kind) {
  switch (kind) {
    case PlainLawKind::linear_elastic:
    case PlainLawKind::modified_linear_viscoelastic:
    case PlainLawKind::hertz:
    case PlainLawKind::nonlinear_viscoelastic:
      return false;
    default:
      return true;
  }
}

// The laws whose stiffness is in N/m^1.5 stand behind those in N/m.
bool is_hertz(PlainLawKind kind) { return kind >= PlainLawKind::hertz; }

}  // namespace

PlainLaw random_law(RandomDraws& draws, double effective_mass) {
  PlainLaw law;
  law.kind = static_cast<PlainLawKind>(draws.integer(0, plain_law_kinds - 1));
  // Elastic contacts of 20 to 300 ms for buildings, of 1 to 30 ms for light bodies.
  const bool light = effective_mass < 5e4;
  law.stiffness = is_hertz(law.kind) ? draws.decades(1e8, 2e10) : draws.decades(5e7, 5e9);
  if (light) law.stiffness = rounded(law.stiffness * std::max(effective_mass / 5e4, 0.02));
  law.restitution = draws.chance(0.1) ? draws.uniform(0.15, 0.3) : draws.uniform(0.3, 0.95);
  law.damping_ratio = draws.chance(0.1) ? draws.uniform(0.6, 1.2) : draws.uniform(0.02, 0.6);
  if (may_pull(law.kind) && draws.chance(0.25)) law.acts = PlainDamping::may_pull;
  if (law.kind == PlainLawKind::kelvin_by_damping_ratio && law.acts == PlainDamping::may_pull)
    law.damping_ratio = std::min(law.damping_ratio, 0.9);
  if (law.kind == PlainLawKind::modified_hertz_damp_printed) {
    // Below, its damping is many times critical.
    law.restitution = std::max(law.restitution, law.acts == PlainDamping::may_pull ? 0.42 : 0.25);
    if (law.acts == PlainDamping::throughout && draws.chance(0.6)) law.acts = PlainDamping::approach_only;
  }
  return law;
}

}  // namespace moat::testing
