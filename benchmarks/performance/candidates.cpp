#include "performance/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/check.hpp"
#include "performance/arkode.hpp"
#include "performance/bare_newmark.hpp"
#include "performance/bare_runge_kutta.hpp"
#include "performance/cvode.hpp"
#include "performance/moat_five_storeys.hpp"

namespace moat::performance {
namespace {

constexpr double default_tolerance = 1.2e-4;
constexpr int default_steps_per_contact = 32, fewest_steps_per_contact = 4;

// Contacts are divided in step with the tolerance: the error of both falls with the square of the step.
int steps_for(double tolerance) {
  const double steps = default_steps_per_contact * std::sqrt(default_tolerance / tolerance);
  return std::max(fewest_steps_per_contact, static_cast<int>(std::lround(steps)));
}
double tolerance_for(int steps_per_contact) {
  const double ratio = static_cast<double>(default_steps_per_contact) / steps_per_contact;
  return std::min(default_tolerance * ratio * ratio, 0.5);
}

const std::vector<double>& newmark_tolerances() {
  static const std::vector<double> list{1e-2,   5.6e-3, 3e-3,   1.8e-3, 1e-3, 6e-4,
                                        3.6e-4, 2e-4,   1.2e-4, 6e-5,   3e-5, 1.2e-5};
  return list;
}
constexpr double contact_steps[] = {4, 6, 8, 11, 16, 23, 32, 45, 64, 128};

// One setting for every tolerance of Newmark, contacts divided in step with it.
Ladder by_tolerance(const std::function<Peaks(double tolerance, int steps_per_contact)>& run) {
  Ladder ladder;
  for (const double tolerance : newmark_tolerances())
    ladder.push_back(
        {"tolerance " + to_text(tolerance), [run, tolerance] { return run(tolerance, steps_for(tolerance)); }});
  return ladder;
}

Ladder moat_adaptive(const GroundMotion& motion, const std::shared_ptr<const Model>& model) {
  return by_tolerance([&motion, model](double tolerance, int steps) {
    return moat_peaks(*model, motion, {.tolerance = tolerance, .steps_per_contact = steps});
  });
}

Ladder newmark(const GroundMotion& motion, Peaks (*peaks)(const GroundMotion&, NewmarkSetting)) {
  return by_tolerance([&motion, peaks](double tolerance, int steps) { return peaks(motion, {tolerance, steps}); });
}

Ladder moat_fixed(const GroundMotion& motion, const std::shared_ptr<const Model>& model) {
  Ladder ladder;
  for (const int divisions : {1, 2, 3, 4, 6, 8, 12, 16}) {
    const Time step = motion.time_step() / divisions * units::s;
    ladder.push_back({to_text(1e3 * step.si()) + " ms",
                      [&motion, model, step] { return moat_peaks(*model, motion, {.step = step}); }});
  }
  return ladder;
}

Ladder moat_exact(const GroundMotion& motion, const std::shared_ptr<const Model>& model) {
  Ladder ladder;
  for (const double steps : contact_steps)
    ladder.push_back({to_text(steps) + " steps per contact", [&motion, model, per_contact = static_cast<int>(steps)] {
                        return moat_peaks(*model, motion,
                                          {.integrator = ExactBetweenEvents{},
                                           .tolerance = tolerance_for(per_contact),
                                           .steps_per_contact = per_contact});
                      }});
  return ladder;
}

constexpr GroundKinks all_kinks[] = {GroundKinks::left_to_error_control, GroundKinks::steps_at_most_the_interval,
                                     GroundKinks::stops_at_samples};
constexpr double general_tolerances[] = {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6};

const char* name_of(GroundKinks kinks) {
  switch (kinks) {
    case GroundKinks::left_to_error_control:
      return "kinks left to error control";
    case GroundKinks::steps_at_most_the_interval:
      return "steps at most the interval";
    case GroundKinks::stops_at_samples:
      break;
  }
  return "stops at samples";
}

// The equations: those written by hand, or those of a model where one is given.
Ladder cvode(const GroundMotion& motion, Multistep method, GroundKinks kinks,
             const std::shared_ptr<const Model>& model = nullptr) {
  Ladder ladder;
  for (const double tolerance : general_tolerances)
    ladder.push_back({std::string{method == Multistep::bdf ? "BDF" : "Adams"} + ", " + name_of(kinks) + ", tolerance " +
                          to_text(tolerance),
                      [&motion, model, setting = CvodeSetting{method, kinks, tolerance}] {
                        return model ? cvode_peaks(*model, motion, setting) : cvode_peaks(motion, setting);
                      }});
  return ladder;
}

const char* name_of(RungeKuttaMethod method) {
  switch (method) {
    case RungeKuttaMethod::bogacki_shampine_3:
      return "Bogacki-Shampine";
    case RungeKuttaMethod::zonneveld_4:
      return "Zonneveld";
    case RungeKuttaMethod::dormand_prince_5:
      return "Dormand-Prince";
    case RungeKuttaMethod::sdirk_4:
      break;
  }
  return "SDIRK";
}

Ladder arkode(const GroundMotion& motion, RungeKuttaMethod method, GroundKinks kinks,
              const std::shared_ptr<const Model>& model = nullptr) {
  Ladder ladder;
  for (const double tolerance : general_tolerances) {
    // The implicit one never comes near the explicit ones; its dearest settings would only take time.
    if (method == RungeKuttaMethod::sdirk_4 && tolerance < 1e-5) continue;
    ladder.push_back({std::string{name_of(method)} + ", " + name_of(kinks) + ", tolerance " + to_text(tolerance),
                      [&motion, model, setting = ArkodeSetting{method, kinks, tolerance}] {
                        return model ? arkode_peaks(*model, motion, setting) : arkode_peaks(motion, setting);
                      }});
  }
  return ladder;
}

Ladder arkode_of_fixed_step(const GroundMotion& motion, RungeKuttaMethod method, GroundKinks kinks) {
  Ladder ladder;
  for (const int divisions : {1, 2, 4})
    ladder.push_back(
        {std::string{name_of(method)} + ", " + name_of(kinks) + ", interval/" + to_text(divisions),
         [&motion, setting = ArkodeSetting{.method = method, .kinks = kinks, .fixed_divisions = divisions}] {
           return arkode_peaks(motion, setting);
         }});
  return ladder;
}

Method all_of_cvode(const GroundMotion& motion, const char* name, Multistep multistep) {
  Method method{name, {}};
  for (const GroundKinks kinks : all_kinks) method.ladders.push_back(cvode(motion, multistep, kinks));
  return method;
}

Method all_of_arkode(const GroundMotion& motion) {
  Method method{method_names::arkode, {}};
  for (const auto runge_kutta : {RungeKuttaMethod::bogacki_shampine_3, RungeKuttaMethod::zonneveld_4,
                                 RungeKuttaMethod::dormand_prince_5, RungeKuttaMethod::sdirk_4})
    for (const GroundKinks kinks : all_kinks) {
      method.ladders.push_back(arkode(motion, runge_kutta, kinks));
      if (runge_kutta != RungeKuttaMethod::sdirk_4 && kinks != GroundKinks::left_to_error_control)
        method.ladders.push_back(arkode_of_fixed_step(motion, runge_kutta, kinks));
    }
  return method;
}

// What does best with the equations written by hand.
Method cvode_on_model(const GroundMotion& motion, const std::shared_ptr<const Model>& model) {
  using enum GroundKinks;
  return {method_names::cvode_on_model,
          {cvode(motion, Multistep::bdf, left_to_error_control, model),
           cvode(motion, Multistep::adams_fixed_point, left_to_error_control, model),
           cvode(motion, Multistep::adams_fixed_point, steps_at_most_the_interval, model)}};
}

Method arkode_on_model(const GroundMotion& motion, const std::shared_ptr<const Model>& model) {
  using enum GroundKinks;
  return {method_names::arkode_on_model,
          {arkode(motion, RungeKuttaMethod::bogacki_shampine_3, left_to_error_control, model),
           arkode(motion, RungeKuttaMethod::zonneveld_4, left_to_error_control, model),
           arkode(motion, RungeKuttaMethod::dormand_prince_5, left_to_error_control, model)}};
}

Ladder runge_kutta(const GroundMotion& motion) {
  Ladder ladder;
  for (const auto& [divisions, steps] : {std::pair{1, 4}, {1, 16}, {1, 32}, {1, 64}, {2, 64}, {4, 128}})
    ladder.push_back(
        {"interval/" + to_text(divisions) + ", " + to_text(steps) + " steps per contact",
         [&motion, setting = RungeKuttaSetting{divisions, steps}] { return bare_runge_kutta(motion, setting); }});
  return ladder;
}

}  // namespace

std::vector<Method> methods(const GroundMotion& motion, bool quick) {
  const auto plain = std::make_shared<const Model>(five_storey_model(false));
  const auto located = std::make_shared<const Model>(five_storey_model(true));
  std::vector<Method> list{{method_names::moat_adaptive, {moat_adaptive(motion, plain)}},
                           {method_names::moat_fixed, {moat_fixed(motion, plain)}},
                           {method_names::moat_exact, {moat_exact(motion, located)}},
                           all_of_cvode(motion, method_names::cvode_bdf, Multistep::bdf),
                           all_of_cvode(motion, method_names::cvode_adams, Multistep::adams_fixed_point),
                           all_of_arkode(motion),
                           cvode_on_model(motion, located),
                           arkode_on_model(motion, located),
                           {method_names::plain_newmark, {newmark(motion, plain_newmark)}},
                           {method_names::bare_newmark, {newmark(motion, bare_newmark)}},
                           {method_names::bare_runge_kutta, {runge_kutta(motion)}}};
  if (quick)
    for (Method& method : list)
      for (Ladder& ladder : method.ladders) {
        std::size_t index = 0;
        std::erase_if(ladder, [&](const Setting&) { return index++ % 3 != 0; });
      }
  return list;
}

References references(const GroundMotion& motion) {
  const Model model = five_storey_model(true);
  return {moat_peaks(model, motion, {.tolerance = 1e-8, .steps_per_contact = 2048}),
          moat_peaks(model, motion, {.tolerance = 1e-7, .steps_per_contact = 1024}),
          bare_runge_kutta(motion, {32, 256})};
}

}  // namespace moat::performance
