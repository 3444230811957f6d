// Copies of a model with other contacts.

#include "model/with_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "message_of.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

const HertzDamp law{.stiffness = 3e9 * N / m_3_2, .restitution = 0.65};

struct Found {
  const ElementInfo* info;
  LawAsGiven law;

  double operator[](std::string_view parameter) const {
    for (const Parameter& each : law.parameters)
      if (each.name == parameter) return each.value;
    ADD_FAILURE() << info->name << " has no " << parameter;
    return std::nan("");
  }
};

Found element(const Model& model, const std::string& name) {
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e)
      if (block->info(e).name == name) return {&block->info(e), block->law(e)};
  throw InputError{"there is no " + name};
}

// Returns the force of a contact that is closed by so many m, N.
double force_of_gap(const Model& model, double indentation) {
  const auto& gaps = dynamic_cast<const LinkBlock<AnyContact>&>(*model.blocks().back());
  ContactState after;
  return gaps.laws()[0].evaluate({ContactPhase::loaded, 0.3}, indentation, 0.2, after).force;
}

Model moat_model() {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
  add(model, Moat{.around = base, .clearance = 10 * cm, .law = law});
  return model;
}

TEST(WithContacts, GivesAllGapsTheChangedLawAndClearance) {
  const Model model = moat_model();
  const Model changed =
      with_contacts(model, {.stiffness_factor = 3.0, .restitution_change = -0.1, .clearance_factor = 0.9});
  for (const char* gap : {"moat left", "moat right"}) {
    EXPECT_EQ(element(changed, gap)["stiffness"], 9e9);
    EXPECT_NEAR(element(changed, gap)["restitution"], 0.55, 1e-15);
    EXPECT_NEAR(element(changed, gap).info->offset, 0.09, 1e-15);
    EXPECT_EQ(element(model, gap)["stiffness"], 3e9) << "the model itself does not change";
    EXPECT_EQ(element(model, gap).info->offset, 0.1);
  }
  Model by_hand;
  const NodeId base = add(by_hand, Node{.name = "base", .mass = 550 * tonne});
  add(by_hand,
      Moat{.around = base, .clearance = 9 * cm, .law = HertzDamp{.stiffness = 9e9 * N / m_3_2, .restitution = 0.55}});
  EXPECT_DOUBLE_EQ(force_of_gap(changed, 0.01), force_of_gap(by_hand, 0.01));
}

TEST(WithContacts, WithoutAChangeHasTheSameBits) {
  const Model model = moat_model(), same = with_contacts(model, {});
  EXPECT_EQ(element(same, "moat left").law.parameters, element(model, "moat left").law.parameters);
  EXPECT_EQ(element(same, "moat left").info->offset, element(model, "moat left").info->offset);
  EXPECT_EQ(force_of_gap(same, 0.01), force_of_gap(model, 0.01));
}

TEST(WithContacts, CanChangeAChangedModelAgain) {
  const Model twice = with_contacts(with_contacts(moat_model(), {.stiffness_factor = 3.0, .clearance_factor = 2.0}),
                                    {.stiffness_factor = 2.0, .restitution_change = 0.1});
  EXPECT_EQ(element(twice, "moat left")["stiffness"], 18e9);
  EXPECT_NEAR(element(twice, "moat left")["restitution"], 0.75, 1e-15);
  EXPECT_EQ(element(twice, "moat left").info->offset, 0.2);
}

TEST(WithContacts, KeepsTheEffectiveMassThatALawNeeds) {
  Model model;
  const NodeId a = add(model, Node{.name = "a", .mass = 300 * tonne}),
               b = add(model, Node{.name = "b", .mass = 150 * tonne});
  add(model, Gap<Kelvin>{.name = "gap",
                         .left = a,
                         .right = b,
                         .clearance = 1 * cm,
                         .law = {.stiffness = 1e9 * N / m, .restitution = 0.5}});
  const Model changed = with_contacts(model, {.stiffness_factor = 4.0});
  // c = 2 xi sqrt(k m) with m = 100 t: twice that of k.
  const auto damping = [](const Model& of) {
    const auto& gaps = dynamic_cast<const LinkBlock<AnyContact>&>(*of.blocks().back());
    return std::get<ViscousLinearContact>(gaps.laws()[0].form()).damping;
  };
  const double xi = std::log(2.0) / std::hypot(pi, std::log(2.0));
  EXPECT_NEAR(damping(model).shown(), 2.0 * xi * std::sqrt(1e9 * 1e5), 1e-6);
  EXPECT_NEAR(damping(changed).shown(), 4.0 * xi * std::sqrt(1e9 * 1e5), 1e-6);
}

TEST(WithContacts, KeepsTheClearanceOfAGapThatIsClosedAtTheStart) {
  Model model;
  const NodeId pressed = add(model, Node{.name = "pressed", .mass = 1 * tonne, .initial_displacement = 2 * cm}),
               open = add(model, Node{.name = "open", .mass = 1 * tonne});
  add(model, Gap<HertzDamp>{.name = "pressed gap", .left = pressed, .right = ground, .clearance = 1 * cm, .law = law});
  add(model, Gap<HertzDamp>{.name = "open gap", .left = open, .right = ground, .clearance = 1 * cm, .law = law});
  const Model changed = with_contacts(model, {.stiffness_factor = 2.0, .clearance_factor = 1.5});
  EXPECT_EQ(element(changed, "pressed gap").info->offset, 0.01);
  EXPECT_EQ(element(changed, "open gap").info->offset, 0.015);
  EXPECT_EQ(element(changed, "pressed gap")["stiffness"], 6e9);
}

TEST(WithContacts, ReachesGapsAtColumnsOfNeighbours) {
  Model model;
  const NodeId ram = add(model, Node{.name = "ram", .mass = 2 * tonne, .height = 4 * m}),
               lower = add(model, Node{.name = "lower", .mass = 5 * tonne, .height = 3 * m}),
               upper = add(model, Node{.name = "upper", .mass = 5 * tonne, .height = 6 * m});
  add(model,
      Gap<HertzDamp>{
          .name = "gap", .left = ram, .right = MemberPoint{lower, upper, 1.0 / 3.0}, .clearance = 2 * cm, .law = law});
  const Model changed = with_contacts(model, {.stiffness_factor = 0.5, .clearance_factor = 1.1});
  EXPECT_EQ(element(changed, "gap")["stiffness"], 1.5e9);
  EXPECT_NEAR(element(changed, "gap").info->offset, 0.022, 1e-16);
  ASSERT_NE(element(changed, "gap").info->member_ends(), nullptr);
  EXPECT_EQ(*element(changed, "gap").info->member_ends(), *element(model, "gap").info->member_ends());
}

// A slab whose corner at (2, 1) faces the edge x = 3, from y = -2 to 5.
Model corner_model(CornerFriction friction) {
  Model model;
  const DiaphragmId slab =
      add(model, Diaphragm{.name = "slab", .mass = 8 * tonne, .rotary_inertia = 20e3 * kg * m * m});
  add(model, CornerGap<HertzDamp>{.name = "corner",
                                  .corner = PlanPoint{slab, {2 * m, 1 * m}},
                                  .edge_of = ground,
                                  .edge_begin = PlanPosition{3 * m, -2 * m},
                                  .edge_end = PlanPosition{3 * m, 5 * m},
                                  .law = law,
                                  .friction = friction,
                                  .share = 0.25});
  return model;
}

TEST(WithContacts, MovesTheEdgeOfACornerAlongItsNormal) {
  const Model changed = with_contacts(corner_model(0.4), {.clearance_factor = 1.1});
  const Found corner = element(changed, "corner");
  EXPECT_NEAR(corner.info->offset, 1.1, 1e-15);
  const CornerPair& pair = *corner.info->corner_pair();
  EXPECT_NEAR(pair.edge_begin.x, 3.1, 1e-15);
  EXPECT_NEAR(pair.edge_end.x, 3.1, 1e-15);
  EXPECT_EQ(pair.edge_begin.y, -2.0);
  EXPECT_NEAR(pair.distance_at_rest, 1.1, 1e-15);
  EXPECT_NEAR(-AnalysisState{changed}.elements(0).results()[0].deformation, 1.1, 1e-15);
}

TEST(WithContacts, GivesTheFrictionOfACornerTheStiffnessOfItsLaw) {
  const Found nominal = element(corner_model(0.4), "corner"),
              stiffer = element(with_contacts(corner_model(0.4), {.stiffness_factor = 3.0}), "corner");
  // 0.85 times the tangent of a quarter of k d^1.5 at 10 mm.
  EXPECT_NEAR(nominal["tangential_stiffness"], 0.85 * 0.25 * 1.5 * 3e9 * std::sqrt(0.01), 1.0);
  EXPECT_NEAR(stiffer["tangential_stiffness"], 3.0 * nominal["tangential_stiffness"], 1e-6);
  EXPECT_EQ(stiffer["stiffness"], 9e9);
  EXPECT_EQ(stiffer["share"], 0.25);
  const Model given = with_contacts(corner_model({0.4, 1e8 * N / m}), {.stiffness_factor = 3.0});
  EXPECT_EQ(element(given, "corner")["tangential_stiffness"], 1e8) << "the stiffness that was given stays";
}

TEST(WithContacts, ChangesTheSoilBehindWalls) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 550 * tonne});
  const HyperbolicBackfill soil{.initial_stiffness = 480 * MN / m, .ultimate_force = 9 * MN};
  add(model, Moat{.around = base,
                  .clearance = 10 * cm,
                  .law = law,
                  .wall = FlexibleWall{.mass = 12 * tonne, .stiffness = 1 * GN / m, .backfill = soil}});
  const Model changed = with_contacts(model, {.soil_factor = 0.5});
  for (const char* name : {"moat left wall backfill", "moat right wall backfill"}) {
    EXPECT_EQ(element(changed, name)["initial_stiffness"], 240e6);
    EXPECT_EQ(element(changed, name)["ultimate_force"], 4.5e6);
    EXPECT_EQ(element(changed, name)["failure_ratio"], 0.7);
  }
  EXPECT_EQ(element(changed, "moat left")["stiffness"], 3e9);
  EXPECT_TRUE(changeable_parameters(model).soil);
}

// Laws of a script.
struct CrushingLaw {
  double force = 1e6;

  void check(const Check& check) const { check.positive("force", force, "N"); }
  [[nodiscard]] ViscousHertzContact between(double) const { return {force / 1e-3, 0.0}; }
};
struct StrictLaw {
  static constexpr std::string_view name = "StrictLaw";
  Stiffness stiffness = 1e9 * N / m;
  double restitution = 0.5;

  void check(const Check& check) const { check.between("restitution", restitution, 0.45, 0.55, "1"); }
  [[nodiscard]] ViscousLinearContact between(double) const { return {stiffness.si()}; }
};

TEST(WithContacts, NamesLawsThatItCannotChange) {
  Model model = moat_model();
  EXPECT_TRUE(changeable_parameters(model).unchanged_laws.empty());
  const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne});
  add(model, Gap<CrushingLaw>{.name = "first", .left = body, .right = ground, .clearance = 1 * m, .law = {}});
  add(model, Gap<CrushingLaw>{.name = "second", .left = ground, .right = body, .clearance = 1 * m, .law = {}});
  const std::vector<std::string> names = changeable_parameters(model).unchanged_laws;
  ASSERT_EQ(names.size(), 1u);
  EXPECT_NE(names.front().find("CrushingLaw"), std::string::npos) << names.front();
  const Model changed = with_contacts(model, {.stiffness_factor = 3.0, .clearance_factor = 1.5});
  EXPECT_EQ(element(changed, "moat left")["stiffness"], 9e9);
  EXPECT_EQ(element(changed, "first").info->offset, 1.5) << "its clearance can be changed";
}

TEST(WithContacts, RefusesWhatChangesNothing) {
  const Model hard = [] {
    Model model;
    const NodeId body = add(model, Node{.name = "body", .mass = 1 * tonne});
    add(model, Gap<Hertz>{.name = "wall to wall",
                          .left = body,
                          .right = ground,
                          .clearance = 0 * m,
                          .law = {.stiffness = 1e9 * N / m_3_2}});
    return model;
  }();
  EXPECT_EQ(message_of([&] { (void)with_contacts(hard, {.restitution_change = 0.1}); }),
            "ContactChange: restitution_change = 0.1 is not allowed; it must be left out here. No law of a contact of "
            "the model has a restitution that can be changed.");
  EXPECT_NE(message_of([&] { (void)with_contacts(hard, {.clearance_factor = 1.1}); }).find("no gap with a clearance"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)with_contacts(hard, {.soil_factor = 2.0}); }).find("FlexibleWall::backfill"),
            std::string::npos);
  Model none;
  add(none, Node{.name = "body", .mass = 1 * tonne});
  EXPECT_NE(message_of([&] { (void)with_contacts(none, {.stiffness_factor = 3.0}); }).find("stiffness_factor = 3"),
            std::string::npos);
  EXPECT_NO_THROW((void)with_contacts(none, {}));
}

TEST(WithContacts, RefusesValuesOutsideTheirRange) {
  const Model model = moat_model();
  const auto refused = [&](const ContactChange& change) {
    return message_of([&] { (void)with_contacts(model, change); });
  };
  EXPECT_NE(refused({.stiffness_factor = 0.0}).find("stiffness_factor = 0"), std::string::npos);
  EXPECT_NE(refused({.restitution_change = 1.5}).find("restitution_change = 1.5"), std::string::npos);
  EXPECT_NE(refused({.clearance_factor = -1.0}).find("clearance_factor = -1"), std::string::npos);
  EXPECT_NE(refused({.soil_factor = 0.0}).find("soil_factor = 0"), std::string::npos);
  Model strict;
  const NodeId body = add(strict, Node{.name = "body", .mass = 1 * tonne});
  add(strict, Gap<StrictLaw>{.name = "wall", .left = body, .right = ground, .clearance = 1 * m, .law = {}});
  EXPECT_NE(message_of([&] {
              (void)with_contacts(strict, {.restitution_change = 0.1});
            }).find("Gap \"wall\": restitution = 0.6 is not allowed"),
            std::string::npos);
}

}  // namespace
}  // namespace moat
