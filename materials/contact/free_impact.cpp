#include "materials/contact/free_impact.hpp"

#include <array>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>  // the tolerances count
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/root.hpp"

namespace moat {
namespace {

namespace odeint = boost::numeric::odeint;

// Indentation over v0 T and rate over v0, in time over T, with the time scale T of the contact.
using Motion = std::array<double, 2>;

}  // namespace

double delivered_restitution(const FreeImpact& impact) {
  constexpr double tolerance = 1e-12;
  constexpr int most_steps = 100000;

  const Check check{"FreeImpact", ""};
  check.positive("effective_mass", impact.effective_mass, "kg", "1/m = 1/m_1 + 1/m_2 of both bodies.");
  check.positive("approach_speed", impact.approach_speed, "m/s");
  check.positive("duration", impact.duration, "s", "It is a time scale of the contact.");
  const double speed = impact.approach_speed, depth = speed * impact.duration;
  const double per_force = impact.duration / (impact.effective_mass * speed);
  const auto slope = [&](const Motion& motion, Motion& by_time, double) {
    by_time = {motion[1], -per_force * impact.force(depth * motion[0], speed * motion[1])};
  };
  const auto margin = [&](const Motion& motion) { return impact.margin(depth * motion[0], speed * motion[1]); };

  auto stepper = odeint::make_controlled(tolerance, 0.0, odeint::runge_kutta_dopri5<Motion>{});
  Motion motion{0.0, 1.0};
  double time = 0.0;
  // Laws whose damping grows from zero may have an infinite slope at touch: begin with a short step.
  double step = 1e-6;
  for (int count = 0; count < most_steps; ++count) {
    const Motion start = motion;
    const double start_time = time;
    if (stepper.try_step(slope, motion, time, step) == odeint::fail || margin(motion) > 0.0) continue;
    // The length of the last step with which the contact ends. At touch the margin is zero, too.
    Motion end = motion;
    bracket_root(
        [&](double length) {
          if (length == 0.0) return 1.0;
          odeint::runge_kutta_dopri5<Motion>{}.do_step(slope, start, start_time, end, length);
          return margin(end);
        },
        0.0, time - start_time);
    if (!impact.goes_on(depth * end[0], speed * end[1])) return -end[1];
    motion = end;
    step = 1e-6;
  }
  throw Error{"The contact of a free impact does not end. Check the damping of the impact law."};
}

}  // namespace moat
