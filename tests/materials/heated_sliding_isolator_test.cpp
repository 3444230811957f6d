// Heat of a sliding surface: rests, long motions, and a slider that leaves the centre, against superpositions of the
// rise under a half-space.

#include "moat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr double pi = std::numbers::pi;

// Friction that depends on nothing, so that the flux is known: q = mu p |v|.
HeatedSlidingIsolator constant_friction(Length radius = 10 * cm) {
  const PressureTemperatureVelocity friction{.reference_coefficient = 0.06,
                                             .reference_pressure = 50e6 * N / (m * m),
                                             .slider_radius = radius,
                                             .depends_on_pressure = false,
                                             .depends_on_speed = false,
                                             .weakening = PressureTemperatureVelocity::Weakening::none};
  return HeatedFrictionPendulum{.radius = 2.2352 * m, .friction = friction, .yield_displacement = 1e-6 * mm}.carrying(
      1.5 * MN);
}

// A flux over some time.
struct Heating {
  double flux, start, end;  // W/m^2, s
};
// The rise at the centre of a half-space: 2 q sqrt(D t/pi)/k for a constant flux, superposed.
double rise_at(double time, const std::vector<Heating>& history, const HeatedSlidingIsolator& law) {
  double sum = 0.0;
  for (const auto& [flux, start, end] : history)
    sum += 2.0 * flux * (std::sqrt(std::max(time - start, 0.0)) - std::sqrt(std::max(time - end, 0.0)));
  return law.friction.heating_factor() * sum;
}

// Slides to and fro inside the contact at constant speed.
class ToAndFro {
 public:
  explicit ToAndFro(const HeatedSlidingIsolator& law) : law_{law}, path_{law, 0} {}
  void slide(double time, double speed) {
    const double start = time_;
    constexpr double width = 0.05;
    for (double left = time * speed; left > 1e-12; left -= width) {
      path_.move(path_.deformation() > 0.0 ? path_.deformation() - std::min(left, width)
                                           : path_.deformation() + std::min(left, width),
                 speed, 5);
    }
    time_ += time;
    history_.push_back({0.06 * law_.pressure() * speed, start, time_});
  }
  [[nodiscard]] double rise() const { return path_.state().rise; }
  [[nodiscard]] double exact() const { return rise_at(time_, history_, law_); }
  // After a rest from here, in one step.
  [[nodiscard]] double rise_after(double rest) const {
    HeatedSlidingIsolator::State stuck = path_.state(), cooled;
    stuck.direction = 0;
    stuck.flux = 0.0;
    law_.evaluate(stuck, path_.deformation(), 0.0, {rest, path_.deformation(), 0.0}, cooled);
    return cooled.rise;
  }
  [[nodiscard]] double exact_after(double rest) const { return rise_at(time_ + rest, history_, law_); }

 private:
  HeatedSlidingIsolator law_;
  LawPath<HeatedSlidingIsolator> path_;
  std::vector<Heating> history_;
  double time_ = 0.0;
};

TEST(HeatedSlidingIsolator, CoolsInARestAsAHalfSpace) {
  ToAndFro shock{constant_friction()};
  shock.slide(10.0, 0.25);
  EXPECT_NEAR(shock.rise(), shock.exact(), 2e-3 * shock.exact());
  double before = shock.rise();
  for (const double rest : {0.1, 1.0, 10.0, 100.0, 300.0, 1000.0, 3000.0}) {
    const double rise = shock.rise_after(rest), exact = shock.exact_after(rest);
    EXPECT_NEAR(rise, exact, 3e-3 * exact) << rest;
    EXPECT_LT(rise, before) << rest;
    before = rise;
  }
  // Beyond one hour: the bound of the header.
  for (const double rest : {1e4, 1e5, 1e6})
    EXPECT_NEAR(shock.rise_after(rest), shock.exact_after(rest), std::sqrt(10.0) / 120.0 * shock.rise());
}

// The flux lasts while |d| < r_c sqrt(pi)/2, for every length of steps.
TEST(HeatedSlidingIsolator, HeatsOnlyOverTheCentre) {
  const HeatedSlidingIsolator law = constant_friction(5 * cm);
  const double edge = 0.5 * std::sqrt(pi) * 0.05, speed = 0.4, flux = 0.06 * law.pressure() * speed;
  for (const int pieces : {1, 7, 50}) {
    LawPath<HeatedSlidingIsolator> path{law, 0};
    std::vector<Heating> history;
    double time = 0.0, at = 0.0;
    for (const double target : {2.3 * edge, -1.7 * edge, 0.5 * edge, 1.2 * edge, 0.0, -3.0 * edge, -1.1 * edge}) {
      // Over the centre between both edges.
      const double low = std::clamp(std::min(at, target), -edge, edge),
                   high = std::clamp(std::max(at, target), -edge, edge);
      const double entry = target > at ? low - at : at - high;
      history.push_back({flux, time + entry / speed, time + (entry + high - low) / speed});
      if (high == low) history.pop_back();
      path.move(target, speed, pieces);
      time += std::abs(target - at) / speed;
      at = target;
      const double exact = rise_at(time, history, law);
      EXPECT_NEAR(path.state().rise, exact, 3e-3 * exact) << at << " m, " << pieces << " pieces";
    }
  }
}

TEST(HeatedSlidingIsolator, PassesTheBatteryBeyondTheCentre) {
  HeatedSlidingIsolator law = HeatedFrictionPendulum::typical().carrying(2 * MN);
  law.friction.slider_radius = 5 * cm;
  const SpringTrial trial{.deformation = 0.15, .rate = 0.3, .pieces = 0.0, .one_speed = true, .moves = 100};
  expect_purity(law, trial);
  expect_symmetry(law, trial);
  expect_tangents(law, trial);
  expect_rates_of_quantities(law, trial);
  expect_energy_balance_in_short_steps(
      law, {.deformation = 0.15, .rate = 0.3, .energy = 1e-3, .one_speed = true, .moves = 20});
}

}  // namespace
}  // namespace moat::testing
