// moat and OpenSees on equal models, where OPENSEES names the program.

#include <gtest/gtest.h>

#include <cstdlib>
#include <moat.hpp>
#include <string>

#include "in_folder.hpp"
#include "peers/bouc_wen.hpp"
#include "peers/moat_histories.hpp"
#include "peers/opensees.hpp"
#include "peers/pendulum.hpp"
#include "peers/plan.hpp"
#include "peers/rebound.hpp"

namespace moat::peers {
namespace {

const bool installed = std::getenv("OPENSEES") != nullptr;

class EqualAnswers : public paper::InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    if (!installed) GTEST_SKIP() << "set OPENSEES to the program OpenSees to run this test";
  }
  // The largest error of OpenSees' values with steps of a twentieth of the interval.
  [[nodiscard]] double error(const Case& of) const {
    const OpenSees opensees = *OpenSees::find(folder / "files");
    const History history = opensees_history(opensees, of, opensees_settings().front(), of.motion.time_step() / 20.0);
    return performance::largest_error(history.peaks, reference_of(of));
  }
  GroundMotion pulse = near_fault_pulse({.quiet_after = 1 * s}).scaled_to_pga(0.4 * g);
};

TEST_F(EqualAnswers, OfABuildingInAMoat) { EXPECT_LT(error(five_storeys("", hertz_damp(), pulse)), 1e-3); }
TEST_F(EqualAnswers, OfFrictionPendulums) { EXPECT_LT(error(on_pendulums("", pulse)), 2e-3); }
TEST_F(EqualAnswers, OfBearingsInPlan) { EXPECT_LT(error(on_bearings_in_plan("", pulse)), 2e-3); }
TEST_F(EqualAnswers, OfBoucWenStoreys) { EXPECT_LT(error(bouc_wen_storeys("", pulse)), 1e-2); }
TEST_F(EqualAnswers, OfRebounds) { EXPECT_LT(error(rebounds("", hertz_damp())), 1e-3); }

}  // namespace
}  // namespace moat::peers
