// Studies over angles of incidence and accidental eccentricities.
#include "moat.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "message_of.hpp"
#include "small_plan_building.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

PlanBuilding building() {
  return testing::small_plan_building(
      1, {.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.5 * MN / m});
}

Model model_of(const PlanBuilding& each) {
  Model model;
  const auto tower = add(model, each);
  add(model, PlanMoat{.around = tower.base,
                      .clearance = 20 * cm,
                      .law = HertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.65},
                      .friction = 0.3});
  return model;
}

GroundMotion pulse() { return near_fault_pulse({.quiet_after = 2 * s}).scaled_to_pga(0.35 * g); }

TEST(IncidenceStudy, SymmetricModelRepeatsAfterHalfATurn) {
  const Model model = model_of(building());
  const EnvelopeStudy study = incidence_study(model, PlanMotion{pulse(), pulse().scaled_by(0.5)}, 60 * deg);
  const std::vector<double> values = study.cases.values("corner_displacement", "base");
  ASSERT_EQ(values.size(), 6U);
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(values[i] / values[i + 3], 1.0, 1e-6);
    largest = std::max({largest, values[i], values[i + 3]});
  }
  EXPECT_EQ(study.largest("corner_displacement", "base").value, largest);
  EXPECT_TRUE(study.largest("corner_displacement", "base").at.starts_with("incidence = "));
  // The angles differ.
  EXPECT_GT(std::abs(values[0] - values[1]), 1e-5);
}

TEST(IncidenceStudy, AngleIsAddedToThatOfTheMotion) {
  const Model model = model_of(building());
  const PlanMotion motion{pulse(), pulse().scaled_by(0.5), 90 * deg};
  const EnvelopeStudy study = incidence_study(model, motion, 180 * deg);
  Model alone = model;
  const StudyRecord record = peaks_of(alone, motion.resolved());
  EXPECT_EQ(study.cases.values("displacement_y", "base")[0], value_of(record, "displacement_y", "base"));
}

TEST(EccentricityStudy, OppositeShiftsOfASymmetricModelMirror) {
  const EnvelopeStudy study = eccentricity_study(
      [](PlanVector share) { return model_of(with_eccentricity(building(), share.x, share.y)); }, pulse());
  const std::vector<double> turns = study.cases.values("rotation", "base");
  ASSERT_EQ(turns.size(), 5U);
  // Along x only an eccentricity along y turns the building.
  EXPECT_NEAR(turns[0], 0.0, 1e-12);
  EXPECT_NEAR(turns[1], 0.0, 1e-12);
  EXPECT_GT(turns[3], 1e-4);
  EXPECT_NEAR(turns[3] / turns[4], 1.0, 1e-6);
  EXPECT_TRUE(study.largest("rotation", "base").at.starts_with("eccentricity = "));
}

TEST(IncidenceStudy, BadInputIsRefused) {
  const Model model = model_of(building());
  const PlanMotion motion{pulse(), pulse()};
  EXPECT_EQ(
      message_of([&] { (void)incidence_study(model, motion, 50 * deg); }),
      "incidence_study: step = 50 deg is not allowed; it must be a whole part of 360 deg. Give, for example, 15 * "
      "deg.");
  Model line;
  add(line, Node{.name = "node", .mass = 1 * kg});
  EXPECT_EQ(message_of([&] { (void)incidence_study(line, motion); }),
            "incidence_study: the model moves on a line. Make it of diaphragms.");
  EXPECT_NE(message_of([&] {
              (void)eccentricity_study([&](PlanVector) { return model; }, pulse(), 0.0);
            }).find("share = 0 is not allowed; it must be > 0 and < 0.5"),
            std::string::npos);
}

}  // namespace
}  // namespace moat
