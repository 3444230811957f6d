// The heat of a lead core is of second order in the length of steps.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "analyses/time_history/transient.hpp"
#include "base/units.hpp"
#include "elements/line/isolator.hpp"
#include "materials/isolation/heated_lead_rubber.hpp"

namespace moat::testing {
namespace {

using namespace units;

// The displacement after seven seconds of a sine that slides again and again.
double displacement_with(Time step) {
  Model model;
  const NodeId node = add(model, Node{.name = "mass", .mass = 150 * tonne});
  add(model, Isolator<HeatedLeadRubber>{.upper = node, .law = HeatedLeadRubber::typical()});
  std::vector<double> samples;
  for (int i = 0; i <= 700; ++i) {
    const double t = 0.01 * i, pi = std::numbers::pi;
    samples.push_back(4.0 * std::sin(pi * t / 12.0) * std::sin(2.0 * pi * t / 1.6));
  }
  Transient analysis{model, GroundMotion{"sine", 0.01, samples}, {.step = step}};
  while (!analysis.finished()) analysis.advance();
  return model.displacement(node);
}

TEST(HeatedLeadRubber, IsOfSecondOrderInTheStep) {
  const double exact = displacement_with(0.25 * ms);
  const double coarse = displacement_with(8 * ms) - exact, middle = displacement_with(4 * ms) - exact,
               fine = displacement_with(2 * ms) - exact;
  EXPECT_NEAR(std::log2(coarse / middle), 2.0, 0.2);
  EXPECT_NEAR(std::log2(middle / fine), 2.0, 0.2);
}

}  // namespace
}  // namespace moat::testing
