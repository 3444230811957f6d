// Superstructures from tables of storeys and files of modes.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "moat.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using namespace units;

class FromTables : public testing::WrittenFiles {
 protected:
  [[nodiscard]] Superstructure building() const {
    return {.storeys = read_storeys(
                write("storeys.csv",
                      "name,height [m],mass [t],inertia [t m2],x_mass [m],y_mass [m],x_rigidity [m],y_rigidity "
                      "[m],kx [kN/m],ky [kN/m],k_rotation [kN m]\n"
                      "base,,900,31500,0,0,,,,,\n"
                      "floor 1,4.5,820,28700,0.6,0,0,0.3,900e3,700e3,60e6\n"
                      "floor 2,3.6,780,27300,0.6,0.2,0.2,0.3,760e3,620e3,52e6\n"
                      "roof,3.6,430,9460,-2.0,0.4,-2.4,0.5,380e3,300e3,14e6\n")),
            .bearings = read_bearings(write("bearings.csv",
                                            "name,x [m],y [m],type\n"
                                            "A1,-12,-7.5,B\nA2,0,-7.5,B\nA3,12,-7.5,B\n"
                                            "B1,-12,0,B\nB2,0,0,B\nB3,12,0,B\n"
                                            "C1,-12,7.5,B\nC2,0,7.5,B\nC3,12,7.5,B\n"),
                                      {.types = {{"B", BiaxialLinear{.stiffness = 1500 * kN / m}}}})};
  }
};

// The periods were computed by an independent program.
TEST_F(FromTables, StoreysAndBearingsHaveTheirPeriods) {
  Model model;
  const SuperstructureParts parts = add(model, building());
  const std::vector<double> fixed = parts.periods();
  const std::vector<double> expected{0.43882671, 0.38986759, 0.27254312, 0.19598786, 0.17505696, 0.13843781};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(fixed[i], expected[i], 5e-9) << i;
  const std::vector<PlanMode> isolated = plan_modes(model, StiffnessStage::initial, 6);
  const std::vector<double> on_bearings{2.94769349, 2.94349903, 1.49041597, 0.28478266, 0.25487925, 0.18237441};
  for (std::size_t i = 0; i < on_bearings.size(); ++i) EXPECT_NEAR(isolated[i].period, on_bearings[i], 5e-9) << i;
  EXPECT_DOUBLE_EQ(model.diaphragm(parts.floor(3)).height, 4.5 + 3.6 + 3.6);
}

// Shapes of any norm, with names of their rows, are the modes of a building of two storeys.
TEST_F(FromTables, ModesAreReadWithTheirRows) {
  // k = 100 MN/m and m = 100 t twice: w^2 = k/m (3 -+ sqrt 5)/2, shapes (1, (1 +- sqrt 5)/2).
  const double low = 1e3 * (3.0 - std::sqrt(5.0)) / 2.0, high = 1e3 * (3.0 + std::sqrt(5.0)) / 2.0;
  const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
  const auto digits = [](double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return std::string{text};
  };
  const std::string modes = "mode,eigenvalue [1/s2],ratio\n1," + digits(low) + ",0.05\n2," + digits(high) + ",0.03\n";
  const std::string shapes =
      "mode,floor,x [m]\n1,2," + digits(golden) + "\n1,1,1\n2,2," + digits(1.0 - golden) + "\n2,1,1\n";
  const ModesFromFile file = read_modes(write("modes.csv", modes), write("shapes.csv", shapes));
  Model model;
  const SuperstructureParts parts = add(
      model, Superstructure{.modes = structure_modes(file, {.norm = ShapeNorm::any}),
                            .floors = {{.height = 3 * m, .mass = 100 * tonne}, {.height = 6 * m, .mass = 100 * tonne}},
                            .damping = ModalDamping{file.ratios}});
  EXPECT_NEAR(parts.periods()[0], 2.0 * pi / std::sqrt(low), 1e-12);
  EXPECT_NEAR(parts.periods()[1], 2.0 * pi / std::sqrt(high), 1e-12);
  // Ratios of the file count without .damping, and .damping before them.
  const auto viscous = [&](const decltype(Superstructure::damping)& damping) {
    Model damped;
    add(damped,
        Superstructure{.modes = structure_modes(file, {.norm = ShapeNorm::any}),
                       .floors = {{.height = 3 * m, .mass = 100 * tonne}, {.height = 6 * m, .mass = 100 * tonne}},
                       .damping = damping});
    return run_case(damped, near_fault_pulse({}), {.transient = {.step = 5 * ms, .end = 2 * s}}).energy.viscous;
  };
  EXPECT_GT(viscous({}), 0.0);
  EXPECT_EQ(viscous({}), viscous(ModalDamping{file.ratios}));
  EXPECT_NE(viscous(ModalDamping{0.02}), viscous({}));
}

}  // namespace
}  // namespace moat
