#include "elements/block/plan_point.hpp"

#include <cmath>
#include <vector>

namespace moat {

namespace {

bool same_body(const Model& model, NodeId a, NodeId b) {
  return a == b || (a != ground && b != ground && model.body(a).first == model.body(b).first);
}

void check_body(const Model& model, const Check& check, const std::string& field, NodeId body) {
  model.require_node(body, check, field);
  if (body == ground || model.diaphragm_of(body) != nullptr) return;
  check.that(model.body(body).direction.has_value(),
             field + " is the node \"" + model.body(body).name + "\", which moves on a line.",
             "Give a diaphragm, a node with a .direction, or `ground`.");
}

}  // namespace

PlanRow row_of(const Model& model, NodeId body, PlanPosition at, PlanVector direction) {
  if (body == ground) return {};
  if (const PlacedDiaphragm* diaphragm = model.diaphragm_of(body)) {
    const DiaphragmId& id = diaphragm->id;
    return {id.degrees_of_freedom(), diaphragm->weights(at.si(), direction)};
  }
  return {{body, ground, ground}, {dot(*model.body(body).direction, direction), 0.0, 0.0}};
}

void check_point(const Model& model, std::string_view kind, const std::string& name, std::string_view field,
                 const PlanPoint& point) {
  const Check check{kind, name};
  const std::string text{field};
  check_body(model, check, text + ".of", point.of);
  check.finite(text + ".at.x", point.at.x);
  check.finite(text + ".at.y", point.at.y);
  check.that(point.share >= 0.0 && point.share < 1.0, text + ".share", point.share, "1", ">= 0 and < 1",
             "It is the way from .of to .other; take the other body itself for 1.");
  check.that(point.other.specified() || point.share == 0.0, text + ".share is given without .other.",
             "Give the body at the other end of the column.");
  if (!point.other.specified()) return;
  check_body(model, check, text + ".other", point.other);
  check.that(!same_body(model, point.of, point.other), text + ".of and " + text + ".other are the same body.",
             "Leave .other out for a point of one body.");
}

Check check_points(const Model& model, std::string_view kind, const std::string& name, std::string_view first_field,
                   const PlanPoint& first, std::string_view second_field, const PlanPoint& second) {
  check_point(model, kind, name, first_field, first);
  check_point(model, kind, name, second_field, second);
  const Check check{kind, name};
  const auto bodies = [](const PlanPoint& point) {
    return point.is_on_body() ? std::vector<NodeId>{point.of} : std::vector<NodeId>{point.of, point.other};
  };
  for (const NodeId a : bodies(first))
    for (const NodeId b : bodies(second))
      check.that(!same_body(model, a, b),
                 std::string{first_field} + " and " + std::string{second_field} + " are points of the same body.",
                 "An element joins points of two bodies.");
  return check;
}

PlanVector unit_direction(const Check& check, std::string_view field, PlanVector direction) {
  const double size = length(direction);
  check.that(std::isfinite(size) && size > 0.0, field, size, "1", "a vector of finite length > 0",
             "Give the direction along which the element acts, for example {1, 0}.");
  return direction / size;
}

std::shared_ptr<const ElementDetails> plan_details(const PlanPoint& first, const PlanPoint& second,
                                                   PlanVector direction, ElementDetails details) {
  details.plan_places = PlanPlaces{first.at.si(), second.at.si(), direction};
  return std::make_shared<const ElementDetails>(std::move(details));
}

}  // namespace moat
