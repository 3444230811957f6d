#include "analyses/integrators/exact_between_events.hpp"

#include <gtest/gtest.h>

#include <string>

#include "moat.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

Model tower(int storeys) {
  ShearBuilding building = paper_building();
  building.storeys = storeys;
  return pounding_building(10 * cm, building);
}

CaseResult run(const Model& model, const TransientOptions& options) {
  return run_case(model, near_fault_pulse().scaled_to_pga(0.4 * g),
                  {.transient = options, .error_bars = ErrorBarMode::never});
}

// The run must be that of the integrator, to the last digit.
void expect_choice(const Model& model, TransientOptions options, const Integrator& expected,
                   const std::string& reason) {
  options.integrator = Automatic{};
  const CaseResult chosen = run(model, options);
  options.integrator = expected;
  const CaseResult given = run(model, options);
  ASSERT_EQ(chosen.peaks.size(), given.peaks.size());
  for (std::size_t i = 0; i < given.peaks.size(); ++i) EXPECT_EQ(chosen.peaks[i].value, given.peaks[i].value) << i;
  EXPECT_EQ(chosen.assumptions.at(0), "Integrator chosen automatically: " + reason);
  ASSERT_EQ(chosen.assumptions.size(), given.assumptions.size() + 1);
  for (std::size_t i = 0; i < given.assumptions.size(); ++i) EXPECT_EQ(chosen.assumptions[i + 1], given.assumptions[i]);
}

TEST(IntegratorChoice, IsExactForASmallModelThatIsLinearBetweenEvents) {
  expect_choice(tower(5), {}, ExactBetweenEvents{},
                "exact between events, because the model is small and linear between located events.");
}

TEST(IntegratorChoice, IsNewmarkForALargerModel) {
  expect_choice(tower(16), {}, Newmark{},
                "Newmark's method, because exact steps cost more for a model of more than 16 degrees of freedom; this "
                "one has 17.");
}

TEST(IntegratorChoice, IsNewmarkForAFixedStep) {
  expect_choice(tower(5), {.step = 5 * ms}, Newmark{}, "Newmark's method, because the step is fixed.");
}

TEST(IntegratorChoice, SaysWhichElementIsNotLinear) {
  Model model = tower(5);
  add(model, Isolator<NonlinearViscous>{.name = "damper", .upper = NodeId{0}, .law = NonlinearViscous::typical()});
  expect_choice(model, {}, Newmark{},
                "Newmark's method, because exact steps do not apply. TransientOptions: integrator = "
                "ExactBetweenEvents{} needs elements that are linear between located events, and \"damper\" is not. "
                "Use Newmark{}, or a law whose changes of stiffness are located.");
}

}  // namespace
}  // namespace moat
