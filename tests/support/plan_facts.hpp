// The facts of a model in plan, for tests of outputs.
#pragma once

#include "output/files/model_facts.hpp"

namespace moat::testing {

/// A column with a direction, a bearing without one, a floor and a corner in front of a wall.
inline ModelFacts plan_facts() {
  ModelFacts facts;
  facts.nodes = {{"floor:x", 550e3, 0.0, 0.0, 0.0, 0.0}};
  facts.elements = {{.name = "column",
                     .kind = "storey",
                     .law = "Linear",
                     .first = "ground",
                     .second = "floor",
                     .parameters = {},
                     .plan_places = PlanPlaces{{1.0, 2.0}, {1.5, 2.0}, {0.0, 1.0}}},
                    {.name = "bearing",
                     .kind = "bearing",
                     .law = "BiaxialBilinear",
                     .first = "ground",
                     .second = "floor",
                     .parameters = {},
                     .plan_places = PlanPlaces{{3.0, 4.0}, {3.0, 4.0}, {}}}};
  facts.diaphragms = {{"floor", 2.5, {0.5, 0.25}, {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}}}};
  CornerFacts& contact = facts.corners.emplace_back();
  static_cast<CornerPair&>(contact) = {.corner = "floor corner 1",
                                       .edge = "wall 2",
                                       .position = {4.0, 0.0},
                                       .edge_begin = {4.5, -1.0},
                                       .edge_end = {4.5, 4.0},
                                       .normal = {1.0, 0.0}};
  contact.element = "contact";
  contact.clearance = 0.5;
  return facts;
}

}  // namespace moat::testing
