// Isolators under given motions, against published measurements and comparisons: writes the tables of
// docs/verification/models.md.

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "base/text/number_format.hpp"
#include "base/units.hpp"
#include "documentation_section.hpp"
#include "materials/isolation/heated_friction_pendulum.hpp"
#include "materials/isolation/heated_lead_rubber.hpp"

namespace moat {
namespace {

using namespace units;
constexpr double pi = std::numbers::pi;

template <std::size_t n>
std::string row(const std::string& name, const std::array<double, n>& values, int decimals) {
  std::string text = "| " + name + " |";
  for (const double value : values) text += " " + to_fixed(value, decimals) + " |";
  return text + "\n";
}

// Leads a law in short steps along a motion d(t), d'(t).
template <class Law>
class Driven {
 public:
  explicit Driven(const Law& law) : law_{law} {}
  void step(double deformation, double rate, double length) {
    const double moved = deformation - before_;
    for (int changes = 0; changes < 2 && law_.regime_margin(state_, deformation, std::copysign(rate, moved)) < 0.0;
         ++changes)
      state_ = law_.next_regime(state_, state_.direction == 0 ? deformation : before_, std::copysign(rate, moved));
    typename Law::State trial;
    const double force = law_.evaluate(state_, deformation, rate, Interval{length, before_, rate}, trial).force;
    work_ += 0.5 * (force_ + force) * moved;
    force_ = force;
    state_ = trial;
    before_ = deformation;
  }
  [[nodiscard]] const typename Law::State& state() const { return state_; }
  [[nodiscard]] double force() const { return force_; }
  [[nodiscard]] double work() const { return work_; }

 private:
  Law law_;
  typename Law::State state_{};
  double before_ = 0.0, force_ = 0.0, work_ = 0.0;
};

// Kalpakidis, Constantinou & Whittaker (2010), data digitised by Lu and others (blwam/OpenSees, BoucWenLRB): 25 cycles
// of 0.1153 m at 0.35 Hz.
std::string lead_heating() {
  constexpr std::array<int, 8> cycles{1, 2, 3, 5, 10, 15, 20, 25};
  constexpr std::array<double, 8> measured{93.12, 85.40, 77.57, 68.66, 57.75, 52.75, 49.65, 47.19};
  constexpr std::array<double, 8> measured_force{351.6, 319.4, 295.9, 268.1, 237.7, 223.8, 215.5, 209.5};
  constexpr std::array<double, 8> theory{93.03, 86.98, 81.31, 72.74, 59.92, 52.83, 48.37, 45.30};
  constexpr std::array<double, 8> theory_rise{15.05, 28.20, 39.69, 58.98, 93.56, 116.83, 133.67, 146.46};
  constexpr double frequency = 0.35, amplitude = 0.1153, dashpot = 128e3, w = 2.0 * pi * frequency;
  constexpr int steps = 20000;
  const HeatedLeadRubber law = HeatedLeadRubber::typical();
  Driven<HeatedLeadRubber> bearing{law};
  std::array<double, 8> energy{}, rise{}, strength{}, peak{}, from_measured{};
  std::size_t next = 0;
  for (int cycle = 1; cycle <= cycles.back(); ++cycle) {
    const double before = bearing.work();
    double largest = 0.0;
    for (int i = 1; i <= steps; ++i) {
      const double phase = 2.0 * pi * i / steps, v = amplitude * w * std::cos(phase);
      bearing.step(amplitude * std::sin(phase), v, 1.0 / frequency / steps);
      largest = std::max(largest, std::abs(bearing.force() + dashpot * v));
    }
    if (cycle != cycles[next]) continue;
    // The dashpot of the rubber takes pi c w A^2 in a cycle.
    energy[next] = (bearing.work() - before + pi * dashpot * w * amplitude * amplitude) / 1e3;
    rise[next] = bearing.state().temperature;
    strength[next] = law.strength_at(rise[next]) / 1e3;
    peak[next] = largest / 1e3;
    from_measured[next] = 100.0 * (energy[next] / measured[next] - 1.0);
    if (++next == cycles.size()) break;
  }
  std::string text = "| cycle |";
  for (const int cycle : cycles) text += " " + std::to_string(cycle) + " |";
  text += "\n|---|---|---|---|---|---|---|---|---|\n";
  text += row("measured energy, kJ", measured, 2) + row("theory, independent program, kJ", theory, 2) +
          row("moat, kJ", energy, 2) + row("moat - measured, %", from_measured, 1) +
          row("temperature rise, independent program, K", theory_rise, 2) + row("moat, K", rise, 2) +
          row("strength, moat, kN", strength, 2) + row("measured peak force, kN", measured_force, 1) +
          row("moat, kN", peak, 1);
  return text;
}

// The friction of that comparison where the history of the flux counts in rectangles of 5 ms, each with the friction of
// the step before, and the last one, which has no finite value, is left out: kN at the six instants.
std::array<double, 6> friction_by_rectangles(const PressureTemperatureVelocity& friction, double pressure,
                                             double normal_force) {
  constexpr double h = 5e-3;
  constexpr std::size_t per_row = 50;
  const auto coefficient = [&](double rise) {
    return friction.reference_coefficient * friction.temperature_factor(friction.initial_temperature + rise);
  };
  std::vector<double> fluxes;
  std::array<double, 6> forces{};
  double rise = 0.0;
  for (std::size_t i = 1; i <= 6 * per_row; ++i) {
    const double t = static_cast<double>(i) * h, position = 0.1 * std::sin(pi * t), rate = 0.1 * pi * std::cos(pi * t);
    const bool covers = std::abs(position) < 0.5 * std::sqrt(pi) * friction.slider_radius.si();
    fluxes.push_back(covers ? coefficient(rise) * pressure * std::abs(rate) : 0.0);
    double sum = 0.0;
    for (std::size_t j = 0; j + 1 < fluxes.size(); ++j)
      sum += fluxes[j] * h / std::sqrt(static_cast<double>(i - 1 - j) * h);
    rise = friction.heating_factor() * sum;
    if (i % per_row == 0) forces[i / per_row - 1] = coefficient(rise) * normal_force / 1e3;
  }
  return forces;
}

// MASTODON's comparison of friction pendulums with OpenSees (FPBearingPTV): d = 0.1 m sin(pi t).
std::string friction_heating() {
  struct Comparison {
    std::string name;
    bool pressure, temperature, speed;
    std::array<double, 6> deformations, forces;
  };
  constexpr std::array<double, 6> d{.071130, .100417, .072065, .001364, -.069554, -.099038};
  const std::array<Comparison, 3> comparisons{
      {{"pressure", true, false, false, d, {577216.9, 659761.7, -174325.6, -373251.4, -572779.9, -655873.1}},
       {"temperature", false, true, false, d, {511272.7, 605660.3, -104766.4, -275372.2, -465640.5, -563710.6}},
       {"speed", false, false, true, d, {577270.9, 471244.4, -174379.6, -373305.5, -572834.0, -540853.6}}}};
  std::string text =
      "| friction depends on | t = 0.25 s | 0.5 s | 0.75 s | 1 s | 1.25 s | 1.5 s |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const Comparison& each : comparisons) {
    PressureTemperatureVelocity friction{.reference_coefficient = 0.06,
                                         .reference_pressure = 50e6 * N / (m * m),
                                         .slider_radius = 0.2 * m,
                                         .depends_on_pressure = each.pressure,
                                         .depends_on_speed = each.speed,
                                         .diffusivity = 4.4e-6};
    if (!each.temperature) friction.weakening = PressureTemperatureVelocity::Weakening::none;
    const HeatedSlidingIsolator law =
        HeatedFrictionPendulum{.radius = 2.2352 * m, .friction = friction, .yield_displacement = 1e-3 * mm}.carrying(
            6285710 * N);
    Driven<HeatedSlidingIsolator> bearing{law};
    std::array<double, 6> gold{}, computed{}, celsius{};
    constexpr int steps = 5000, per_row = 250 * 5;
    constexpr double h = 1.0 / steps;
    for (int i = 1; i <= 6 * per_row; ++i) {
      const double t = i * h, position = 0.1 * std::sin(pi * t);
      bearing.step(position, 0.1 * pi * std::cos(pi * t), h);
      if (i % per_row != 0) continue;
      const auto k = static_cast<std::size_t>(i / per_row - 1);
      gold[k] = (each.forces[k] - law.restoring_stiffness * each.deformations[k]) / 1e3;
      computed[k] = (bearing.force() - law.restoring_stiffness * position) / 1e3;
      celsius[k] = friction.initial_temperature + bearing.state().rise;
    }
    text += row(each.name + ": MASTODON, kN", gold, 1) + row(each.name + ": moat, kN", computed, 1);
    if (!each.temperature) continue;
    std::array<double, 6> rectangles = friction_by_rectangles(friction, law.pressure(), law.normal_force);
    for (std::size_t k = 0; k < rectangles.size(); ++k) rectangles[k] = std::copysign(rectangles[k], gold[k]);
    text +=
        row("temperature: rectangles of 5 ms, kN", rectangles, 1) + row("surface, moat, degrees Celsius", celsius, 2);
  }
  return text;
}

}  // namespace
}  // namespace moat

int main(int argc, char** argv) {
  CLI::App app{"Isolators under given motions, against measurements and other programs", "moat bench isolators"};
  bool write_docs = false;
  app.add_flag("--write-docs", write_docs, "write the tables of docs/verification/models.md");
  return moat::run_command(app, "moat bench isolators", argc, argv, [&] {
    const std::string lead = moat::lead_heating(), friction = moat::friction_heating();
    std::cout << lead << "\n" << friction;
    if (!write_docs) return 0;
    moat::replace_section(MOAT_VERIFICATION, "lead heating", lead);
    moat::replace_section(MOAT_VERIFICATION, "friction heating", friction);
    return 0;
  });
}
