#include "experiments/kharaz.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <moat.hpp>
#include <string>
#include <vector>

#include "base/text/rows.hpp"
#include "base/text/text_file.hpp"
#include "experiments/sections.hpp"

namespace moat::experiments {
namespace {

using namespace units;
using Sphere = KharazSphere;

// Generic, so that the branch that does not compile is left out.
template <class Friction>
std::optional<Friction> of_ratio(double ratio) {
  if constexpr (friction_takes_a_ratio) return Friction{Sphere::friction, ratio};
  return std::nullopt;
}

struct KharazRow {
  std::string set;
  double angle;
  std::optional<double> values[3];  // tangential restitution, spin, angle
};

std::vector<KharazRow> read_rows(const std::filesystem::path& path) {
  Rows rows{read_text_file(path), ','};
  rows.take_heading();
  std::vector<KharazRow> list;
  for (const Row& line : rows.list) {
    if (line.fields.size() != 5) rows.refuse(line, "must have five fields.");
    KharazRow row{line.fields[0], rows.number(line, 1), {}};
    for (std::size_t i = 0; i < 3; ++i)
      if (!line.fields[i + 2].empty()) row.values[i] = rows.number(line, i + 2);
    list.push_back(row);
  }
  return list;
}

using FrictionAt = std::function<CornerFriction(double angle)>;

// Whether a quantity, by its number, is near enough to a given one; nothing where it has no target.
std::optional<bool> holds(bool measured, std::size_t quantity, double angle, double moat, double given) {
  const double error = std::abs(moat - given);
  if (measured) return quantity == 0 && angle >= 20.0 ? std::optional{error <= 0.05 * given} : std::nullopt;
  return quantity == 0 ? error <= 0.01 * given : quantity == 1 ? error <= 0.01 * std::abs(given) + 2.0 : error <= 0.5;
}

std::string compared(const std::vector<KharazRow>& rows, const std::string& set, const std::string& title,
                     const FrictionAt& friction) {
  constexpr int decimals[] = {3, 0, 1};
  const bool measured = set == "measured";
  std::vector<std::string> columns[3];
  int held = 0, all = 0;
  for (const KharazRow& given : rows) {
    if (given.set != set) continue;
    const Rebound found = rebound(given.angle, friction(given.angle));
    const double of_moat[] = {found.tangential_restitution, found.spin, found.angle};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!given.values[i]) continue;
      const std::optional<bool> near = holds(measured, i, given.angle, of_moat[i], *given.values[i]);
      all += near ? 1 : 0;
      held += near.value_or(false) ? 1 : 0;
      columns[i].push_back(to_significant(given.angle, 4) + ": " + rounded(of_moat[i], decimals[i]) + " / " +
                           rounded(*given.values[i], decimals[i]) + (near.value_or(true) ? "" : " \\*"));
    }
  }
  if (all == 0) return "";
  std::string text = "**" + title + "** (angle in degrees: moat / given)\n\n" +
                     heading({"tangential restitution", "spin, rad/s", "angle of rebound, degrees"});
  for (std::size_t i = 0; i < std::max({columns[0].size(), columns[1].size(), columns[2].size()}); ++i) {
    std::vector<std::string> cells;
    for (const auto& column : columns) cells.push_back(i < column.size() ? column[i] : "");
    text += row(cells);
  }
  return text + "\nTarget: " +
         (measured ? "tangential restitution within 5 % from 20 degrees on"
                   : "tangential restitution within 1 %, spin within 1 % + 2 rad/s, angle within 0.5 degrees") +
         ". Held by " + std::to_string(held) + " of " + std::to_string(all) + " values" +
         (held < all ? "; \\* marks the others" : "") + ".\n\n";
}

}  // namespace

CornerFriction constant_stiffness(double angle) {
  const double normal_speed = Sphere::speed * std::cos(angle * deg);
  // m v^2/2 = (2/5) k d^2.5, without the loss.
  const double indentation = std::pow(1.25 * Sphere::mass * normal_speed * normal_speed / Sphere::hertz, 0.4);
  return {Sphere::friction, Sphere::stiffness_ratio * 1.5 * Sphere::hertz * std::sqrt(indentation) * N / m};
}

std::optional<CornerFriction> following_stiffness() { return of_ratio<CornerFriction>(Sphere::stiffness_ratio); }

Rebound rebound(double angle, const CornerFriction& friction) {
  constexpr double clearance = 1e-7, edge = 0.01, sample = 1e-6, end = 4e-5;
  Model model;
  const double along = Sphere::speed * std::sin(angle * deg), normal = Sphere::speed * std::cos(angle * deg);
  const DiaphragmId sphere = add(model, Diaphragm{.name = "sphere",
                                                  .mass = Sphere::mass * kg,
                                                  .rotary_inertia = Sphere::inertia * kg * m * m,
                                                  .initial_velocity_x = normal * m / s,
                                                  .initial_velocity_y = along * m / s,
                                                  .free = true});
  const PlanPosition wall_begin{(Sphere::radius + clearance) * m, -edge * m},
      wall_end{(Sphere::radius + clearance) * m, edge * m};
  add(model,
      CornerGap<ExactHertzDamp>{.name = "wall",
                                .corner = PlanPoint{sphere, {Sphere::radius * m, 0 * m}},
                                .edge_of = ground,
                                .edge_begin = wall_begin,
                                .edge_end = wall_end,
                                .law = {.stiffness = Sphere::hertz * N / m_3_2, .restitution = Sphere::restitution},
                                .friction = friction});
  const GroundMotion still{"still", sample, std::vector<double>(static_cast<std::size_t>(end / sample) + 1, 0.0)};
  Transient analysis{model, still, {.steps_per_contact = 1024, .location_tolerance = 1e-15 * m}};
  analysis.run();
  const AnalysisState& state = analysis.state();
  const double after = state.velocity(sphere.y),
               spin = state.velocity(sphere.r) / std::sqrt(Sphere::inertia / Sphere::mass),
               away = -state.velocity(sphere.x);
  return {after / along, spin, std::atan2(after + spin * Sphere::radius, away) / deg, away / normal};
}

std::string kharaz(const Folders& folders) {
  const std::vector<KharazRow> rows = read_rows(folders.data / "kharaz" / "oblique_impact.csv");
  std::string text =
      compared(rows, "constant_tangential_stiffness_integrated",
               "constant tangential stiffness, beside the integration", constant_stiffness) +
      compared(rows, "measured", "constant tangential stiffness, beside the measurement", constant_stiffness);
  if (const auto following = following_stiffness()) {
    const FrictionAt friction = [&](double) { return *following; };
    text += compared(rows, "finite_elements", "stiffness that follows the normal tangent, beside finite elements",
                     friction) +
            compared(rows, "measured", "stiffness that follows the normal tangent, beside the measurement", friction);
  }
  return text;
}

}  // namespace moat::experiments
