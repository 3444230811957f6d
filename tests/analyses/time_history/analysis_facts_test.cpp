// Reports list all options of an analysis.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "moat.hpp"
#include "small_models.hpp"

namespace moat {
namespace {

using namespace units;

// All facts in one text.
std::string text_of(const AnalysisFacts& facts) {
  std::string text =
      facts.integrator + ", " + facts.events + ", " + facts.error_bars + ", " + facts.contact_sensitivity;
  for (const Parameter& option : facts.options)
    text +=
        ", " + std::string{option.name} + " " + std::to_string(1e12 * option.value) + " " + std::string{option.unit};
  return text;
}

TEST(AnalysisFacts, DifferWhereAnyOptionDiffers) {
  const std::vector<TransientOptions> all{{},
                                          {.integrator = GeneralizedAlpha{}},
                                          {.integrator = GeneralizedAlpha{.spectral_radius = 0.7}},
                                          {.integrator = GeneralizedAlpha{.spectral_radius = 0.70000001}},
                                          {.step = 1 * ms},
                                          {.tolerance = 2e-5},
                                          {.steps_per_contact = 33},
                                          {.largest_step = 3 * ms},
                                          {.max_halvings = 5},
                                          {.end = 2 * s},
                                          {.force_tolerance = 1e-9},
                                          {.max_iterations = 3},
                                          {.max_cuts = 2},
                                          {.location_tolerance = 1e-6 * m},
                                          {.events = EventTreatment::at_end_of_step},
                                          {.max_events_per_second = 100}};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NE(text_of(facts_of(all[i])), text_of(facts_of(all[k]))) << i << " " << k;
}

// Options of the case were not listed.
TEST(AnalysisFacts, DifferWhereAnyOptionOfTheCaseDiffers) {
  const std::vector<CaseOptions> all{{},
                                     {.transient = {.step = 1 * ms}},
                                     {.history_interval = 2.5 * ms},
                                     {.warn_above_energy_error = 1e-2},
                                     {.error_bars = ErrorBarMode::always},
                                     {.error_bars = ErrorBarMode::never},
                                     {.contact_sensitivity = ContactSensitivityMode::automatic},
                                     {.contact_sensitivity = ContactSensitivityMode::always}};
  const auto facts_of_case = [](const CaseOptions& options) {
    Model model = testing::oscillator({});
    return text_of(run_case(model, GroundMotion{"short", 0.01, {0.0, 1.0, 0.0}}, options).analysis);
  };
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(facts_of_case(all[i]), facts_of_case(all[k])) << i << " " << k;
}

TEST(AnalysisFacts, HaveTheValuesAsGiven) {
  const AnalysisFacts facts = facts_of({.integrator = GeneralizedAlpha{.spectral_radius = 0.7}, .step = 1 * ms});
  EXPECT_NE(facts.integrator.find("0.7"), std::string::npos) << facts.integrator;
  EXPECT_EQ(facts.events, "located");
  EXPECT_EQ(facts.options.front(), (Parameter{"step", 1e-3, "s"}));
}

}  // namespace
}  // namespace moat
