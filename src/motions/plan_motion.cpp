#include "motions/plan_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "base/units.hpp"
#include "motions/readers/read_motion.hpp"

namespace moat {
namespace {

std::string names_of(const PlanMotion& motion) {
  return motion.first.name() + " + " + motion.second.name() +
         (motion.vertical ? " + " + motion.vertical->name() : std::string{});
}

// The samples of motions on the shortest of their intervals, and lines about them for a report.
struct Together {
  double interval;
  std::vector<std::vector<double>> samples;
  std::vector<std::string> notes{};
};

struct Part {
  std::string name;
  const GroundMotion& motion;
};

Together together(const Check& check, const std::vector<Part>& parts) {
  constexpr double round_off = 1e-9;
  Together result{parts.front().motion.time_step(), {}};
  std::string intervals;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& [name, motion] = parts[i];
    check.that(!motion.has_two_components() && motion.samples_z().empty(),
               "\"" + motion.name() + "\" has several components already.", "Give motions of one component each.");
    intervals += (i == 0 ? "" : i + 1 < parts.size() ? ", " : " and ") + to_text(motion.time_step()) + " s";
    result.interval = std::min(result.interval, motion.time_step());
    result.notes.push_back(name + " component: " + motion.description());
    // A vertical record is right here.
    for (const std::string& note : motion.notes())
      if (name != "vertical" || note.find(vertical_record) == std::string::npos) result.notes.push_back(note);
  }
  std::size_t longest = 0;
  for (const auto& [name, motion] : parts) {
    const double ratio = motion.time_step() / result.interval, steps = std::round(ratio);
    check.that(std::abs(ratio - steps) <= round_off * steps,
               "the sampling intervals of its components, " + intervals + ", do not divide each other.",
               "Resample one of them, so that the longer interval is a multiple of the shorter.");
    const auto samples = motion.samples();
    std::vector<double>& finer = result.samples.emplace_back();
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
      for (double k = 0.0; k < steps; ++k) finer.push_back(samples[i] + k / steps * (samples[i + 1] - samples[i]));
    finer.push_back(samples.back());
    longest = std::max(longest, finer.size());
  }
  for (std::vector<double>& each : result.samples) each.resize(longest, 0.0);
  return result;
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
  const double degrees = incidence / (units::pi / 180.0);
  check.that(degrees > -360.0 && degrees < 360.0, "incidence", degrees, "deg", "> -360 and < 360",
             "Write it with its unit: 30 * deg.");
  check.that(vertical || !vertical_factor, "it has a vertical_factor without a vertical component.",
             "Give the record as `vertical`.");
  std::vector<Part> parts{{"first", first}, {"second", second}};
  std::optional<GroundMotion> upwards = vertical;
  if (vertical_factor) upwards = vertical->scaled_by(*vertical_factor);
  if (upwards) parts.push_back({"vertical", *upwards});
  Together all = together(check, parts);
  const PlanVector along = direction_of(incidence), across = turned_left(along);
  std::vector<double>&x = all.samples[0], &y = all.samples[1];
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double one = x[i], two = y[i];
    x[i] = along.x * one + across.x * two;
    y[i] = along.y * one + across.y * two;
  }
  all.notes.push_back("angle of incidence " + to_text(degrees) +
                      " deg, counter-clockwise from +x to the first component");
  const GroundMotion pair = GroundMotion{names, all.interval, std::move(x), std::move(all.notes)}.with_component_y(
      std::move(y), first, second);
  if (!upwards) return pair;
  std::vector<MotionComponent> made_of = pair.components();
  made_of.push_back(upwards->components().front());
  return pair.with_component_z(std::move(all.samples[2]), std::move(made_of));
}

PlanMotion PlanMotion::rotated(Angle angle) const {
  PlanMotion turned = *this;
  turned.incidence = incidence + angle;
  return turned;
}

PlanMotion PlanMotion::scaled_by(double factor) const {
  PlanMotion scaled{first.scaled_by(factor), second.scaled_by(factor), incidence, vertical, vertical_factor};
  if (vertical && !vertical_factor) scaled.vertical = vertical->scaled_by(factor);
  return scaled;
}

GroundMotion with_vertical(const GroundMotion& horizontal, const GroundMotion& vertical) {
  const std::string names = horizontal.name() + " + " + vertical.name();
  Together both = together(Check{"with_vertical", names}, {{"horizontal", horizontal}, {"vertical", vertical}});
  return GroundMotion{names, both.interval, std::move(both.samples[0]), std::move(both.notes)}.with_component_z(
      std::move(both.samples[1]), {horizontal.components().front(), vertical.components().front()});
}

PlanMotion PlanMotion::scaled_to_larger_pga(Acceleration target) const {
  const std::string names = names_of(*this);
  const Check check{"PlanMotion", names};
  check.positive("target PGA", target, "Give it as, for example, 0.4 * g.");
  const double larger = std::max(first.peak_acceleration().si(), second.peak_acceleration().si());
  check.that(larger > 0.0, "a motion that is zero everywhere cannot be scaled to a peak acceleration.");
  return scaled_by(target.si() / larger);
}

}  // namespace moat
