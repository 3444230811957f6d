// The generalized-alpha method.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analyses/integrators/step_scheme.hpp"
#include "base/check.hpp"

namespace moat {

/// Generalized-alpha (Chung & Hulbert 1993), by its spectral radius r at infinite frequency:
///
///     (1 - am) M a1 + am M a0 + (1 - af) p1 + af p0 = 0,   am = (2 r - 1)/(r + 1),   af = r/(r + 1)
///     beta = (1 - am + af)^2/4,   gamma = 1/2 - am + af
///
/// Second order in displacement and velocity, unconditionally stable; of all such methods it damps slow vibrations
/// least for its damping of fast ones. The unknown a1 belongs to an instant that lies (af - am) h beside the end of the
/// step and is of first order there. Results have the acceleration that balances the forces at the end, of second
/// order. moat's default needs no such damping; use this method to compare with other programs.
struct GeneralizedAlpha {
  static constexpr std::string_view name = "generalized-alpha";

  /// >= 0, <= 1; 1 damps nothing, 0 removes the fastest vibrations in one step.
  double spectral_radius = 0.8;

  [[nodiscard]] std::optional<StepScheme> scheme() const {
    const double r = spectral_radius, of_mass = (2.0 * r - 1.0) / (r + 1.0), of_force = r / (r + 1.0);
    const double gamma = 0.5 - of_mass + of_force;
    return StepScheme{.beta = 0.25 * (gamma + 0.5) * (gamma + 0.5),
                      .gamma = gamma,
                      .mass_share = 1.0 - of_mass,
                      .force_share = 1.0 - of_force};
  }
  void check(const Check& check) const {
    check.that(spectral_radius >= 0.0 && spectral_radius <= 1.0, "integrator.spectral_radius", spectral_radius, "1",
               ">= 0 and <= 1", "0.8 damps a little; 1 damps nothing.");
  }
  [[nodiscard]] std::string description() const {
    return "generalized-alpha method, spectral radius " + to_text(spectral_radius);
  }

  friend bool operator==(const GeneralizedAlpha&, const GeneralizedAlpha&) = default;
};

}  // namespace moat
