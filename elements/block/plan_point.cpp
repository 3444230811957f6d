#include "elements/block/plan_point.hpp"

#include <cmath>

namespace moat {

PlanRow row_of(const Model& model, const PlanPoint& point, PlanVector direction) {
  const NodeId body = point.of;
  if (body == ground) return {};
  if (const PlacedDiaphragm* diaphragm = model.diaphragm_of(body)) {
    const DiaphragmId& id = diaphragm->id;
    return {id.degrees_of_freedom(), diaphragm->weights(point.at.si(), direction)};
  }
  return {{body, ground, ground}, {dot(*model.body(body).direction, direction), 0.0, 0.0}};
}

void check_point(const Model& model, std::string_view kind, const std::string& name, std::string_view field,
                 const PlanPoint& point) {
  const Check check{kind, name};
  const std::string text{field};
  model.require_node(point.of, check, text + ".of");
  check.finite(text + ".at.x", point.at.x);
  check.finite(text + ".at.y", point.at.y);
  const NodeId body = point.of;
  if (body == ground || model.diaphragm_of(body) != nullptr) return;
  check.that(model.body(body).direction.has_value(),
             text + ".of is the node \"" + model.body(body).name + "\", which moves on a line.",
             "Give a diaphragm, a node with a .direction, or `ground`.");
}

Check check_points(const Model& model, std::string_view kind, const std::string& name, std::string_view first_field,
                   const PlanPoint& first, std::string_view second_field, const PlanPoint& second) {
  check_point(model, kind, name, first_field, first);
  check_point(model, kind, name, second_field, second);
  const Check check{kind, name};
  const auto same_body = [&](NodeId a, NodeId b) {
    return a == b || (a != ground && b != ground && model.diaphragm_of(a) != nullptr &&
                      model.diaphragm_of(a) == model.diaphragm_of(b));
  };
  check.that(!same_body(first.of, second.of),
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
                                                   PlanVector direction) {
  return std::make_shared<const ElementDetails>(
      ElementDetails{.plan_places = PlanPlaces{first.at.si(), second.at.si(), direction}});
}

}  // namespace moat
