#include "materials/contact/restitution.hpp"

#include <algorithm>
#include <cmath>

namespace moat {
namespace {

constexpr std::string_view meaning = "It is the speed after the impact over the speed before; 1 is elastic.";
constexpr std::string_view meaning_in_divisor =
    "It is the speed after the impact over the speed before; 1 is elastic. The damping of this law grows without bound "
    "as it falls to zero, and no time step follows such a contact.";

constexpr double least_of_falling = 0.01;  // e falls further at higher speeds

void check_value(const Check& check, std::string_view name, double value, double least) {
  if (least > 0.0)
    check.between(name, value, least, 1.0, "1", meaning_in_divisor);
  else
    check.above_up_to(name, value, 0.0, 1.0, "1", meaning);
}

void check_falling(const Check& check, const FallingRestitution& falling) {
  check.between("restitution", falling.restitution, least_of_falling, 1.0, "1", "It is that at at_speed.");
  check.positive("at_speed", falling.at_speed);
  check.between("largest", falling.largest, falling.restitution, 1.0, "1", "It is that of slow impacts.");
}

void check_measured(const Check& check, const MeasuredRestitution& measured, double least) {
  const auto& points = measured.points;
  check.that(!points.empty(), "restitution has no points.", "Give speeds and restitutions of tests.");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string point = "points[" + std::to_string(i) + "].";
    check_value(check, point + "restitution", points[i].restitution, least);
    check.positive(point + "speed", points[i].speed);
    if (i == 0) continue;
    check.that(points[i].speed > points[i - 1].speed, point + "speed", points[i].speed.si(), "m/s",
               "> " + to_text(points[i - 1].speed.si()) + " m/s, the speed before it");
    check.that(points[i].restitution <= points[i - 1].restitution, point + "restitution", points[i].restitution, "1",
               "<= " + to_text(points[i - 1].restitution) + ", the restitution before it",
               "Restitution does not grow with the speed; take a mean of tests that scatter.");
  }
}

double at_speed(const FallingRestitution& falling, double speed) {
  return std::min(falling.largest, falling.restitution * std::pow(speed / falling.at_speed.si(), -0.25));
}

double at_speed(const MeasuredRestitution& measured, double speed) {
  const auto& points = measured.points;
  const auto after = std::ranges::find_if(points, [&](const auto& point) { return point.speed.si() > speed; });
  if (after == points.begin()) return points.front().restitution;
  if (after == points.end()) return points.back().restitution;
  const auto before = after - 1;
  return std::lerp(before->restitution, after->restitution,
                   (speed - before->speed.si()) / (after->speed - before->speed).si());
}

}  // namespace

Restitution::Restitution(const Restitution&) = default;
Restitution::Restitution(Restitution&&) noexcept = default;
Restitution& Restitution::operator=(const Restitution&) = default;
Restitution& Restitution::operator=(Restitution&&) noexcept = default;
Restitution::~Restitution() = default;

double Restitution::at(double approach_speed) const {
  if (const double* constant = std::get_if<double>(&form_)) return *constant;
  if (const auto* falling = std::get_if<FallingRestitution>(&form_)) return at_speed(*falling, approach_speed);
  return at_speed(std::get<MeasuredRestitution>(form_), approach_speed);
}

double Restitution::smallest() const {
  if (const double* constant = std::get_if<double>(&form_)) return *constant;
  if (std::holds_alternative<FallingRestitution>(form_)) return 0.0;
  return std::get<MeasuredRestitution>(form_).points.back().restitution;
}

Restitution Restitution::changed_by(double change) const {
  if (const double* constant = std::get_if<double>(&form_)) return shifted_restitution(*constant, change);
  if (const auto* falling = std::get_if<FallingRestitution>(&form_))
    return FallingRestitution{shifted_restitution(falling->restitution, change, least_of_falling), falling->at_speed,
                              shifted_restitution(falling->largest, change, least_of_falling)};
  MeasuredRestitution measured = std::get<MeasuredRestitution>(form_);
  for (RestitutionAtSpeed& point : measured.points) point.restitution = shifted_restitution(point.restitution, change);
  return measured;
}

void Restitution::check(const Check& check, double least) const {
  if (const double* constant = std::get_if<double>(&form_))
    check_value(check, "restitution", *constant, least);
  else if (const auto* falling = std::get_if<FallingRestitution>(&form_))
    check_falling(check, *falling);
  else
    check_measured(check, std::get<MeasuredRestitution>(form_), least);
}

std::vector<Parameter> Restitution::parameters() const {
  if (const double* constant = std::get_if<double>(&form_)) return {{"restitution", *constant, "1"}};
  if (const auto* falling = std::get_if<FallingRestitution>(&form_))
    return {{"falling_restitution", falling->restitution, "1"},
            {"at_speed", falling->at_speed.si(), "m/s"},
            {"largest_restitution", falling->largest, "1"}};
  const auto& points = std::get<MeasuredRestitution>(form_).points;
  return {{"largest_restitution", points.front().restitution, "1"},
          {"smallest_restitution", points.back().restitution, "1"},
          {"restitution_points", static_cast<double>(points.size()), "1"}};
}

std::vector<Parameter> with_restitution(const Parameter& stiffness, const Restitution& restitution,
                                        const std::vector<Parameter>& others) {
  std::vector<Parameter> list = restitution.parameters();
  list.insert(list.begin(), stiffness);
  list.insert(list.end(), others.begin(), others.end());
  return list;
}

Estimate<double> restitution_of(Faces faces) {
  const std::string assumption =
      "A constant. It falls with the speed in tests: FallingRestitution, MeasuredRestitution.";
  switch (faces) {
    case Faces::concrete:
      return {0.65, 0.4, 0.8,
              "usual in studies of pounding, 0.5 to 0.75: Anagnostopoulos (1988), Azevedo and Bento (1996), recalled",
              assumption};
    case Faces::steel:
      return {0.6, 0.5, 0.7, "dropped balls of steel, Jankowski (2010), recalled", assumption};
    case Faces::crushed_corner:
      break;
  }
  return {0.2, 0.1, 0.4, "a guess: most of the energy goes into crushed concrete", assumption};
}

}  // namespace moat
