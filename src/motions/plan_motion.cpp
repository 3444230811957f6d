#include "motions/plan_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "base/units.hpp"
#include "motions/response_spectrum.hpp"

namespace moat {
namespace {

std::string names_of(const PlanMotion& motion) { return motion.first.name() + " + " + motion.second.name(); }

// How many intervals of `shorter` one of `longer` takes; 0 if that is no whole number.
std::size_t whole_ratio(double longer, double shorter) {
  constexpr double round_off = 1e-9;
  const double ratio = longer / shorter, whole = std::round(ratio);
  return std::abs(ratio - whole) <= round_off * whole ? static_cast<std::size_t>(whole) : 0;
}

// A motion on an interval that goes `parts` times into its own.
std::vector<double> divided(const GroundMotion& motion, std::size_t parts) {
  const auto samples = motion.samples();
  std::vector<double> finer;
  finer.reserve((samples.size() - 1) * parts + 1);
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    for (std::size_t k = 0; k < parts; ++k)
      finer.push_back(samples[i] + static_cast<double>(k) / static_cast<double>(parts) * (samples[i + 1] - samples[i]));
  finer.push_back(samples.back());
  return finer;
}

// Exact for multiples of 90 degrees, so that a motion along an axis has no component across.
PlanVector direction_of(double angle) {
  const double quarters = angle / (0.5 * units::pi);
  constexpr double round_off = 1e-14;
  if (std::abs(quarters - std::round(quarters)) < round_off * std::max(1.0, std::abs(quarters))) {
    constexpr PlanVector axes[] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    return axes[(static_cast<long>(std::round(quarters)) % 4 + 4) % 4];
  }
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

GroundMotion PlanMotion::resolved() const {
  const std::string names = names_of(*this);
  const Check check{"PlanMotion", names};
  for (const GroundMotion* component : {&first, &second})
    check.that(!component->has_two_components(), "\"" + component->name() + "\" has two components already.",
               "Give two motions of one component each.");
  const double degrees = incidence / (units::pi / 180.0);
  check.that(degrees > -360.0 && degrees < 360.0, "incidence", degrees, "deg", "> -360 and < 360",
             "Write it with its unit: 30 * deg.");
  const bool first_is_finer = first.time_step() <= second.time_step();
  const GroundMotion &finer = first_is_finer ? first : second, &coarser = first_is_finer ? second : first;
  const std::size_t parts = whole_ratio(coarser.time_step(), finer.time_step());
  check.that(parts > 0,
             "the sampling intervals of its components, " + to_text(first.time_step()) + " s and " +
                 to_text(second.time_step()) + " s, do not divide each other.",
             "Resample one of them, so that the longer interval is a multiple of the shorter.");
  std::vector<double> one = divided(first, first_is_finer ? 1 : parts),
                      two = divided(second, first_is_finer ? parts : 1);
  const std::size_t count = std::max(one.size(), two.size());
  one.resize(count, 0.0);
  two.resize(count, 0.0);
  const PlanVector along = direction_of(incidence), across = turned_left(along);
  std::vector<double> x(count), y(count);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = along.x * one[i] + across.x * two[i];
    y[i] = along.y * one[i] + across.y * two[i];
  }
  std::vector<std::string> notes{"first component: " + first.description()};
  notes.insert(notes.end(), first.notes().begin(), first.notes().end());
  notes.push_back("second component: " + second.description());
  notes.insert(notes.end(), second.notes().begin(), second.notes().end());
  notes.push_back("angle of incidence " + to_text(degrees) + " deg, counter-clockwise from +x to the first component");
  return GroundMotion{names, finer.time_step(), std::move(x), std::move(notes)}.with_component_y(std::move(y), first,
                                                                                                 second);
}

PlanMotion PlanMotion::scaled_by(double factor) const {
  return {first.scaled_by(factor), second.scaled_by(factor), incidence};
}

PlanMotion PlanMotion::scaled_to_larger_pga(Acceleration target) const {
  const std::string names = names_of(*this);
  const Check check{"PlanMotion", names};
  check.positive("target PGA", target, "Give it as, for example, 0.4 * g.");
  const double larger = std::max(first.peak_acceleration().si(), second.peak_acceleration().si());
  check.that(larger > 0.0, "a motion that is zero everywhere cannot be scaled to a peak acceleration.");
  return scaled_by(target.si() / larger);
}

std::vector<double> maximum_direction_spectrum(const PlanMotion& motion, const std::vector<Time>& periods,
                                               double damping_ratio) {
  constexpr int degrees_of_half_turn = 180;
  std::vector<double> largest(periods.size(), 0.0);
  for (int angle = 0; angle < degrees_of_half_turn; ++angle) {
    // The component along x of the motion turned back is that along the angle.
    const GroundMotion turned = PlanMotion{motion.first, motion.second, -angle * units::deg}.resolved();
    const GroundMotion component{turned.name(), turned.time_step(), {turned.samples().begin(), turned.samples().end()}};
    const ResponseSpectrum spectrum = response_spectrum(component, periods, damping_ratio);
    for (std::size_t i = 0; i < periods.size(); ++i) largest[i] = std::max(largest[i], spectrum.pseudo_acceleration[i]);
  }
  return largest;
}

}  // namespace moat
