#include "performance/methods.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "measuring/measure.hpp"
#include "performance/moat_histories.hpp"
#include "performance/sundials.hpp"

namespace moat::performance {
namespace {

using peers::Case;
using peers::History;
using peers::Ladder;
using peers::Setting;

/// One way to run moat with options of an analysis.
using MoatRun = std::function<Peaks(const TransientOptions&)>;

// The mean of several short runs, so that clock and processor settle.
Setting timed(std::string name, std::function<Peaks()> run) {
  return {std::move(name), [run = std::move(run)] {
            constexpr double long_enough = 5e-3;
            constexpr int most_runs = 20;
            History history;
            int runs = 0;
            while (runs < most_runs && history.seconds < long_enough) {
              const double start = seconds();
              history.peaks = run();
              history.seconds += seconds() - start;
              ++runs;
            }
            history.seconds /= runs;
            return history;
          }};
}

// Contacts are divided in step with the tolerance: the error of both falls with the square of the step.
constexpr double middle_tolerance = 1.2e-4;
constexpr int middle_steps_per_contact = 32, fewest_steps_per_contact = 4;

int steps_for(double tolerance) {
  const double steps = middle_steps_per_contact * std::sqrt(middle_tolerance / tolerance);
  return std::max(fewest_steps_per_contact, static_cast<int>(std::lround(steps)));
}
double tolerance_for(int steps_per_contact) {
  const double ratio = static_cast<double>(middle_steps_per_contact) / steps_per_contact;
  return std::min(middle_tolerance * ratio * ratio, 0.5);
}

Ladder moat_adaptive(const char* name, const MoatRun& run) {
  Ladder ladder{name, {}};
  for (const double tolerance : {1e-2, 5.6e-3, 3e-3, 1.8e-3, 1e-3, 6e-4, 3.6e-4, 2e-4, 1.2e-4, 6e-5, 3e-5, 1.2e-5})
    ladder.settings.push_back(timed("tolerance " + to_text(tolerance), [run, tolerance] {
      return run({.tolerance = tolerance, .steps_per_contact = steps_for(tolerance)});
    }));
  return ladder;
}

Ladder moat_fixed(const Case& of, const Newmark& newmark, const MoatRun& run) {
  Ladder ladder{method_names::moat_fixed, {}};
  for (const int divisions : {1, 2, 3, 4, 6, 8, 12, 16}) {
    const Time step = of.motion.time_step() / divisions * units::s;
    ladder.settings.push_back(timed(newmark.description() + ", " + to_text(1e3 * step.si()) + " ms",
                                    [run, newmark, step] { return run({.integrator = newmark, .step = step}); }));
  }
  return ladder;
}

Ladder moat_exact(const char* name, const MoatRun& run) {
  Ladder ladder{name, {}};
  for (const int steps : {4, 6, 8, 11, 16, 23, 32, 45, 64, 128})
    ladder.settings.push_back(timed(to_text(steps) + " steps per contact", [run, steps] {
      return run({.integrator = ExactBetweenEvents{}, .tolerance = tolerance_for(steps), .steps_per_contact = steps});
    }));
  return ladder;
}

Ladder arkode(const Case& of, SundialsMethod method, const std::string& name) {
  Ladder ladder{method_names::arkode, {}};
  for (const double tolerance : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6})
    ladder.settings.push_back(timed(name + ", tolerance " + to_text(tolerance),
                                    [&of, method, tolerance] { return sundials_peaks(of.motion, method, tolerance); }));
  return ladder;
}

}  // namespace

std::vector<Ladder> methods(const Case& of, const std::optional<peers::OpenSees>& opensees) {
  namespace names = method_names;
  const MoatRun peaks = [&of](const TransientOptions& options) { return moat_peaks(of.model, of.motion, options); };
  const auto everything = [&of](ErrorBarMode error_bars,
                                ContactSensitivityMode sensitivity = ContactSensitivityMode::never) -> MoatRun {
    return [&of, error_bars, sensitivity](const TransientOptions& options) {
      return moat_case(of.model, of.motion, options, error_bars, sensitivity);
    };
  };
  std::vector<Ladder> list{
      moat_adaptive(names::moat_adaptive, peaks),
      moat_adaptive(names::moat_recorded, everything(ErrorBarMode::never)),
      moat_adaptive(names::moat_checked, everything(ErrorBarMode::always)),
      moat_adaptive(names::moat_varied, everything(ErrorBarMode::always, ContactSensitivityMode::always)),
      moat_fixed(of, Newmark::average_acceleration(), peaks),
      moat_fixed(of, Newmark::fourth_order(), peaks),
      moat_exact(names::moat_exact, peaks),
      moat_exact(names::moat_exact_recorded, everything(ErrorBarMode::never)),
      arkode(of, SundialsMethod::zonneveld_4, "Zonneveld"),
      arkode(of, SundialsMethod::dormand_prince_5, "Dormand-Prince")};
  if (opensees)
    for (const peers::OpenSeesSetting& setting : peers::opensees_settings())
      list.push_back(opensees_ladder(names::opensees, *opensees, of, setting));
  return list;
}

References references(const Case& of) {
  return {moat_peaks(of.model, of.motion, {.tolerance = 1e-8, .steps_per_contact = 2048}),
          moat_peaks(of.model, of.motion, {.tolerance = 1e-7, .steps_per_contact = 1024}),
          sundials_peaks(of.motion, SundialsMethod::zonneveld_4, 1e-11)};
}

}  // namespace moat::performance
