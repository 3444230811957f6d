// The diaphragms of a model.
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "model/checked_name.hpp"
#include "model/model.hpp"

namespace moat {

DiaphragmId Model::add_diaphragm(const Diaphragm& diaphragm) {
  const double inertia = checked_rotary_inertia(diaphragm);
  const Check check{"Diaphragm", diaphragm.name};
  check_name(check, diaphragm.name);
  check.that(diaphragm.name != "ground", "this name is taken.", "`ground` is always there; choose another name.");
  check.that(!has_node(diaphragm.name), "a diaphragm or node of this name exists.", "Give every one its own name.");
  for (const Node& node : nodes_)
    if (!node.direction)
      check.that(false, "the model has the node \"" + node.name + "\", which moves on a line.",
                 "Give that node a .direction, or make it a Diaphragm: a model moves on a line or in plan.");
  const double gyration = std::sqrt(inertia / diaphragm.mass.si());
  // All three before the first is added.
  for (const char* suffix : {":x", ":y", ":r"})
    check.that(!has_node(diaphragm.name + suffix), "a node \"" + diaphragm.name + suffix + "\" exists.",
               "Give every node and diaphragm its own name.");
  const Length arc = gyration * diaphragm.initial_rotation * units::m;
  const Speed arc_speed = gyration * units::m * diaphragm.initial_angular_velocity;
  for (const Length displacement : {diaphragm.initial_displacement.x, diaphragm.initial_displacement.y, arc})
    check.finite("initial_displacement", displacement);
  for (const Speed velocity : {diaphragm.initial_velocity_x, diaphragm.initial_velocity_y, arc_speed})
    check.finite("initial_velocity", velocity);
  const auto degree_of_freedom = [&](const char* suffix, PlanVector direction, Length displacement, Speed velocity) {
    return append_node({.name = diaphragm.name + suffix,
                        .mass = diaphragm.mass,
                        .initial_displacement = displacement,
                        .initial_velocity = velocity,
                        .free = diaphragm.free,
                        .height = diaphragm.height,
                        .direction = direction});
  };
  PlacedDiaphragm placed{.name = diaphragm.name,
                         .id = {},
                         .mass = diaphragm.mass.si(),
                         .gyration = gyration,
                         .centre_of_mass = diaphragm.centre_of_mass.si(),
                         .outline = diaphragm.outline,
                         .height = diaphragm.height.si()};
  placed.id.x = degree_of_freedom(":x", {1.0, 0.0}, diaphragm.initial_displacement.x, diaphragm.initial_velocity_x);
  placed.id.y = degree_of_freedom(":y", {0.0, 1.0}, diaphragm.initial_displacement.y, diaphragm.initial_velocity_y);
  // The ground does not turn.
  placed.id.r = degree_of_freedom(":r", {}, arc, arc_speed);
  diaphragm_of_node_.resize(nodes_.size(), -1);
  for (const NodeId node : placed.id.degrees_of_freedom())
    diaphragm_of_node_[static_cast<std::size_t>(node.index)] = static_cast<int>(diaphragms_.size());
  diaphragms_.push_back(placed);
  node_names_.insert(placed.name);
  return placed.id;
}

const PlacedDiaphragm& Model::diaphragm(DiaphragmId id) const {
  const PlacedDiaphragm* found = id.x.index >= 0 && id.x.index < node_count() ? diaphragm_of(id.x) : nullptr;
  if (found == nullptr || found->id != id)
    throw InputError{
        "Model: this is not a diaphragm of the model. Use the DiaphragmId that add(model, Diaphragm{...}) "
        "returned."};
  return *found;
}

const PlacedDiaphragm* Model::diaphragm_of(NodeId node) const {
  if (node.index < 0 || static_cast<std::size_t>(node.index) >= diaphragm_of_node_.size()) return nullptr;
  const int index = diaphragm_of_node_[static_cast<std::size_t>(node.index)];
  return index < 0 ? nullptr : &diaphragms_[static_cast<std::size_t>(index)];
}

std::string_view Model::body_name(NodeId id) const {
  const PlacedDiaphragm* diaphragm = diaphragm_of(id);
  return diaphragm != nullptr ? diaphragm->name : node_name(id);
}

std::span<const NodeId> Model::body_of(NodeId node) const {
  if (node == ground) return {};
  const PlacedDiaphragm* diaphragm = diaphragm_of(node);
  const NodeId first = diaphragm != nullptr ? diaphragm->id.x : node;
  return std::span{ids_}.subspan(static_cast<std::size_t>(first.index), diaphragm != nullptr ? 3 : 1);
}

}  // namespace moat
