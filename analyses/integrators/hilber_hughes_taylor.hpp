// The HHT-alpha method.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "analyses/integrators/step_scheme.hpp"
#include "base/check.hpp"

namespace moat {

/// HHT-alpha (Hilber, Hughes & Taylor 1977): Newmark's method whose forces are averaged over the step,
///
///     M a1 + (1 + alpha) p1 - alpha p0 = 0,   beta = (1 - alpha)^2/4,   gamma = 1/2 - alpha
///
/// Second order, unconditionally stable. It damps vibrations that the step does not resolve: the spectral radius at
/// infinite frequency is (1 + alpha)/(1 - alpha). Results have the acceleration that balances the forces at the end of
/// the step, which is of second order; a1 is of first order. moat's default needs no such damping; use this method to
/// compare with other programs.
struct HilberHughesTaylor {
  static constexpr std::string_view name = "hht-alpha";

  /// >= -1/3, <= 0; 0 is average acceleration.
  double alpha = -0.1;

  [[nodiscard]] std::optional<StepScheme> scheme() const {
    return StepScheme{.beta = 0.25 * (1.0 - alpha) * (1.0 - alpha), .gamma = 0.5 - alpha, .force_share = 1.0 + alpha};
  }
  void check(const Check& check) const {
    check.that(alpha >= -1.0 / 3.0 && alpha <= 0.0, "integrator.alpha", alpha, "1", ">= -1/3 and <= 0",
               "-0.1 damps a little; 0 is average acceleration.");
  }
  [[nodiscard]] std::string description() const { return "HHT-alpha method, alpha = " + to_text(alpha); }

  friend bool operator==(const HilberHughesTaylor&, const HilberHughesTaylor&) = default;
};

}  // namespace moat
