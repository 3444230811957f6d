// A table of constructions that are wrong or extreme: every one gives the right answer, or a message with its remedy.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "moat.hpp"
#include "small_models.hpp"

namespace moat::constructions {

using testing::still_ground;

/// One row of the table.
struct Construction {
  std::string name;  ///< Unique in the table.
  /// Makes it. A valid one compares its answer with a closed form.
  std::function<void()> build;
  /// Words of its message in their order: object, parameter, value with unit, range, remedy. None: it is valid, and
  /// nothing is thrown.
  std::vector<std::string> words{};
};
using Constructions = std::vector<Construction>;

// The families of the table, a file for each.
Constructions laws();
Constructions laws_in_plan();
Constructions bearings();
Constructions contacts();
Constructions contact_estimates();
Constructions elements();
Constructions buildings();
Constructions buildings_in_plan();
Constructions neighbours_and_moats();
Constructions superstructures();
Constructions frames();
Constructions motions();
Constructions spectra();
Constructions analyses();
Constructions studies();
Constructions charts();
Constructions sheets();
Constructions script_options();

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// A mass on the ground, which a link of this law holds.
template <class Law>
void add_link(const Law& law) {
  using namespace units;
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne});
  if constexpr (IsolatorLaw<Law>)
    add(model, Isolator<Law>{.name = "link", .upper = body, .law = law, .weight = 1 * MN});
  else
    add(model, Spring<Law>{.name = "link", .lower = ground, .upper = body, .law = law});
}
/// Such a link of typical parameters, of which one is changed.
template <class Law, class Change>
std::function<void()> link(Change change) {
  return [change] {
    Law law = Law::typical();
    change(law);
    add_link(law);
  };
}

/// A body that flies on a line towards a wall at 1 m.
template <class Law>
void add_wall_gap(const Law& law, Length clearance = 1.0 * units::m) {
  using namespace units;
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne, .free = true});
  add(model, Gap<Law>{.name = "west", .left = body, .right = ground, .clearance = clearance, .law = law});
}

}  // namespace moat::constructions
