// Reports list all options of an analysis.
#include "analyses/transient_texts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "analyses/integrators.hpp"

namespace moat {
namespace {

using namespace units;

// All facts in one text.
std::string text_of(const AnalysisFacts& facts) {
  std::string text = facts.integrator + ", " + facts.events;
  for (const Parameter& option : facts.options)
    text +=
        ", " + std::string{option.name} + " " + std::to_string(1e12 * option.value) + " " + std::string{option.unit};
  return text;
}

TEST(AnalysisFacts, DifferWhereAnyOptionDiffers) {
  const std::vector<TransientOptions> all{{},
                                          {.integrator = GeneralizedAlpha{}},
                                          {.integrator = GeneralizedAlpha{.spectral_radius = 0.7}},
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
                                          {.events = EventTreatment::located},
                                          {.events = EventTreatment::inside_the_step},
                                          {.max_events_per_second = 100}};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_NE(text_of(facts_of(all[i])), text_of(facts_of(all[k]))) << i << " " << k;
}

TEST(AnalysisFacts, HaveTheValuesAsGiven) {
  const AnalysisFacts facts = facts_of({.integrator = GeneralizedAlpha{.spectral_radius = 0.7}, .step = 1 * ms});
  EXPECT_NE(facts.integrator.find("0.7"), std::string::npos) << facts.integrator;
  EXPECT_EQ(facts.events, "automatic");
  EXPECT_EQ(facts.options.front(), (Parameter{"step", 1e-3, "s"}));
}

}  // namespace
}  // namespace moat
