#include "output/recorders/floor_spectra.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "message_of.hpp"
#include "moat.hpp"
#include "moved_model.hpp"
#include "small_models.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

/// A floor that an analysis does not move: a free mass, which has the acceleration of the ground.
class ShakenFloor {
 public:
  explicit ShakenFloor(FloorSpectraOptions options) : spectra{std::move(options)} {
    add(model_, Node{.name = "floor", .mass = 1 * kg, .free = true});
    state_.emplace(model_);
  }

  void start(double acceleration) { spectra.start(view(acceleration)); }
  void step(double length, double acceleration) {
    move_to(*state_, {}, {}, length);
    state_->commit();
    spectra.step(view(acceleration));
  }
  void jump(double acceleration) { spectra.event(view(acceleration), {}); }

  FloorSpectra spectra;

 private:
  [[nodiscard]] StepView view(double acceleration) const { return {model_, *state_, {acceleration}}; }
  Model model_;
  std::optional<AnalysisState> state_;
};

// The largest response to a pulse that jumps to `height` and then falls straight to zero, without damping.
double pseudo_acceleration_of_falling_pulse(double height, double duration, double period) {
  const double w = 2.0 * std::numbers::pi / period;
  const auto value = [&](double t) { return 1.0 - t / duration - std::cos(w * t) + std::sin(w * t) / (w * duration); };
  const auto rate = [&](double t) { return -1.0 / duration + w * std::sin(w * t) + std::cos(w * t) / duration; };
  double largest = std::hypot(value(duration), rate(duration) / w);
  constexpr int parts = 100'000;
  for (int i = 0; i <= parts; ++i) largest = std::max(largest, std::abs(value(duration * i / parts)));
  return height * largest;
}

TEST(FloorSpectra, FollowJumpsExactly) {
  constexpr double height = 30.0, duration = 0.04;
  const std::vector<Time> periods{20 * ms, 50 * ms, 75 * ms, 0.1 * s, 0.4 * s, 3 * s};
  ShakenFloor floor{{.dampings = {0.0}, .periods = periods, .absolute_acceleration = true}};
  floor.start(0.0);
  double time = 0.0;
  const auto step_to = [&](double end, double acceleration) {
    floor.step(end - time, acceleration);
    time = end;
  };
  step_to(1.9983, 0.0);
  step_to(1.9999, 0.0);
  floor.jump(height);
  for (const double passed : {0.003, 0.003 + 1e-9, 0.0071, 0.019, 0.0200001, 0.031, duration})
    step_to(1.9999 + passed, height * (1.0 - passed / duration));
  step_to(2.1, 0.0);
  const std::vector<FloorSpectrum> found = floor.spectra.spectra();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].where(), "floor, 0 %");
  const ResponseSpectrum& spectrum = found[0].spectrum;
  // Rows every 10 ms, with the value before the jump at its instant, for comparison.
  const std::vector<double> rows{0.0, 0.75 * height, 0.5 * height, 0.25 * height, 0.0, 0.0};
  const ResponseSpectrum of_rows = response_spectrum({"rows", 0.01, rows}, periods, 0.0);
  double lost = 0.0;
  for (std::size_t i = 0; i < periods.size(); ++i) {
    const double exact = pseudo_acceleration_of_falling_pulse(height, duration, periods[i].si());
    EXPECT_NEAR(spectrum.pseudo_acceleration[i], exact, 1e-5 * exact) << periods[i].si();
    EXPECT_NEAR(spectrum.absolute_acceleration[i], exact, 1e-5 * exact) << "without damping they are the same";
    EXPECT_NEAR(spectrum.displacement[i], exact * std::pow(periods[i].si() / (2.0 * pi), 2), 1e-5 * exact);
    lost = std::max(lost, 1.0 - of_rows.pseudo_acceleration[i] / exact);
  }
  EXPECT_GT(lost, 0.13) << "rows lose so much";
}

TEST(FloorSpectra, AreResponseSpectraOfTheSameMotionInUnequalSteps) {
  const GroundMotion motion = near_fault_pulse({.pulse_period = 0.8 * s, .time_step = 20 * ms}).scaled_to_pga(0.4 * g);
  ShakenFloor floor{{.dampings = {0.0, 0.05, 0.3}, .absolute_acceleration = true}};
  const std::span<const double> samples = motion.samples();
  std::mt19937 random{7};
  floor.start(samples[0]);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double cut = std::uniform_real_distribution{0.0, 1.0}(random);
    if (i % 3 != 0) floor.step(0.02 * cut, samples[i - 1] + cut * (samples[i] - samples[i - 1]));
    floor.step(i % 3 != 0 ? 0.02 * (1.0 - cut) : 0.02, samples[i]);
  }
  const std::vector<FloorSpectrum> found = floor.spectra.spectra();
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[1].where(), "floor, 5 %");
  for (const FloorSpectrum& each : found) {
    const ResponseSpectrum& spectrum = each.spectrum;
    ASSERT_EQ(spectrum.period.size(), 100u);
    EXPECT_EQ(spectrum.period.front(), 0.02);
    EXPECT_EQ(spectrum.period.back(), 10.0);
    EXPECT_EQ(to_text(spectrum.period[1]), "0.0213");
    const std::vector<Time> periods{spectrum.period.begin(), spectrum.period.end()};
    const ResponseSpectrum expected = response_spectrum(motion, periods, spectrum.damping_ratio);
    for (std::size_t i = 0; i < periods.size(); ++i) {
      EXPECT_NEAR(spectrum.pseudo_acceleration[i], expected.pseudo_acceleration[i],
                  1e-5 * expected.pseudo_acceleration[i]);
      EXPECT_NEAR(spectrum.absolute_acceleration[i], expected.absolute_acceleration[i],
                  1e-5 * expected.absolute_acceleration[i]);
    }
  }
}

// The largest values come during the free vibration after a short push.
TEST(FloorSpectra, AreTheSameWithoutAbsoluteAccelerations) {
  std::vector<std::vector<double>> pseudo;
  for (const bool absolute : {true, false}) {
    ShakenFloor floor{{.periods = {0.1 * s, 0.5 * s, 2 * s}, .absolute_acceleration = absolute}};
    floor.start(0.0);
    for (const double acceleration : {3.0, -1.0, 2.0, 0.0}) floor.step(0.02, acceleration);
    const ResponseSpectrum spectrum = floor.spectra.spectra().at(0).spectrum;
    EXPECT_EQ(spectrum.absolute_acceleration.empty(), !absolute);
    pseudo.push_back(spectrum.pseudo_acceleration);
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(pseudo[0][i], pseudo[1][i], 1e-5 * pseudo[0][i]);
  EXPECT_GT(pseudo[0][2], 0.0);
}

TEST(FloorSpectra, OfAFloorOnAStiffSpringAreThoseOfTheGround) {
  Model model;
  const NodeId floor = add(model, Node{.name = "floor", .mass = 1 * tonne});
  const double stiffness = 1e3 * std::pow(2.0 * pi / 2e-3, 2);
  add(model, ShearSpring{.name = "post", .lower = ground, .upper = floor, .stiffness = stiffness * N / m});
  add(model, ViscousDamper{.name = "damper",
                           .lower = ground,
                           .upper = floor,
                           .damping = 2.0 * 0.3 * std::sqrt(stiffness * 1e3) * N * s / m});
  const GroundMotion motion = near_fault_pulse().scaled_to_pga(0.4 * g);
  FloorSpectra spectra{};
  Transient analysis{model, motion};
  analysis.attach(spectra);
  analysis.run();
  const ResponseSpectrum found = spectra.spectra().at(0).spectrum;
  const std::vector<Time> periods{found.period.begin(), found.period.end()};
  const ResponseSpectrum of_ground = response_spectrum(motion, periods, 0.05);
  for (std::size_t i = 0; i < periods.size(); ++i)
    EXPECT_NEAR(found.pseudo_acceleration[i], of_ground.pseudo_acceleration[i], 1e-3 * of_ground.pseudo_acceleration[i])
        << periods[i].si();
}

// The largest pseudo-acceleration of an oscillator of 5 % damping, by the method of Runge and Kutta.
double by_runge_kutta(const std::function<double(double)>& acceleration, double duration, double period) {
  const double w = 2.0 * pi / period;
  double u = 0.0, v = 0.0, largest = 0.0;
  const auto march = [&](double start, double end, const std::function<double(double)>& a) {
    constexpr int steps = 20'000;
    const double h = (end - start) / steps;
    const auto rate = [&](double t, double at, double speed) { return -a(t) - 0.1 * w * speed - w * w * at; };
    for (int i = 0; i < steps; ++i) {
      const double t = start + i * h;
      const double a1 = rate(t, u, v), v2 = v + 0.5 * h * a1, a2 = rate(t + 0.5 * h, u + 0.5 * h * v, v2);
      const double v3 = v + 0.5 * h * a2, a3 = rate(t + 0.5 * h, u + 0.5 * h * v2, v3);
      const double v4 = v + h * a3, a4 = rate(t + h, u + h * v3, v4);
      u += h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4);
      v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
      largest = std::max(largest, w * w * std::abs(u));
    }
  };
  march(0.0, duration, acceleration);
  march(duration, duration + period, [](double) { return 0.0; });
  return largest;
}

TEST(FloorSpectra, OfAnImpactWhoseForceJumpsAreExact) {
  // The force of a Kelvin contact that may pull: a damped half-wave, which jumps at both ends.
  constexpr double mass = 1e5, speed = 0.5, ratio = 0.2, frequency = 60.0;
  const double damped = frequency * std::sqrt(1.0 - ratio * ratio), duration = pi / damped;
  const double restitution = std::exp(-pi * ratio / std::sqrt(1.0 - ratio * ratio));
  const auto acceleration = [&](double t) {
    const double fading = speed * std::exp(-ratio * frequency * t), sine = std::sin(damped * t) / damped;
    const double d = fading * sine, d_rate = fading * (std::cos(damped * t) - ratio * frequency * sine);
    return -frequency * frequency * d - 2.0 * ratio * frequency * d_rate;
  };
  const Model model = body_before_wall(
      Kelvin{.stiffness = mass * frequency * frequency * N / m, .restitution = restitution, .may_pull = true}, mass,
      speed, 0.1);
  const CaseResult result = run_case(model, {"rest", 0.02, std::vector<double>(26, 0.0)});
  ASSERT_EQ(result.impacts.size(), 1u);
  ASSERT_EQ(result.floor_spectra.size(), 1u);
  const ResponseSpectrum& spectrum = result.floor_spectra[0].spectrum;
  const std::vector<Time> periods{spectrum.period.begin(), spectrum.period.end()};
  const ResponseSpectrum of_rows =
      response_spectrum({"rows", 0.02, result.histories.values("absolute_acceleration", "body")}, periods, 0.05);
  double lost = 0.0;
  for (std::size_t i = 0; i < periods.size(); i += 9) {
    const double exact = by_runge_kutta(acceleration, duration, periods[i].si());
    EXPECT_NEAR(spectrum.pseudo_acceleration[i], exact, 2e-3 * exact) << periods[i].si();
    lost = std::max(lost, 1.0 - of_rows.pseudo_acceleration[i] / exact);
  }
  EXPECT_GT(lost, 0.13) << "rows every 20 ms lose so much";
}

// A building with eccentric masses and its motion, turned by 90 degrees where wanted, in steps of 2 ms.
CaseResult turned_run(Angle angle, FloorSpectra& spectra) {
  PlanBuilding building = small_plan_building(
      1, {.yield_force = 250 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 3 * MN / m});
  building.outline = turned(rectangle(20 * m, 12 * m), angle);
  building.mass_offset = turned(PlanPosition{2 * m, 1 * m}, angle);
  Model model;
  add(model, building);
  const GroundMotion pulse = near_fault_pulse({.time_step = 20 * ms}).scaled_to_pga(0.4 * g);
  CaseRun run{model,
              PlanMotion{pulse, pulse.scaled_by(-0.4), 20 * deg + angle},
              {.transient = {.step = 2 * ms}, .history_interval = 2 * ms, .error_bars = ErrorBarMode::never}};
  run.attach(spectra);
  run.run();
  return run.result();
}

TEST(FloorSpectra, InPlanTurnWithTheModel) {
  const FloorSpectraOptions options{.floors = {"floor 1"}, .periods = {0.1 * s, 0.3 * s, 1 * s}, .corners = true};
  FloorSpectra given{options}, turned{options};
  const CaseResult result = turned_run(0 * deg, given), other = turned_run(90 * deg, turned);
  ASSERT_EQ(result.floor_spectra.size(), 10u) << "centre and four corners along x and y";
  EXPECT_EQ(result.floor_spectra[5].where(), "floor 1, corner 2, y, 5 %");
  const Table& rows = result.histories;
  const PlanOutline outline = rectangle(20 * m, 12 * m);
  for (std::size_t k = 0; k < 10; k += 2) {
    const ResponseSpectrum &x = result.floor_spectra[k].spectrum, &y = result.floor_spectra[k + 1].spectrum;
    // The accelerations of a rigid floor at this corner, from the rows, which are the steps.
    const PlanVector arm = k == 0 ? PlanVector{} : outline.corner(k / 2 - 1) - PlanVector{2.0, 1.0};
    std::vector<double> along_x = rows.values("absolute_acceleration_x", "floor 1"),
                        along_y = rows.values("absolute_acceleration_y", "floor 1");
    const std::vector<double>& angular = rows.values("angular_acceleration", "floor 1");
    for (std::size_t i = 0; i < angular.size(); ++i) {
      along_x[i] -= arm.y * angular[i];
      along_y[i] += arm.x * angular[i];
    }
    const ResponseSpectrum right_x = response_spectrum({"x", 2e-3, along_x}, options.periods, 0.05),
                           right_y = response_spectrum({"y", 2e-3, along_y}, options.periods, 0.05);
    for (std::size_t i = 0; i < options.periods.size(); ++i) {
      const double of_x = x.pseudo_acceleration[i], of_y = y.pseudo_acceleration[i];
      EXPECT_NEAR(of_x, right_x.pseudo_acceleration[i], 1e-4 * of_x) << result.floor_spectra[k].where();
      EXPECT_NEAR(of_y, right_y.pseudo_acceleration[i], 1e-4 * of_y) << result.floor_spectra[k + 1].where();
      EXPECT_NEAR(other.floor_spectra[k + 1].spectrum.pseudo_acceleration[i], of_x, 1e-6 * of_x);
      EXPECT_NEAR(other.floor_spectra[k].spectrum.pseudo_acceleration[i], of_y, 1e-6 * of_y);
    }
  }
}

std::string refusal_of(const FloorSpectraOptions& options) {
  return message_of<InputError>([&] {
    Model model;
    add(model, ShearBuilding{.storeys = 2, .floor_mass = 500 * tonne, .storey_stiffness = 1 * GN / m});
    FloorSpectra spectra{options};
    const AnalysisState state{model};
    spectra.start({model, state});
  });
}

TEST(FloorSpectra, RefuseBadInput) {
  EXPECT_EQ(refusal_of({.dampings = {}}), "FloorSpectra: dampings is empty. Leave it out for 5 %.");
  EXPECT_EQ(refusal_of({.dampings = {0.02, 5.0}}),
            "FloorSpectra: dampings = 5 is not allowed; it must be >= 0 and < 1. Give 5 % as 0.05.");
  EXPECT_NE(refusal_of({.periods = {0 * s, 1 * s}}).find("periods = 0 s is not allowed"), std::string::npos);
  EXPECT_EQ(refusal_of({.periods = {1 * s, 0.5 * s}}),
            "FloorSpectra: periods do not ascend. Give each once, the shortest first.");
  EXPECT_EQ(refusal_of({.floors = {"roof"}}),
            "FloorSpectra: the model has no floor \"roof\". It has \"floor 1\", \"floor 2\".");
  EXPECT_EQ(refusal_of({.floors = {"floor 1", "floor 1"}}),
            "FloorSpectra: floors has \"floor 1\" twice. Name it once.");
  EXPECT_EQ(refusal_of({.corners = true}),
            "FloorSpectra: corners are wanted, but no floor has any. Give Diaphragm::outline.");
}

TEST(FloorSpectra, AreEmptyBeforeTheStart) { EXPECT_TRUE(FloorSpectra{}.spectra().empty()); }

}  // namespace
}  // namespace moat
