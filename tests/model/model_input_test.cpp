// The input that a model accepts, and its messages for wrong input.

#include <gtest/gtest.h>

#include <limits>

#include "elements/line/shear_spring.hpp"
#include "message_of.hpp"
#include "model/analysis_state.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

TEST(ModelInput, NodesAreFoundUnderTheirIdAndName) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
  const NodeId floor = add(model, Node{.name = "floor 1", .mass = 500 * tonne, .height = 3.5 * m});
  EXPECT_NE(base, floor);
  EXPECT_EQ(model.degrees_of_freedom(), 2);
  EXPECT_EQ(model.body(floor).height, 3.5);
  EXPECT_EQ(model.node_name(base), "base");
  EXPECT_EQ(model.node_name(ground), "ground");
}

TEST(ModelInput, RefusesANodeWithoutOrWithATakenName) {
  Model model;
  add(model, Node{.name = "base", .mass = 1 * kg});
  EXPECT_EQ(message_of([&] { add(model, Node{.name = "base", .mass = 1 * kg}); }),
            "Node \"base\": a node or diaphragm of this name exists. Give every one its own name.");
  EXPECT_EQ(message_of([&] { add(model, Node{.name = "", .mass = 1 * kg}); }),
            "Node: a node has no name. Give .name: results are listed under it.");
  EXPECT_EQ(message_of([&] { add(model, Node{.name = "ground", .mass = 1 * kg}); }),
            "Node \"ground\": this name is taken. `ground` is always there; choose another name.");
  EXPECT_EQ(message_of([&] { add(model, Node{.name = "T\xFCr", .mass = 1 * kg}); }),
            "Node \"T\xFCr\": the name is not UTF-8. Save the script in UTF-8.");
  for (const std::string name : {"=1+1", "+1", "-1", "@SUM(1)"})
    EXPECT_EQ(message_of([&] { add(model, Node{.name = name, .mass = 1 * kg}); }),
              "Node \"" + name + "\": the name begins with = + - or @. Spreadsheets take that for a formula; let the " +
                  "name begin with a letter or a digit.");
  EXPECT_EQ(model.degrees_of_freedom(), 1);
  add(model, Node{.name = "T\xC3\xBCr", .mass = 1 * kg});
}

TEST(ModelInput, RefusesAMassThatIsNotPositive) {
  Model model;
  const auto refusal = [&](Mass mass) { return message_of([&] { add(model, Node{.name = "base", .mass = mass}); }); };
  for (const auto& [mass, text] : {std::pair{0.0, "0"},
                                   {-2000.0, "-2000"},
                                   {std::nan(""), "nan"},
                                   {std::numeric_limits<double>::infinity(), "inf"}})
    EXPECT_EQ(refusal(mass * kg), "Node \"base\": mass = " + std::string{text} +
                                      " kg is not allowed; it must be > 0 kg and finite. Every degree of freedom needs "
                                      "mass.");
  // A node that was refused does not occupy its name.
  EXPECT_NO_THROW(add(model, Node{.name = "base", .mass = 1 * kg}));
}

TEST(ModelInput, RefusesInitialValuesThatAreNotNumbers) {
  Model model;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] { add(model, Node{.name = "a", .mass = 1 * kg, .initial_displacement = nan * m}); }),
            "Node \"a\": initial_displacement = nan m is not allowed; it must be a finite number. Look for a division "
            "by zero in the calculation that gave it.");
  EXPECT_EQ(message_of([&] { add(model, Node{.name = "a", .mass = 1 * kg, .initial_velocity = nan * m / s}); }),
            "Node \"a\": initial_velocity = nan m/s is not allowed; it must be a finite number. Look for a division by "
            "zero in the calculation that gave it.");
  EXPECT_EQ(message_of([&] { add(model, Node{.name = "a", .mass = 1 * kg, .half_width = 0 * m}); }),
            "Node \"a\": half_width = 0 m is not allowed; it must be > 0 m and finite. Check its sign and its unit.");
}

TEST(ModelInput, RefusesNodesItDoesNotHave) {
  Model model, other;
  const NodeId here = add(model, Node{.name = "here", .mass = 1 * kg});
  add(other, Node{.name = "a", .mass = 1 * kg});
  const NodeId elsewhere = add(other, Node{.name = "b", .mass = 1 * kg});
  const auto spring_to = [&](NodeId upper) {
    return message_of(
        [&] { add(model, ShearSpring{.name = "storey 1", .lower = here, .upper = upper, .stiffness = 1 * N / m}); });
  };
  EXPECT_EQ(spring_to(elsewhere),
            "ShearSpring \"storey 1\": upper is not a node of this model. "
            "Use the NodeId that add(model, Node{...}) returned.");
  EXPECT_EQ(spring_to(NodeId{}),
            "ShearSpring \"storey 1\": upper is not given. Set it to a node of this model or to `ground`.");
  EXPECT_EQ(spring_to(NodeId{-7}),
            "ShearSpring \"storey 1\": upper is not a node of this model. "
            "Use the NodeId that add(model, Node{...}) returned.");
  EXPECT_EQ(spring_to(here),
            "ShearSpring \"storey 1\": lower and upper are the same node, \"here\". "
            "An element joins two different nodes.");
  EXPECT_EQ(spring_to(ground), "nothing was thrown");
  EXPECT_EQ(message_of([&] { static_cast<void>(model.body(ground)); }),
            "Model: the ground has no mass and no degree of freedom.");
  EXPECT_THROW(static_cast<void>(model.body(elsewhere)), InputError);
  EXPECT_THROW(static_cast<void>(model.node_name(NodeId{})), InputError);
}

TEST(ModelInput, RefusesAnElementWithoutOrWithATakenName) {
  Model model;
  const NodeId node = add(model, Node{.name = "base", .mass = 1 * kg});
  const auto add_spring = [&](const std::string& name) {
    return message_of(
        [&] { add(model, ShearSpring{.name = name, .lower = ground, .upper = node, .stiffness = 1 * N / m}); });
  };
  EXPECT_EQ(add_spring(""), "ShearSpring: an element has no name. Give .name: results are listed under it.");
  // An element may have the name of a node: they are never mixed up.
  EXPECT_EQ(add_spring("base"), "nothing was thrown");
  EXPECT_EQ(add_spring("base"),
            "ShearSpring \"base\": an element of this name exists. Give every element its own name.");
}

TEST(ModelInput, RefusesAModelWithoutNodes) {
  Model model;
  EXPECT_EQ(message_of([&] { const AnalysisState state{model}; }),
            "Model: there is no node. Add nodes with add(model, Node{...}) first.");
}

}  // namespace
}  // namespace moat
