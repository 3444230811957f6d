// Free impacts: momentum stays, energy goes where the ledger says, and every law delivers its restitution.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "collision.hpp"
#include "impact_cases.hpp"
#include "outcome.hpp"
#include "random_cases.hpp"
#include "random_draws.hpp"
#include "small_models.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Forces balance to 1e-8 of the largest, over the impulse of a few impacts.
constexpr double balanced = 1e-7;
// TransientOptions::steps_per_contact: 32 give restitution to 1e-3.
constexpr double of_restitution = 1e-3;

// Adds a gap of any law.
void add_any_gap(Model& model, RandomDraws& draws, const std::string& name, NodeId left, NodeId right) {
  int chosen = draws.integer(0, AllImpactLaws::size - 1);
  const double stiffness = draws.decades(1e7, 1e10), restitution = draws.uniform(0.2, 0.95);
  const Length clearance = draws.uniform(0.01, 0.2) * m;
  AllImpactLaws::for_each([&]<class Law>() {
    if (chosen-- == 0)
      add(model, Gap<Law>{.name = name,
                          .left = left,
                          .right = right,
                          .clearance = clearance,
                          .law = impact_law<Law>(stiffness, restitution)});
  });
}

// Energies of both motions close the ledger.
void expect_energy(const Outcome& outcome) {
  const EnergyBalance& energy = outcome.energy;
  RC_ASSERT(energy.error_share() <= CaseOptions{}.warn_above_energy_error);
  RC_ASSERT(energy.impact >= -1e-3 * energy.largest_kinetic);
}

TEST(FreeImpacts, OfBodiesInARowKeepTheirMomentum) {
  for_random_cases(20, [] {
    RandomDraws draws{*seeds()};
    Problem problem{Model{}, still_ground(3 * s)};
    const int bodies = draws.integer(2, 6);
    std::vector<double> masses, velocities;
    for (int i = 0; i < bodies; ++i) {
      masses.push_back(draws.decades(1e3, 1e6));
      velocities.push_back(draws.uniform(-1.0, 1.0));
      add(problem.model, Node{.name = std::to_string(i),
                              .mass = masses.back() * kg,
                              .initial_velocity = velocities.back() * m / s,
                              .free = true});
      if (i > 0) add_any_gap(problem.model, draws, "gap " + std::to_string(i), NodeId{i - 1}, NodeId{i});
    }
    const Outcome outcome = outcome_of(problem);
    double before = 0.0, now = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < masses.size(); ++i) {
      before += masses[i] * velocities[i];
      now += masses[i] * outcome.end.velocity[static_cast<Eigen::Index>(i)];
      largest += masses[i] * std::abs(velocities[i]);
    }
    RC_ASSERT(std::abs(now - before) <= balanced * largest);
    expect_energy(outcome);
  });
}

TEST(FreeImpacts, OfSlabsInPlanKeepMomentumAndAngularMomentum) {
  for_random_cases(20, [] {
    RandomDraws draws{*seeds()};
    const double friction = *rc::gen::element(0.0, 0.4).as("friction");
    Problem problem{Model{}, still_ground(3 * s)};
    std::vector<DiaphragmId> slabs;
    for (const double side : {-1.0, 1.0}) {
      const Angle turn = draws.uniform(-0.1, 0.1) * rad;
      const PlanPosition centre{side * 6.5 * m, draws.uniform(-2, 2) * m};
      const Length width = draws.uniform(8, 11) * m, depth = draws.uniform(6, 12) * m;
      const PlanOutline outline = turned(rectangle(width, depth, centre), turn, centre);
      slabs.push_back(add(problem.model, Diaphragm{.name = side < 0.0 ? "left" : "right",
                                                   .mass = draws.decades(1e5, 1e6) * kg,
                                                   .centre_of_mass = centre,
                                                   .outline = outline,
                                                   .initial_velocity_x = -side * draws.uniform(0.2, 1.0) * m / s,
                                                   .initial_velocity_y = draws.uniform(-0.5, 0.5) * m / s,
                                                   .free = true}));
    }
    add(problem.model, PlanNeighbours{.first = slabs[0],
                                      .second = slabs[1],
                                      .law = HertzDamp{.stiffness = draws.decades(1e8, 1e10) * N / m_3_2,
                                                       .restitution = draws.uniform(0.3, 0.9)},
                                      .friction = friction,
                                      .reach = 20 * m});
    const Outcome outcome = outcome_of(problem);
    RC_PRE(!outcome.impacts.empty());
    struct Momentum {
      double x = 0.0, y = 0.0, angular = 0.0, largest = 0.0;
    };
    const auto momentum_of = [&](const MotionState& motion) {
      Momentum sum;
      for (const DiaphragmId& slab : slabs) {
        const PlacedDiaphragm& placed = problem.model.diaphragm(slab);
        const double mass = problem.model.mass(slab.x), vx = motion.velocity[slab.x.index],
                     vy = motion.velocity[slab.y.index], vr = motion.velocity[slab.r.index];
        sum.x += mass * vx;
        sum.y += mass * vy;
        sum.angular += mass * (placed.centre_of_mass.x * vy - placed.centre_of_mass.y * vx + placed.gyration * vr);
        sum.largest += mass * std::hypot(vx, vy);
      }
      return sum;
    };
    const Momentum before = momentum_of(problem.model.initial_motion()), now = momentum_of(outcome.end);
    RC_ASSERT(std::abs(now.x - before.x) <= balanced * before.largest);
    RC_ASSERT(std::abs(now.y - before.y) <= balanced * before.largest);
    // Friction acts at the corner and at the edge, which in the geometry at rest are apart by the clearance.
    constexpr double arm = 10.0;  // m
    if (friction == 0.0) RC_ASSERT(std::abs(now.angular - before.angular) <= balanced * arm * before.largest);
    expect_energy(outcome);
  });
}

TEST(FreeImpacts, DeliverTheRestitutionOfTheLaw) {
  for_random_cases(60, [] {
    RandomDraws draws{*seeds()};
    const double stiffness = draws.decades(1e5, 1e12), restitution = draws.uniform(0.05, 1.0);
    const Collision collision{draws.decades(1.0, 1e7), draws.decades(1.0, 1e7), draws.decades(1e-3, 5.0), draws.unit()};
    AllImpactLaws::for_each([&]<class Law>() {
      const Law law = impact_law<Law>(stiffness, restitution);
      try {
        law.check(Check{"law", ""});
      } catch (const InputError&) {
        return;  // A law that cannot deliver so little.
      }
      const double found = delivered(law, collision),
                   expected = delivered_by(law, collision.effective_mass(), collision.approach_speed);
      RC_LOG() << Law::name << " " << stiffness << ", e " << restitution << ", masses " << collision.left_mass
               << " and " << collision.right_mass << " kg, " << collision.approach_speed << " m/s: " << found << " for "
               << expected << "\n";
      RC_ASSERT(std::abs(found - expected) <= of_restitution);
    });
  });
}

}  // namespace
}  // namespace moat::testing
