#include "performance/methods.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/check.hpp"
#include "performance/bare_loops.hpp"
#include "performance/moat_five_storeys.hpp"
#include "performance/sundials.hpp"

namespace moat::performance {
namespace {

using SharedModel = std::shared_ptr<const Model>;
/// One way to run moat with options of an analysis.
using MoatRun = std::function<Peaks(const TransientOptions&)>;

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

Ladder moat_adaptive(const MoatRun& run) {
  Ladder ladder;
  for (const double tolerance : {1e-2, 5.6e-3, 3e-3, 1.8e-3, 1e-3, 6e-4, 3.6e-4, 2e-4, 1.2e-4, 6e-5, 3e-5, 1.2e-5})
    ladder.push_back({"tolerance " + to_text(tolerance), [run, tolerance] {
                        return run({.tolerance = tolerance, .steps_per_contact = steps_for(tolerance)});
                      }});
  return ladder;
}

Ladder moat_fixed(const GroundMotion& motion, const Newmark& newmark, const MoatRun& run) {
  Ladder ladder;
  for (const int divisions : {1, 2, 3, 4, 6, 8, 12, 16}) {
    const Time step = motion.time_step() / divisions * units::s;
    ladder.push_back({newmark.description() + ", " + to_text(1e3 * step.si()) + " ms",
                      [run, newmark, step] { return run({.integrator = newmark, .step = step}); }});
  }
  return ladder;
}

Ladder moat_exact(const MoatRun& run) {
  Ladder ladder;
  for (const int steps : {4, 6, 8, 11, 16, 23, 32, 45, 64, 128})
    ladder.push_back({to_text(steps) + " steps per contact", [run, steps] {
                        return run({.integrator = ExactBetweenEvents{},
                                    .tolerance = tolerance_for(steps),
                                    .steps_per_contact = steps});
                      }});
  return ladder;
}

// With the equations written by hand, or with those of a model where one is given.
Method sundials(const char* name, const GroundMotion& motion, const std::vector<SundialsMethod>& list,
                const SharedModel& model = nullptr) {
  Method result{name, {}};
  for (const SundialsMethod method : list) {
    Ladder& ladder = result.ladders.emplace_back();
    for (const double tolerance : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6})
      ladder.push_back(
          {std::string{name_of(method)} + ", tolerance " + to_text(tolerance), [&motion, model, method, tolerance] {
             const auto problem = model ? model_problem(*model, motion) : hand_problem(motion);
             return sundials_peaks(*problem, method, tolerance);
           }});
  }
  return result;
}

Ladder newmark(const GroundMotion& motion) {
  Ladder ladder;
  for (const int divisions : {1, 2, 3, 4, 6, 8, 12, 16})
    ladder.push_back(
        {"interval/" + to_text(divisions), [&motion, divisions] { return bare_newmark(motion, divisions).peaks; }});
  return ladder;
}

Ladder runge_kutta(const GroundMotion& motion) {
  Ladder ladder;
  for (const auto& [divisions, steps] : {std::pair{1, 4}, {1, 16}, {1, 32}, {1, 64}, {2, 64}, {4, 128}})
    ladder.push_back(
        {"interval/" + to_text(divisions) + ", " + to_text(steps) + " steps per contact",
         [&motion, setting = RungeKuttaSetting{divisions, steps}] { return bare_runge_kutta(motion, setting).peaks; }});
  return ladder;
}

}  // namespace

std::vector<Method> methods(const GroundMotion& motion, bool quick) {
  using enum SundialsMethod;
  namespace names = method_names;
  const auto model = std::make_shared<const Model>(five_storey_model());
  const MoatRun peaks = [&motion, model](const TransientOptions& options) {
    return moat_peaks(*model, motion, options);
  };
  const auto everything = [&motion, model](ErrorBarMode error_bars) -> MoatRun {
    return [&motion, model, error_bars](const TransientOptions& options) {
      return moat_case(*model, motion, options, error_bars);
    };
  };
  const std::vector<SundialsMethod> explicit_methods{bogacki_shampine_3, zonneveld_4, dormand_prince_5};
  std::vector<Method> list{{names::moat_adaptive, {moat_adaptive(peaks)}},
                           {names::moat_recorded, {moat_adaptive(everything(ErrorBarMode::never))}},
                           {names::moat_checked, {moat_adaptive(everything(ErrorBarMode::always))}},
                           {names::moat_fixed,
                            {moat_fixed(motion, Newmark::average_acceleration(), peaks),
                             moat_fixed(motion, Newmark::fourth_order(), peaks)}},
                           {names::moat_exact, {moat_exact(peaks)}},
                           {names::moat_exact_recorded, {moat_exact(everything(ErrorBarMode::never))}},
                           sundials(names::cvode_bdf, motion, {bdf}),
                           sundials(names::cvode_adams, motion, {adams}),
                           sundials(names::arkode, motion, explicit_methods),
                           sundials(names::cvode_on_model, motion, {bdf, adams}, model),
                           sundials(names::arkode_on_model, motion, explicit_methods, model),
                           {names::bare_newmark, {newmark(motion)}},
                           {names::bare_runge_kutta, {runge_kutta(motion)}}};
  if (quick)
    for (Method& method : list)
      for (Ladder& ladder : method.ladders) {
        std::size_t index = 0;
        std::erase_if(ladder, [&](const Setting&) { return index++ % 3 != 0; });
      }
  return list;
}

References references(const GroundMotion& motion) {
  const Model model = five_storey_model();
  return {moat_peaks(model, motion, {.tolerance = 1e-8, .steps_per_contact = 2048}),
          moat_peaks(model, motion, {.tolerance = 1e-7, .steps_per_contact = 1024}),
          bare_runge_kutta(motion, {32, 256}).peaks};
}

}  // namespace moat::performance
