// The retaining walls beside an isolated base.
#pragma once

#include <optional>

#include "elements/gap.hpp"
#include "elements/spring.hpp"
#include "elements/viscous_damper.hpp"
#include "materials/linear.hpp"

namespace moat {

/// A wall that gives way: a mass on a spring and a dashpot, fixed to the ground.
///
///     ///--[spring]--
///     ///            [mass]  |<- clearance ->[ base ]
///     ///--[dashpot]-
struct FlexibleWall {
  /// > 0 kg that moves with the face of the wall.
  Required<Mass> mass;
  /// > 0 N/m of wall and soil behind it.
  Required<Stiffness> stiffness;
  /// >= 0 N s/m.
  DampingCoefficient damping{};
};

/// On which sides of the base a moat has a wall.
enum class Sides { left, right, both };

/// A moat: walls beside a node, at the same clearance.
///
///     wall |<- clearance ->[ around ]<- clearance ->| wall
///
/// Gaps "<name> left" and "<name> right", whose impact forces share the place <name>; a moat on one side alone is one
/// gap "<name>". The walls are fixed to the ground, or nodes "<name> left wall", "<name> right wall" or "<name> wall"
/// on springs where `wall` is given; then `wall_force` [N] and `wall_deformation` [m] are reported too.
template <ImpactLaw Law>
struct Moat {
  std::string name = "moat";
  Required<NodeId> around;
  /// > 0 m, on each side at rest.
  Required<Length> clearance;
  Law law;
  Sides sides = Sides::both;
  std::optional<FlexibleWall> wall{};
};

/// Adds a flexible wall and returns its node.
NodeId add_wall(Model& model, const FlexibleWall& wall, const std::string& name, NodeId around, double offset);

/// Throws InputError as the gaps and walls would.
template <ImpactLaw Law>
void add(Model& model, const Moat<Law>& moat) {
  Check{"Moat", moat.name}.that(!moat.name.empty(), "a moat has no name.", "Give .name, or leave it out: \"moat\".");
  model.require_node(moat.around, Check{"Moat", moat.name}, "around");
  const auto face = [&](const std::string& side, double direction) {
    return moat.wall ? add_wall(model, *moat.wall, side + " wall", moat.around, direction * moat.clearance.si())
                     : ground;
  };
  if (moat.sides != Sides::right) {
    const std::string name = moat.name + (moat.sides == Sides::both ? " left" : "");
    add(model, Gap<Law>{.name = name,
                        .place = moat.name,
                        .left = face(name, -1.0),
                        .right = moat.around.value(),
                        .clearance = moat.clearance,
                        .law = moat.law});
  }
  if (moat.sides != Sides::left) {
    const std::string name = moat.name + (moat.sides == Sides::both ? " right" : "");
    add(model, Gap<Law>{.name = name,
                        .place = moat.name,
                        .left = moat.around.value(),
                        .right = face(name, 1.0),
                        .clearance = moat.clearance,
                        .law = moat.law});
  }
}

}  // namespace moat
