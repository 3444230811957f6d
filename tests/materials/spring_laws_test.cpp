// Duties of every law of isolators, dampers, storeys and soil, with parameters drawn at random. The tests of each law
// have its own properties.
#include "materials/spring_laws.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "message_of.hpp"
#include "random_spring.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

TEST(EverySpringLaw, HasExactTangentsAndIsPure) {
  AllSpringLaws::for_each([]<class Law>() {
    for_random_laws<Law>(6, [](const auto& law) {
      const SpringTrial trial{
          .deformation = natural_deformation(law), .rate = 0.3, .one_speed = WeightBearing<Law>, .moves = 60};
      expect_tangents(law, trial);
      expect_purity(law, trial);
    });
  });
}

TEST(EverySpringLaw, KnowsTheRatesOfWhatItReports) {
  AllSpringLaws::for_each([]<class Law>() {
    SCOPED_TRACE(Law::name);
    for_random_laws<Law>(6, [](const auto& law) {
      expect_rates_of_quantities(
          law, {.deformation = natural_deformation(law), .rate = 0.3, .one_speed = WeightBearing<Law>, .moves = 60});
    });
  });
}

template <class Law>
constexpr bool may_give_back = std::is_same_v<Law, GrantRubber> || std::is_same_v<Law, KikuchiAikenRubber> ||
                               std::is_same_v<Law, BaberNoori> || std::is_same_v<Law, ImkBilinear>;

TEST(EverySpringLaw, BalancesItsEnergyWhateverThePieces) {
  AllSpringLaws::for_each([]<class Law>() {
    for_random_laws<Law>(3, []<class Acting>(const Acting& law) {
      const SpringTrial trial{.deformation = natural_deformation(law),
                              .rate = 0.3,
                              .energy = 1e-6,  // of the quadrature in GrantRubber
                              .pieces = 1e-7,
                              .symmetric = !std::is_same_v<Acting, HyperbolicBackfill>,
                              .gives_back = may_give_back<Law>,
                              .one_speed = WeightBearing<Law>,
                              .moves = 16};
      if constexpr (TimeDependentLaw<Acting>) {
        expect_energy_balance_in_short_steps(law, trial);
      } else {
        expect_energy_balance(law, trial);
        expect_independence_of_pieces(law, trial);
      }
      expect_symmetry(law, trial);
    });
  });
}

// A number that is none is refused in every field, by the name of the parameter.
TEST(EverySpringLaw, RefusesNumbersThatAreNone) {
  AllSpringLaws::for_each([]<class Law>() {
    SCOPED_TRACE(Law::name);
    int fields = 0;
    Law sample = Law::typical();
    for_each_field(sample, [&](auto&) { ++fields; });
    for (int wrong = 0; wrong < fields; ++wrong) {
      Law law = Law::typical();
      int at = 0;
      bool is_number = false;
      for_each_field(law, [&](auto& field) {
        using Field = std::remove_reference_t<decltype(field)>;
        if (at++ != wrong) return;
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        if constexpr (std::is_same_v<Field, double> || std::is_same_v<Field, Required<double>>) {
          field = none;
          is_number = true;
        } else if constexpr (requires { std::remove_cvref_t<decltype(field.value())>{none}.si(); }) {
          field = std::remove_cvref_t<decltype(field.value())>{none};
          is_number = true;
        } else if constexpr (requires { Field{none}.si(); }) {
          field = Field{none};
          is_number = true;
        }
      });
      if (!is_number) continue;
      EXPECT_NE(message_of([&] {
                  law.check(Check{"Isolator", "bearings"});
                }),
                "nothing was thrown")
          << "field " << wrong;
    }
  });
}

}  // namespace
}  // namespace moat::testing
