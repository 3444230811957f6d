// Oblique impacts of a sphere by ./moat bench experiments, against closed forms.
#include "experiments/kharaz.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <moat.hpp>
#include <string>

#include "../../support/in_folder.hpp"
#include "benchmark_building.hpp"
#include "experiments/sections.hpp"
#include "message_of.hpp"

namespace moat::experiments {
namespace {

// A sphere that slides throughout gets the impulse mu (1 + e) m v cos(angle) along the plane; J = 2/5 m r^2.
struct Sliding {
  explicit Sliding(double degrees) {
    const double angle = degrees * units::deg, mu = 0.092, e = 0.98, v = 3.9, r = 2.5e-3;
    restitution = 1.0 - mu * (1.0 + e) / std::tan(angle);
    spin = -2.5 * mu * (1.0 + e) * v * std::cos(angle) / r;
    rebound = std::atan((v * std::sin(angle) * restitution + spin * r) / (e * v * std::cos(angle))) / units::deg;
  }
  double restitution, spin, rebound;
};

// The point of contact slides to the end where tan(angle) > 7/2 mu (1 + e), from 32.5 degrees on.
TEST(KharazSphere, SlidesThroughoutAtFlatAngles) {
  for (const double angle : {33.0, 35.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0}) {
    const Rebound found = rebound(angle, constant_stiffness(angle));
    const Sliding exact{angle};
    // The given mass and inertia have six digits.
    EXPECT_NEAR(found.tangential_restitution, exact.restitution, 1e-7) << angle;
    EXPECT_NEAR(found.spin, exact.spin, 4e-6 * std::abs(exact.spin)) << angle;
    EXPECT_NEAR(found.angle, exact.rebound, 1e-3) << angle;
    EXPECT_NEAR(found.normal_restitution, 0.98, 1e-7) << angle;
  }
}

// Above 28 degrees it sticks only in the last moments.
TEST(KharazSphere, SlidesAlmostThroughoutAboveTwentyEightDegrees) {
  for (const double angle : {29.0, 30.0, 32.0}) {
    const Rebound found = rebound(angle, constant_stiffness(angle));
    EXPECT_NEAR(found.tangential_restitution, Sliding{angle}.restitution, 0.01) << angle;
    EXPECT_NEAR(found.spin, Sliding{angle}.spin, 0.01 * std::abs(Sliding{angle}.spin)) << angle;
  }
}

TEST(KharazSphere, SticksAtSteepAngles) {
  EXPECT_GT(rebound(15.0, constant_stiffness(15.0)).tangential_restitution, 1.5 * Sliding{15.0}.restitution);
}

class KharazFile : public testing::InFolder {
 protected:
  std::string compare(const std::string& rows) const {
    std::filesystem::create_directories(folder / "kharaz");
    std::ofstream{folder / "kharaz/oblique_impact.csv"}
        << "set,theta_deg,tangential_restitution,spin_after_rad_s,rebound_angle_deg\n"
        << rows;
    return kharaz({folder, folder});
  }
};

TEST_F(KharazFile, MarksValuesOutsideTheTargets) {
  const Sliding exact{60.0};
  const auto line = [&](const std::string& set, double restitution, double spin) {
    return set + ",60," + std::to_string(restitution) + "," + std::to_string(spin) + ",\n";
  };
  const std::string text =
      compare(line("constant_tangential_stiffness_integrated", exact.restitution, 0.9 * exact.spin) +
              line("measured", 1.04 * exact.restitution, 0.5 * exact.spin));
  EXPECT_NE(text.find("Held by 1 of 2 values; \\* marks the others."), std::string::npos) << text;
  // The measured spin has no target.
  EXPECT_NE(text.find("Held by 1 of 1 values."), std::string::npos) << text;
}

TEST_F(KharazFile, IsRefusedWithAnotherNumberOfFields) {
  const std::string message = testing::message_of<FileError>([&] { compare("measured,60,0.9\n"); });
  EXPECT_NE(message.find("must have five fields"), std::string::npos) << message;
}

TEST(KharazSphere, AgreesWithThePublishedIntegration) {
  if (!std::filesystem::exists(testing::folder_of_experiment("kharaz")))
    GTEST_SKIP() << "MOAT_EXPERIMENTS has no folder kharaz: the published impacts are left out.";
  const std::string text = kharaz({testing::folder_of_experiment(""), {}});
  EXPECT_NE(text.find("Held by 39 of 39 values."), std::string::npos) << text;
  EXPECT_NE(text.find("Held by 7 of 7 values."), std::string::npos) << text;
}

}  // namespace
}  // namespace moat::experiments
