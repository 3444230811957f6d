// The bodies of a model.
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "model/model.hpp"

namespace moat {

void Model::check_new_name(const Check& check, const std::string& name) const {
  check.fits_tables(name);
  check.that(name != "ground", "this name is taken.", "`ground` is always there; choose another name.");
  check.that(!body_names_.contains(name), "a node or diaphragm of this name exists.", "Give every one its own name.");
}

void Model::begin_body(Body body) {
  body.first = body.follows ? NodeId{NodeId::first_follower + static_cast<int>(followers_.size())}
                            : NodeId{degrees_of_freedom()};
  body_names_.insert(body.name);
  bodies_.push_back(std::move(body));
  ++additions_;
}

NodeId Model::append(std::string name, double mass, GroundVector influence, double displacement, double velocity) {
  body_names_.insert(name);
  own_shares_.push_back({NodeId{degrees_of_freedom()}, 1.0});
  names_.push_back(std::move(name));
  body_of_.push_back(bodies_.size() - 1);
  mass_.append(mass);
  given_masses_.push_back(mass);
  influence_x_.push_back(influence.x);
  influence_y_.push_back(influence.y);
  influence_z_.push_back(influence.z);
  moves_along_x_ = moves_along_x_ && influence == GroundVector{1.0, 0.0, 0.0};
  initial_displacement_.push_back(displacement);
  initial_velocity_.push_back(velocity);
  return NodeId{degrees_of_freedom() - 1};
}

NodeId Model::append_follower(std::string name, double mass, const Follower& motion, std::size_t row) {
  body_names_.insert(name);
  followers_.push_back({std::move(name), mass, motion.ground_influence[row], motion.shares[row], bodies_.size() - 1});
  return NodeId{NodeId::first_follower + static_cast<int>(followers_.size()) - 1};
}

Body Model::checked(const Node& node) const {
  const Check check{"Node", node.name};
  check.that(!node.name.empty(), "a node has no name.", "Give .name: results are listed under it.");
  check_new_name(check, node.name);
  check.positive("mass", node.mass, "Every degree of freedom needs mass.");
  check.finite("initial_displacement", node.initial_displacement);
  check.finite("initial_velocity", node.initial_velocity);
  check.positive("half_width", node.half_width);
  if (node.direction) {
    constexpr double round_off = 1e-9;
    const double its_length = length(*node.direction);
    check.that(std::abs(its_length - 1.0) <= round_off, "length of direction", its_length, "1", "1",
               "Give the unit vector along which the node moves.");
  }
  check.that(node.direction || !is_plan(), "a node without direction in a model with diaphragms.",
             "Give .direction, or a Diaphragm in place of the node: a model moves on a line or in plan.");
  Body body{.name = node.name,
            .x = node.x.si(),
            .height = node.height.si(),
            .half_width = node.half_width.si(),
            .free = node.free};
  if (node.direction) body.direction = *node.direction;
  return body;
}

NodeId Model::add_node(const Node& node) {
  Body body = checked(node);
  const PlanVector along = body.direction.value_or(PlanVector{1.0, 0.0});
  begin_body(std::move(body));
  return append(node.name, node.mass.value().si(), {along.x, along.y, 0.0}, node.initial_displacement.si(),
                node.initial_velocity.si());
}

void Model::check_follower(const Check& check, const Follower& motion, std::size_t rows) const {
  check.that(motion.shares.size() == rows && motion.ground_influence.size() == rows,
             "shares and ground_influence have not one entry for each degree of freedom.",
             "Give one for a node, three for a diaphragm.");
  for (const std::vector<MotionShare>& row : motion.shares) {
    check.that(!row.empty(), "a node follows nothing.", "Give the degrees of freedom that move it.");
    for (const MotionShare& share : row) {
      require_node(share.node, check, "a node that it follows");
      check.that(share.node != ground && !share.node.is_follower(), "it follows the ground or another follower.",
                 "Give degrees of freedom with mass.");
      check.finite("weight", share.weight, "1");
    }
  }
}

NodeId Model::add_follower(const Node& node, Follower motion) {
  Body body = checked(node);
  check_follower(Check{"Node", node.name}, motion, 1);
  body.follows = true;
  begin_body(std::move(body));
  return append_follower(node.name, node.mass.value().si(), motion, 0);
}

DiaphragmId Model::add_follower(const Diaphragm& diaphragm, Follower motion) {
  PlacedDiaphragm placed = checked(diaphragm);
  check_follower(Check{"Diaphragm", diaphragm.name}, motion, 3);
  begin_body(body_of_diaphragm(placed, diaphragm.free, true));
  placed.id.x = append_follower(diaphragm.name + ":x", placed.mass, motion, 0);
  placed.id.y = append_follower(diaphragm.name + ":y", placed.mass, motion, 1);
  placed.id.r = append_follower(diaphragm.name + ":r", placed.mass, motion, 2);
  diaphragms_.push_back(std::move(placed));
  return diaphragms_.back().id;
}

PlacedDiaphragm Model::checked(const Diaphragm& diaphragm) const {
  const double inertia = checked_rotary_inertia(diaphragm);
  const Check check{"Diaphragm", diaphragm.name};
  check_new_name(check, diaphragm.name);
  for (const Body& body : bodies_)
    if (body.nodes == 1 && !body.direction && !body.generalised)
      check.that(false, "the model has the node \"" + body.name + "\", which moves on a line.",
                 "Give that node a .direction, or make it a Diaphragm: a model moves on a line or in plan.");
  for (const char* suffix : {":x", ":y", ":r"})
    check.that(!body_names_.contains(diaphragm.name + suffix), "a node \"" + diaphragm.name + suffix + "\" exists.",
               "Give every node and diaphragm its own name.");
  const double mass = diaphragm.mass.si(), gyration = std::sqrt(inertia / mass);
  check.finite("initial_displacement.x", diaphragm.initial_displacement.x);
  check.finite("initial_displacement.y", diaphragm.initial_displacement.y);
  check.finite("initial_rotation", diaphragm.initial_rotation.si(), "rad");
  check.finite("initial_velocity_x", diaphragm.initial_velocity_x);
  check.finite("initial_velocity_y", diaphragm.initial_velocity_y);
  check.finite("initial_angular_velocity", diaphragm.initial_angular_velocity.si(), "rad/s");
  return {.name = diaphragm.name,
          .id = {},
          .mass = mass,
          .gyration = gyration,
          .centre_of_mass = diaphragm.centre_of_mass.si(),
          .outline = diaphragm.outline,
          .height = diaphragm.height.si()};
}

Body Model::body_of_diaphragm(const PlacedDiaphragm& placed, bool free, bool follows) const {
  return {.name = placed.name,
          .x = placed.centre_of_mass.x,
          .y = placed.centre_of_mass.y,
          .height = placed.height,
          .nodes = 3,
          .free = free,
          .follows = follows,
          .diaphragm = diaphragms_.size()};
}

DiaphragmId Model::add_diaphragm(const Diaphragm& diaphragm) {
  PlacedDiaphragm placed = checked(diaphragm);
  const double mass = placed.mass, arc = placed.gyration * diaphragm.initial_rotation.si(),
               arc_speed = placed.gyration * diaphragm.initial_angular_velocity.si();
  begin_body(body_of_diaphragm(placed, diaphragm.free, false));
  placed.id.x = append(diaphragm.name + ":x", mass, {1.0, 0.0, 0.0}, diaphragm.initial_displacement.x.si(),
                       diaphragm.initial_velocity_x.si());
  placed.id.y = append(diaphragm.name + ":y", mass, {0.0, 1.0, 0.0}, diaphragm.initial_displacement.y.si(),
                       diaphragm.initial_velocity_y.si());
  // The ground does not turn.
  placed.id.r = append(diaphragm.name + ":r", mass, {}, arc, arc_speed);
  diaphragms_.push_back(std::move(placed));
  return diaphragms_.back().id;
}

std::vector<NodeId> Model::add_body(const GeneralisedBody& body) {
  const Check check{"GeneralisedBody", body.name};
  check.that(!body.name.empty(), "a body has no name.", "Give .name: results are listed under it.");
  check_new_name(check, body.name);
  const auto count = static_cast<Eigen::Index>(body.coordinates.size());
  check.that(count > 0, "no coordinates are given.", "Give .coordinates, at least one.");
  check.that(body.mass.rows() == count && body.mass.cols() == count && body.mass.allFinite() &&
                 body.mass == body.mass.transpose() && Eigen::LLT<Eigen::MatrixXd>{body.mass}.info() == Eigen::Success,
             "the mass matrix is not symmetric and positive definite with one row for each of the coordinates.",
             "Every coordinate needs mass, and masses couple both ways alike.");
  for (std::size_t i = 0; i < body.coordinates.size(); ++i) {
    const GeneralisedCoordinate& coordinate = body.coordinates[i];
    check.fits_tables(coordinate.name);
    check.that(!body_names_.contains(body.name + ":" + coordinate.name) &&
                   std::ranges::count(body.coordinates, coordinate.name, &GeneralisedCoordinate::name) == 1,
               "a node \"" + body.name + ":" + coordinate.name + "\" exists.", "Give every coordinate its own name.");
    check.finite("initial_displacement", Length{coordinate.initial_displacement});
    check.finite("initial_velocity", Speed{coordinate.initial_velocity});
  }
  begin_body({.name = body.name,
              .x = body.x.si(),
              .y = body.y.si(),
              .height = body.height.si(),
              .nodes = static_cast<int>(count),
              .free = body.free,
              .generalised = true});
  std::vector<NodeId> nodes;
  for (const GeneralisedCoordinate& coordinate : body.coordinates)
    nodes.push_back(append(body.name + ":" + coordinate.name, 0.0, coordinate.ground_influence,
                           coordinate.initial_displacement, coordinate.initial_velocity));
  add_mass(nodes, body.mass);
  return nodes;
}

void Model::add_mass(const std::vector<NodeId>& nodes, const Eigen::MatrixXd& mass) {
  const Check check{"Model", ""};
  std::vector<int> rows;
  for (const NodeId node : nodes) {
    require_node(node, check, "a node of added mass");
    check.that(node != ground && !node.is_follower() && std::ranges::count(nodes, node) == 1,
               "a node of added mass is the ground, repeated, or follows others.",
               "Give different degrees of freedom.");
    rows.push_back(node.index);
  }
  const auto count = static_cast<Eigen::Index>(rows.size());
  check.that(mass.rows() == count && mass.cols() == count && mass.allFinite() && mass == mass.transpose(),
             "the added mass is not a symmetric matrix with one row per node.", "Give such a matrix, in kg.");
  check.that(mass_.add(rows, mass), "the mass matrix is not positive definite with the added mass.",
             "Couple degrees of freedom by less than the mass that they have.");
  ++additions_;
}

}  // namespace moat
