// Nodes, bodies, and elements between them.
#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

std::function<void()> node(const Node& node) {
  return [node] {
    Model model;
    add(model, Node{.name = "base", .mass = 1 * kg});
    add(model, node);
  };
}
std::function<void()> diaphragm(const Diaphragm& diaphragm) {
  return [diaphragm] {
    Model model;
    add(model, diaphragm);
  };
}

// Two floors on a line, for an element between them.
template <class Make>
std::function<void()> between_nodes(Make make) {
  return [make] {
    Model model;
    const NodeId lower = add(model, Node{.name = "lower", .mass = 1 * kg}),
                 upper = add(model, Node{.name = "upper", .mass = 1 * kg});
    add(model, make(lower, upper));
  };
}
// Two floors in plan.
template <class Make>
std::function<void()> between_floors(Make make) {
  return [make] {
    Model model;
    const PlanSize size{10 * m, 10 * m};
    const DiaphragmId lower = add(model, Diaphragm{.name = "lower", .mass = 1 * kg, .size = size}),
                      upper = add(model, Diaphragm{.name = "upper", .mass = 1 * kg, .size = size});
    add(model, make(lower, upper));
  };
}

std::function<void()> generalised(const Eigen::MatrixXd& mass) {
  return [mass] {
    Model model;
    add(model, GeneralisedBody{.name = "modes", .coordinates = {GeneralisedCoordinate{"1"}}, .mass = mass});
  };
}
std::function<void()> matrices(const Eigen::MatrixXd& stiffness) {
  return between_nodes([stiffness](NodeId lower, NodeId upper) {
    return LinearStructure{.name = "frame", .nodes = {lower, upper}, .stiffness = stiffness};
  });
}

const Eigen::MatrixXd lopsided = (Eigen::MatrixXd{2, 2} << 2, -1, 0, 1).finished();

Constructions bodies() {
  return {
      {"a body without mass",
       node({.name = "body", .mass = 0 * kg}),
       {"Node \"body\"", "mass", "0 kg", "> 0 kg and finite", "Every degree of freedom needs mass"}},
      {"a body with a name that is taken",
       node({.name = "base", .mass = 1 * kg}),
       {"Node \"base\"", "a node or diaphragm", "of this name", "exists", "Give every one its own name"}},
      {"a body without name",
       node({.name = "", .mass = 1 * kg}),
       {"Node", "has no name", "Give", ".name", "results are listed under it"}},
      {"a body called as the ground",
       node({.name = "ground", .mass = 1 * kg}),
       {"Node \"ground\"", "name", "is taken", "`ground` is always there", "choose another name"}},
      {"a body called as a formula",
       node({.name = "=1+1", .mass = 1 * kg}),
       {"Node \"=1+1\"", "name", "begins with = + - or @", "let the name begin", "a letter or a digit"}},
      {"a body in another encoding",
       node({.name = "T\xFCr", .mass = 1 * kg}),
       {"Node", "T\xFCr", "the name is not UTF-8", "Save the script", "in UTF-8"}},
      {"a body that begins nowhere",
       node({.name = "body", .mass = 1 * kg, .initial_displacement = not_a_number * m}),
       {"Node \"body\"", "initial_displacement", "nan m", "a finite number", "division by zero"}},
      {"a body that begins at once",
       node({.name = "body", .mass = 1 * kg, .initial_velocity = infinite * m / s}),
       {"Node \"body\"", "initial_velocity", "inf m/s", "a finite number", "division by zero"}},
      {"a floor of no width",
       node({.name = "body", .mass = 1 * kg, .half_width = 0 * m}),
       {"Node \"body\"", "half_width", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a floor that turns without inertia",
       diaphragm({.name = "floor", .mass = 1 * kg}),
       {"Diaphragm \"floor\"", "rotary_inertia", "0 kg m^2", "> 0 kg m^2 and finite",
        "Give .rotary_inertia, or .size or .outline of a uniform"}},
      {"a floor with two inertias",
       diaphragm({.name = "floor", .mass = 1 * kg, .rotary_inertia = 1 * kg * m_2, .size = {1 * m, 1 * m}}),
       {"Diaphragm \"floor\"", "rotary_inertia", "1 kg m^2",
        "at most mass times the squared distance of the farthest corner from",
        "Take it about the centre of mass: mass * (Lx^2 + Ly^2)/12"}},
      {"a floor of one side",
       diaphragm({.name = "floor", .mass = 1 * kg, .size = PlanSize{1 * m, 0 * m}}),
       {"Diaphragm \"floor\"", "size.y", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a floor that is turned infinitely",
       diaphragm({.name = "floor", .mass = 1 * kg, .size = {1 * m, 1 * m}, .initial_rotation = infinite * deg}),
       {"Diaphragm \"floor\"", "initial_rotation", "inf rad", "a finite number", "division by zero"}},
      {"a floor counted clockwise",
       diaphragm({.name = "floor",
                  .mass = 1 * kg,
                  .outline = PlanOutline{{{0 * m, 0 * m}, {0 * m, 1 * m}, {1 * m, 1 * m}, {1 * m, 0 * m}}}}),
       {"Diaphragm \"floor\"", "outline", "is clockwise", "counter-clockwise", "in reverse order"}},
      {"a floor that crosses itself",
       diaphragm({.name = "floor",
                  .mass = 1 * kg,
                  .outline = PlanOutline{{{0 * m, 0 * m}, {1 * m, 1 * m}, {1 * m, 0 * m}, {0 * m, 2 * m}}}}),
       {"Diaphragm \"floor\"", "outline", "corner 1 and from corner 3", "Give the corners", "in their order"}},
      {"a floor of two corners",
       diaphragm({.name = "floor", .mass = 1 * kg, .outline = PlanOutline{{{0 * m, 0 * m}, {1 * m, 1 * m}}}}),
       {"Diaphragm \"floor\"", "outline", "2 corners", "Give", "at least three"}},
      {"modes without mass",
       generalised(Eigen::MatrixXd::Zero(1, 1)),
       {"GeneralisedBody \"modes\"", "mass matrix", "is not symmetric and positive definite",
        "one row for each of the coordinates", "Every coordinate needs mass"}},
  };
}

Constructions links() {
  return {
      {"a storey without stiffness",
       between_nodes([](NodeId lower, NodeId upper) {
         return ShearSpring{.name = "storey", .lower = lower, .upper = upper, .stiffness = -2 * N / m};
       }),
       {"ShearSpring \"storey\"", "stiffness", "-2 N/m", "> 0 N/m and finite", "Check its sign and its unit"}},
      {"a storey between a floor and itself",
       between_nodes([](NodeId lower, NodeId) {
         return Storey<Linear>{.name = "storey", .lower = lower, .upper = lower, .law = {.stiffness = 1 * N / m}};
       }),
       {"Storey \"storey\"", "lower and upper", "\"lower\"", "An element joins", "two different nodes"}},
      {"a spring without end",
       between_nodes([](NodeId lower, NodeId) {
         return Spring<Linear>{.name = "spring", .lower = lower, .upper = NodeId{}, .law = {.stiffness = 1 * N / m}};
       }),
       {"Spring \"spring\"", "upper", "is not given", "Set it to", "a node of this model"}},
      {"a spring to another model",
       between_nodes([](NodeId lower, NodeId) {
         return Spring<Linear>{.name = "spring", .lower = lower, .upper = NodeId{7}, .law = {.stiffness = 1 * N / m}};
       }),
       {"Spring \"spring\"", "upper", "is not a node", "of this model",
        "Use the NodeId that add(model, Node{...}) returned"}},
      {"a dashpot that does nothing",
       between_nodes([](NodeId lower, NodeId upper) {
         return ViscousDamper{.name = "dashpot", .lower = lower, .upper = upper, .damping = 0 * N * s / m};
       }),
       {"ViscousDamper \"dashpot\"", "damping", "0 N s/m", "> 0 N s/m and finite", "Check its sign and its unit"}},
      {"a spring in plan without direction",
       between_floors([](DiaphragmId lower, DiaphragmId upper) {
         return PlanSpring<Linear>{.name = "brace",
                                   .lower = PlanPoint{lower, {}},
                                   .upper = PlanPoint{upper, {}},
                                   .direction = {0.0, 0.0},
                                   .law = {.stiffness = 1 * N / m}};
       }),
       {"PlanSpring \"brace\"", "direction", "0", "a vector of finite length > 0",
        "Give the direction along which the element acts, for"}},
      {"a spring in plan on one floor",
       between_floors([](DiaphragmId lower, DiaphragmId) {
         return PlanarSpring<BiaxialLinear>{.name = "column",
                                            .lower = PlanPoint{lower, {}},
                                            .upper = PlanPoint{lower, {1 * m, 0 * m}},
                                            .law = {.stiffness = 1 * N / m}};
       }),
       {"PlanarSpring \"column\"", "lower and upper", "the same body", "An element joins points", "two bodies"}},
      {"a column in plan that ends at the floor above",
       between_floors([](DiaphragmId lower, DiaphragmId upper) {
         return PlanarSpring<BiaxialLinear>{.name = "column",
                                            .lower = PlanPoint{ground, {}},
                                            .upper = PlanPoint{lower, {}, upper, 1.0},
                                            .law = {.stiffness = 1 * N / m}};
       }),
       {"PlanarSpring \"column\"", "upper.share", "1", ">= 0 and < 1",
        "It is the way from .of to .other; take the other body"}},
      {"a spring in plan on a floor of a line",
       between_nodes([](NodeId lower, NodeId upper) {
         return PlanarSpring<BiaxialLinear>{.name = "column",
                                            .lower = PlanPoint{lower, {}},
                                            .upper = PlanPoint{upper, {}},
                                            .law = {.stiffness = 1 * N / m}};
       }),
       {"PlanarSpring \"column\"", "lower.of", "\"lower\"", "moves on a line", "Give a diaphragm"}},
      {"a spring against rotation that drives",
       between_floors([](DiaphragmId lower, DiaphragmId upper) {
         return RotationSpring{.name = "twist", .lower = lower, .upper = upper, .stiffness = -1 * J};
       }),
       {"RotationSpring \"twist\"", "stiffness", "-1 N m/rad", "> 0 N m/rad and finite",
        "Check its sign and its unit"}},
      {"a dashpot against the rotation of the ground alone",
       between_floors([](DiaphragmId, DiaphragmId) {
         return RotationDamper{.name = "twist", .lower = ground, .upper = ground, .damping = 1 * J * s};
       }),
       {"RotationDamper \"twist\"", "lower and upper", "the same body", "An element joins points", "two bodies"}},
      {"a matrix that is not symmetric",
       matrices(lopsided),
       {"LinearStructure \"frame\"", "stiffness", "is not a symmetric matrix", "a diagonal >= 0 and one row per node",
        "Give as many rows as nodes"}},
      {"an element with a name that is taken",
       [] {
         Model model;
         const NodeId body = add(model, Node{.name = "body", .mass = 1 * kg});
         for (int i = 0; i < 2; ++i)
           add(model, ShearSpring{.name = "storey", .lower = ground, .upper = body, .stiffness = 1 * N / m});
       },
       {"ShearSpring", "storey", "an element of this name exists", "Give every element", "its own name"}},
  };
}

}  // namespace

Constructions elements() {
  Constructions all = bodies();
  const Constructions more = links();
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace moat::constructions
