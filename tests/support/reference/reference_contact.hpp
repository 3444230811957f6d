// Contact forces of the independent reference, written from the papers.
#pragma once

#include "plain_model.hpp"

namespace moat::testing {

/// A contact force with its tangents. Indentation d > 0 m, rate d' in m/s, approach speed v0 in m/s at touch.
///
///     linear   F = k d + c d'
///     hertz    F = k d^1.5 (1 + z d'/v0), |d'/v0| counted as at most 100
///     root     F = k d^1.5 + c d^0.25 d'
struct ReferenceContact {
  enum class Form { linear, hertz, root };
  struct Response {
    double force, by_indentation, by_rate;
  };
  /// A number with its derivative by time.
  struct Rated {
    double value, rate;
  };

  Form form = Form::linear;
  double stiffness = 0.0;      ///< k
  double damping = 0.0;        ///< c or z
  bool ends_by_force = false;  ///< where the force reaches zero, if that is before the gap opens
  bool approach_only = false;  ///< the dashpot acts only in approach

  [[nodiscard]] Response evaluate(double indentation, double rate, double approach_speed, bool approaching) const;
  /// Has the sign of the force and crosses zero with a finite slope; with the time derivative, m or 1.
  [[nodiscard]] Rated push(double indentation, double rate, double acceleration, double approach_speed) const;
  /// Of a free elastic impact of the effective mass, s.
  [[nodiscard]] double duration(double effective_mass, double approach_speed) const;
};

/// The force of a law between two bodies of the effective mass, kg.
ReferenceContact reference_contact(const PlainLaw& law, double effective_mass);

}  // namespace moat::testing
