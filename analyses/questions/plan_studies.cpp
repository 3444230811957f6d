#include "analyses/questions/plan_studies.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"

namespace moat {
namespace {

EnvelopeStudy with_envelope(StudyResult result) {
  std::vector<EnvelopeEntry> envelope;
  // Behind the column of the axis.
  for (std::size_t i = 1; i < result.table().columns.size(); ++i) {
    const Column& column = result.table().columns[i];
    EnvelopeEntry entry{column.quantity, column.where, column.unit, 0.0, ""};
    for (std::size_t row = 0; row < column.values.size(); ++row) {
      const double value = column.values[row];
      // The smallest clearance is the worst.
      const bool worse = column.quantity == "clearance_left" ? value < entry.value : value > entry.value;
      if (!std::isfinite(value) || (!entry.at.empty() && !worse)) continue;
      entry.value = value;
      entry.at = StudyCase{result.cases(), row}.description();
    }
    envelope.push_back(std::move(entry));
  }
  return {std::move(result), std::move(envelope)};
}

}  // namespace

const EnvelopeEntry& EnvelopeStudy::largest(std::string_view quantity, std::string_view where) const {
  const auto found = std::ranges::find_if(
      envelope, [&](const EnvelopeEntry& entry) { return entry.quantity == quantity && entry.where == where; });
  if (found == envelope.end())
    throw InputError{"EnvelopeStudy: there is no result \"" + std::string{quantity} + "\" at \"" + std::string{where} +
                     "\"."};
  return *found;
}

EnvelopeStudy incidence_study(const Model& model, const PlanMotion& motion, Angle step, const StudyOptions& options) {
  const Check check{"incidence_study", ""};
  check.that(model.is_plan(), "the model moves on a line.", "Make it of diaphragms.");
  constexpr double whole_turn = 360.0;
  const double degrees = step / units::deg;
  check.positive("step", degrees, "deg");
  const double count = std::round(whole_turn / degrees);
  constexpr double round_off = 1e-9;
  check.that(count >= 1.0 && std::abs(count * degrees - whole_turn) < round_off * whole_turn, "step", degrees, "deg",
             "a whole part of 360 deg", "Give, for example, 15 * deg.");
  StudyAxis axis{.name = "incidence", .unit = "deg", .values = {}};
  for (int i = 0; i < static_cast<int>(count); ++i) axis.values.push_back(i * whole_turn / count);
  const auto make = [&](const StudyCase& each) {
    const double angle = motion.incidence / units::deg + each.value("incidence");
    PlanMotion turned = motion;
    turned.incidence = std::fmod(angle, whole_turn) * units::deg;
    return StudyModel{model, turned.resolved()};
  };
  return with_envelope(run_study({axis}, std::function<StudyModel(const StudyCase&)>{make}, options));
}

EnvelopeStudy eccentricity_study(const std::function<Model(PlanVector)>& make, const GroundMotion& motion, double share,
                                 const StudyOptions& options) {
  Check{"eccentricity_study", ""}.that(share > 0.0 && share < 0.5, "share", share, "1", "> 0 and < 0.5",
                                       "5 % is 0.05.");
  const std::array<PlanVector, 5> shifts{PlanVector{}, {share, 0.0}, {-share, 0.0}, {0.0, share}, {0.0, -share}};
  const StudyAxis axis = StudyAxis::of_names("eccentricity", {"none", "+x", "-x", "+y", "-y"});
  const auto make_case = [&](const StudyCase& each) {
    return StudyModel{make(shifts[each.position("eccentricity")]), motion};
  };
  return with_envelope(run_study({axis}, std::function<StudyModel(const StudyCase&)>{make_case}, options));
}

}  // namespace moat
