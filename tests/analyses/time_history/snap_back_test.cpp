// Structures that are pulled aside and released. Far from the ground no row has a force but round-off at first.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "analyses/time_history/transient.hpp"
#include "analysis_testing.hpp"
#include "elements/line/shear_spring.hpp"

namespace moat {
namespace {

using namespace units;
using testing::still_ground;

// Very stiff storeys on a soft spring swing as one body: u = u0 cos(w t), w^2 = k/sum(m).
TEST(SnapBack, OfStiffStoreysIsTheSwingOfOneBody) {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> uniform{0.0, 1.0};
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE(round);
    const int storeys = 2 + static_cast<int>(16.0 * uniform(random));
    const double released_at = 0.05 + 0.3 * uniform(random), frequency = 2.0 + 2.0 * uniform(random);
    Model model;
    double mass = 0.0;
    NodeId below = ground;
    for (int storey = 0; storey <= storeys; ++storey) {
      const std::string number = std::to_string(storey);
      const double of_floor = std::pow(10.0, 3.0 + 3.0 * uniform(random));
      mass += of_floor;
      const NodeId above =
          add(model, Node{.name = "floor " + number, .mass = of_floor * kg, .initial_displacement = released_at * m});
      if (storey > 0)
        add(model, ShearSpring{.name = "storey " + number,
                               .lower = below,
                               .upper = above,
                               .stiffness = std::pow(10.0, 13.0 + uniform(random)) * N / m});
      below = above;
    }
    add(model, ShearSpring{.name = "isolation",
                           .lower = ground,
                           .upper = NodeId{0},
                           .stiffness = frequency * frequency * mass * N / m});
    Transient analysis{model, still_ground(1 * s)};
    analysis.run();
    const double expected = released_at * std::cos(frequency * model.state().time);
    for (const int node : {0, storeys}) EXPECT_NEAR(model.displacement(NodeId{node}), expected, 1e-4 * released_at);
  }
}

}  // namespace
}  // namespace moat
