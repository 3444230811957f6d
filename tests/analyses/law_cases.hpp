// Every impact law in the moat of the paper's building, and the peaks that show whether an impact was resolved.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "materials/contact/impact_laws.hpp"
#include "paper_building.hpp"
#include "reference_rows.hpp"

namespace moat::testing {

struct LawCase {
  std::string row;  ///< of benchmarks/paper/reference_peaks.csv
  std::function<void(Model&, NodeId)> add_moat;
};

template <class Law>
LawCase law_case(std::string row, Law law) {
  return {std::move(row), [law](Model& model, NodeId base) {
            add(model, Moat<Law>{.around = base, .clearance = 10 * units::cm, .law = law});
          }};
}

inline std::vector<LawCase> all_laws() {
  constexpr Stiffness linear_stiffness{5.8e8};
  constexpr HertzStiffness hertz_stiffness{2.95e9};
  return {
      law_case("linear_elastic", LinearElastic{.stiffness = linear_stiffness}),
      law_case("hertz", Hertz{.stiffness = hertz_stiffness}),
      law_case("kelvin", KelvinByDampingRatio{.stiffness = linear_stiffness, .damping_ratio = 0.14, .may_pull = true}),
      law_case("hertz_damp", paper_hertz_damp()),
      law_case("modified_hertz_damp_tabulated", ModifiedHertzDamp{.stiffness = hertz_stiffness, .restitution = 0.65}),
      law_case("modified_hertz_damp_printed_approach_only",
               ModifiedHertzDampPrinted{.stiffness = hertz_stiffness, .restitution = 0.65}),
      law_case("nonlinear_viscoelastic", NonlinearViscoelastic{.stiffness = hertz_stiffness, .restitution = 0.65}),
      law_case("ye_2009", Ye2009{.stiffness = hertz_stiffness, .restitution = 0.65})};
}

struct ReferencePeak {
  const char* column;
  double unit;
  const char* quantity;
  const char* where;
};

inline constexpr std::array<ReferencePeak, 6> reference_peaks{
    {{"base_displacement_cm", 0.01, "displacement", "base"},
     {"top_displacement_cm", 0.01, "displacement", "floor 5"},
     {"base_acceleration_m_s2", 1.0, "absolute_acceleration", "base"},
     {"top_acceleration_m_s2", 1.0, "absolute_acceleration", "floor 5"},
     {"impact_force_kN", 1e3, "impact_force", "moat"},
     {"first_storey_shear_kN", 1e3, "storey_shear", "storey 1"}}};

/// Largest relative error of the six; a force of impact only where there is one.
inline double largest_error(const CaseResult& result, const Row& row) {
  double worst = 0.0;
  for (const ReferencePeak& found : reference_peaks) {
    const double expected = std::stod(row.at(found.column)) * found.unit;
    if (expected == 0.0) continue;
    worst = std::max(worst, std::abs(peak(result, found.quantity, found.where) / expected - 1.0));
  }
  return worst;
}

}  // namespace moat::testing
