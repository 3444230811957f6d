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

Method moat_adaptive(const GroundMotion& motion, const std::shared_ptr<const Model>& model) {
  Method method{method_names::moat_adaptive, {}};
  for (const double tolerance : newmark_tolerances())
    method.settings.push_back({"tolerance " + to_text(tolerance), [&motion, model, tolerance] {
                                 return moat_peaks(*model, motion,
                                                   {.tolerance = tolerance, .steps_per_contact = steps_for(tolerance)});
                               }});
  return method;
}

Method moat_recorded(const GroundMotion& motion, const std::shared_ptr<const Model>& model) {
  Method method{method_names::moat_recorded, {}};
  for (const double tolerance : newmark_tolerances())
    method.settings.push_back({"tolerance " + to_text(tolerance), [&motion, model, tolerance] {
                                 return moat_peaks_of_all_channels(
                                     *model, motion,
                                     {.tolerance = tolerance, .steps_per_contact = steps_for(tolerance)});
                               }});
  return method;
}

Method moat_fixed(const GroundMotion& motion, const std::shared_ptr<const Model>& model) {
  Method method{method_names::moat_fixed, {}};
  for (const int divisions : {1, 2, 3, 4, 6, 8, 12, 16}) {
    const Time step = motion.time_step() / divisions * units::s;
    method.settings.push_back({to_text(1e3 * step.si()) + " ms",
                               [&motion, model, step] { return moat_peaks(*model, motion, {.step = step}); }});
  }
  return method;
}

Method moat_exact(const GroundMotion& motion, const std::shared_ptr<const Model>& model) {
  Method method{method_names::moat_exact, {}};
  for (const double steps : contact_steps)
    method.settings.push_back(
        {to_text(steps) + " steps per contact", [&motion, model, per_contact = static_cast<int>(steps)] {
           return moat_peaks(*model, motion,
                             {.integrator = Integrator::exact_between_events,
                              .tolerance = tolerance_for(per_contact),
                              .steps_per_contact = per_contact});
         }});
  return method;
}

constexpr std::pair<GroundKinks, const char*> all_kinks[] = {
    {GroundKinks::left_to_error_control, "kinks left to error control"},
    {GroundKinks::steps_at_most_the_interval, "steps at most the interval"},
    {GroundKinks::stops_at_samples, "stops at samples"}};
constexpr double general_tolerances[] = {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6};

Method cvode(const GroundMotion& motion) {
  Method method{method_names::cvode, {}};
  for (const auto& [multistep, name] :
       {std::pair{Multistep::bdf, "BDF"}, std::pair{Multistep::adams_fixed_point, "Adams"}})
    for (const auto& [kinks, how] : all_kinks)
      for (const double tolerance : general_tolerances) {
        const CvodeSetting setting{multistep, kinks, tolerance};
        method.settings.push_back({std::string{name} + ", " + how + ", tolerance " + to_text(tolerance),
                                   [&motion, setting] { return cvode_peaks(motion, setting); }});
      }
  return method;
}

Method arkode(const GroundMotion& motion) {
  Method method{method_names::arkode, {}};
  const auto add = [&](const std::string& name, const ArkodeSetting& setting) {
    method.settings.push_back({name, [&motion, setting] { return arkode_peaks(motion, setting); }});
  };
  for (const auto& [runge_kutta, name] :
       {std::pair{RungeKuttaMethod::bogacki_shampine_3, "Bogacki-Shampine"},
        std::pair{RungeKuttaMethod::zonneveld_4, "Zonneveld"},
        std::pair{RungeKuttaMethod::dormand_prince_5, "Dormand-Prince"}, std::pair{RungeKuttaMethod::sdirk_4, "SDIRK"}})
    for (const auto& [kinks, how] : all_kinks) {
      for (const double tolerance : general_tolerances) {
        // The implicit one never comes near the explicit ones; its dearest settings would only take time.
        if (runge_kutta == RungeKuttaMethod::sdirk_4 && tolerance < 1e-5) continue;
        add(std::string{name} + ", " + how + ", tolerance " + to_text(tolerance), {runge_kutta, kinks, tolerance});
      }
      if (runge_kutta != RungeKuttaMethod::sdirk_4 && kinks != GroundKinks::left_to_error_control)
        for (const int divisions : {1, 2, 4})
          add(std::string{name} + ", " + how + ", interval/" + to_text(divisions),
              {.method = runge_kutta, .kinks = kinks, .fixed_divisions = divisions});
    }
  return method;
}

Method newmark(const GroundMotion& motion, const char* name, Peaks (*peaks)(const GroundMotion&, NewmarkSetting)) {
  Method method{name, {}};
  for (const double tolerance : newmark_tolerances())
    method.settings.push_back({"tolerance " + to_text(tolerance), [&motion, peaks, tolerance] {
                                 return peaks(motion, {tolerance, steps_for(tolerance)});
                               }});
  return method;
}

Method runge_kutta(const GroundMotion& motion) {
  Method method{method_names::bare_runge_kutta, {}};
  for (const auto& [divisions, steps] : {std::pair{1, 4}, {1, 16}, {1, 32}, {1, 64}, {2, 64}, {4, 128}})
    method.settings.push_back(
        {"interval/" + to_text(divisions) + ", " + to_text(steps) + " steps per contact",
         [&motion, setting = RungeKuttaSetting{divisions, steps}] { return bare_runge_kutta(motion, setting); }});
  return method;
}

}  // namespace

std::vector<Method> methods(const GroundMotion& motion, bool quick) {
  const auto plain = std::make_shared<const Model>(five_storey_model(false));
  const auto located = std::make_shared<const Model>(five_storey_model(true));
  std::vector<Method> list{moat_adaptive(motion, plain),
                           moat_recorded(motion, plain),
                           moat_fixed(motion, plain),
                           moat_exact(motion, located),
                           cvode(motion),
                           arkode(motion),
                           newmark(motion, method_names::bare_newmark, bare_newmark),
                           newmark(motion, method_names::plain_newmark, plain_newmark),
                           runge_kutta(motion)};
  if (quick)
    for (Method& method : list) {
      std::size_t index = 0;
      std::erase_if(method.settings, [&](const Setting&) { return index++ % 3 != 0; });
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
