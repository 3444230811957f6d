// The coefficient of restitution of an impact law, constant or falling with the approach speed.
#pragma once

#include <algorithm>
#include <concepts>
#include <variant>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "base/units.hpp"
#include "materials/contact/estimate.hpp"

namespace moat {

/// A restitution that falls with the approach speed v:
///
///     e(v) = min(largest, e_0 (v/v_0)^(-1/4))
///
/// It is the law of round bodies whose contact yields at a constant pressure p and springs back elastically. The energy
/// m v^2/2 makes a dent of radius a, p pi a^4/(4 R), and in proportion to p^2 a^3/E* comes back: e^2 falls with
/// v^(-1/2) at every size. The defaults are for concrete: 0.86, 0.65, 0.48, 0.40 at 0.1, 0.3, 1, 2 m/s, and 0.9 below
/// 0.082 m/s. Source: this energy balance; Johnson (1985), Contact mechanics, has the same power.
struct FallingRestitution {
  double restitution = 0.65;                                   ///< 0.01 <= e_0 <= largest.
  Speed at_speed = 0.3 * (1.0 * units::m) / (1.0 * units::s);  ///< v_0 > 0 m/s.
  double largest = 0.9;                                        ///< e_0 <= largest <= 1.
};

/// A restitution at an approach speed.
struct RestitutionAtSpeed {
  Speed speed{};             ///< > 0 m/s.
  double restitution = 1.0;  ///< 0 < e <= 1.
};

/// A restitution as tests measure it: linear between the points, constant before the first and after the last.
///
///     .restitution = MeasuredRestitution{{{0.1 * m / s, 0.8}, {1 * m / s, 0.55}, {2 * m / s, 0.5}}}
struct MeasuredRestitution {
  std::vector<RestitutionAtSpeed> points{};  ///< One or more; speeds rise, and restitutions do not.
};

/// Laws whose damping grows as 1/e or faster have, with a smaller restitution, a damping at touch that no step of an
/// analysis can resolve.
inline constexpr double least_restitution_in_divisor = 1e-3;

/// Returns e + change, at least `least` and at most 1; an e outside that range limits it in place of them.
inline double shifted_restitution(double restitution, double change, double least = least_restitution_in_divisor) {
  return std::clamp(restitution + change, std::min(restitution, least), std::max(restitution, 1.0));
}

/// The restitution that an impact law is given. A number and an estimate convert to it: `.restitution = 0.65`.
class Restitution {
 public:
  /// Stays constant, 0 < e <= 1.
  template <class Number>
  requires std::convertible_to<const Number&, double> Restitution(const Number& constant)
      : form_{static_cast<double>(constant)} {}
  /// Falls with the approach speed.
  Restitution(const FallingRestitution& falling) : form_{falling} {}
  /// Follows a table.
  Restitution(const MeasuredRestitution& measured) : form_{measured} {}

  // Defined in the source, because GCC 12 warns of the variant where it inlines these into a script.
  /// Copies.
  Restitution(const Restitution&);
  Restitution(Restitution&&) noexcept;
  /// Copies.
  Restitution& operator=(const Restitution&);
  Restitution& operator=(Restitution&&) noexcept;
  ~Restitution();

  /// Whether it does not depend on the speed.
  [[nodiscard]] bool is_constant() const { return std::holds_alternative<double>(form_); }
  /// Returns e at an approach speed > 0 m/s.
  [[nodiscard]] double at(double approach_speed) const;
  /// Returns the restitution towards which it falls: that of a constant, 0 of one that falls without end.
  [[nodiscard]] double smallest() const;
  /// Returns a restitution whose numbers are all larger by `change`, from 0.001 to 1 (0.01 to 1 for one that falls); a
  /// number outside that range limits it in place of them.
  [[nodiscard]] Restitution changed_by(double change) const;

  /// Throws InputError for a value outside its range, or below `least` where that is above 0, for laws that divide by
  /// it.
  void check(const Check& check, double least = 0.0) const;
  /// Returns it as given. Only a constant is named "restitution", so that no report takes another number for it.
  [[nodiscard]] std::vector<Parameter> parameters() const;

 private:
  std::variant<double, FallingRestitution, MeasuredRestitution> form_;
};

/// Returns the parameters of an impact law, in the order of its fields.
std::vector<Parameter> with_restitution(const Parameter& stiffness, const Restitution& restitution,
                                        const std::vector<Parameter>& others = {});

/// The faces that meet.
enum class Faces {
  concrete,        ///< even faces of concrete
  steel,           ///< even faces of steel
  crushed_corner,  ///< a corner of concrete that crushes
};

/// Returns the usual restitution of studies of pounding, a constant.
Estimate<double> restitution_of(Faces faces);

}  // namespace moat
