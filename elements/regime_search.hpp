// Where inside a step a law changes its regime.
#pragma once

#include "base/hermite.hpp"
#include "base/root.hpp"
#include "materials/response.hpp"

namespace moat {

/// The point from 0 to `beyond` at which a function falls to `aim`, taken on the far side of the root. `beyond` if the
/// function stays above `aim`, 0 if it starts at or below `aim`.
template <class Function>
double first_fall(const Function& function, double beyond, double aim) {
  constexpr double close = 1e-15;
  const auto above_aim = [&](double x) { return function(x) - aim; };
  if (above_aim(beyond) >= 0.0) return beyond;
  if (above_aim(0.0) <= 0.0) return 0.0;
  return bracket_root(above_aim, 0.0, beyond, close).high;
}

/// The margin of one law along the interpolated deformation of a step, a HermiteCubic or HermiteQuintic.
template <LawWithRegimes Law, class Path>
class MarginPath {
 public:
  /// The law and its history must outlive this object.
  MarginPath(const Law& law, const typename Law::State& committed, const Path& path)
      : law_{&law}, committed_{&committed}, path_{path} {}

  /// At a fraction of the step, m.
  [[nodiscard]] double operator()(double fraction) const {
    return law_->regime_margin(*committed_, path_.value(fraction), path_.rate(fraction));
  }
  /// Fraction of the step at which the margin falls to `aim`, looked for between 0 and `beyond`.
  [[nodiscard]] double first_crossing(double beyond, double aim) const { return first_fall(*this, beyond, aim); }

 private:
  const Law* law_;
  const typename Law::State* committed_;
  Path path_;
};

/// Fraction at which the deformation turns inside a step with these rates at its ends, 0 if it does not. A linear rate
/// is exact for average acceleration, and close enough for others to decide whether to look there.
inline double turning_point(double start_rate, double end_rate) {
  return start_rate * end_rate < 0.0 ? start_rate / (start_rate - end_rate) : 0.0;
}

}  // namespace moat
