// How peaks move when contacts change, as text.

#include "output/files/sensitivity_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace moat {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The first tour with other contacts; numbers rounded.
ContactSensitivity first_tour() {
  return {.computed = true,
          .rigid_walls = true,
          .impacts = 7,
          .changes = {{.parameter = "stiffness", .factor = 1.0 / 3.0, .impacts = 8},
                      {.parameter = "stiffness", .factor = 3.0, .impacts = 6},
                      {.parameter = "restitution", .difference = -0.1, .restitutions = {0.55}, .impacts = 7},
                      {.parameter = "restitution", .difference = 0.1, .restitutions = {0.75}, .impacts = 7},
                      {.parameter = "clearance", .factor = 0.9, .impacts = 7},
                      {.parameter = "clearance", .factor = 1.1, .impacts = 7}},
          .peaks = {{"displacement",
                     "base",
                     "m",
                     -0.160711,
                     1e-7,
                     {-0.214027, -0.134687, -0.159473, -0.162301, -0.149425, -0.171444}},
                    {"displacement", "floor 1", "m", 0.1, 1e-7, {0.2, 0.2, 0.2, 0.2, 0.2, 0.2}},
                    {"velocity", "base", "m/s", 1.0, 1e-7, {2.0, 2.0, 2.0, 2.0, 2.0, 2.0}},
                    {"absolute_acceleration",
                     "base",
                     "m/s^2",
                     54.0338,
                     1e-4,
                     {-32.0851, 88.3753, 54.5024, 53.5829, 50.0622, 57.2763}},
                    {"impact_force",
                     "moat",
                     "N",
                     45.3087e6,
                     100.0,
                     {38.0816e6, 59.8790e6, 44.3822e6, 46.6242e6, 43.7410e6, 46.2196e6}}}};
}

TEST(SensitivityTable, HasALineForTheLargestPeakOfEveryQuantity) {
  EXPECT_EQ(sensitivity_table(first_tour(), 1.0),
            "\n"
            "  if contact differs      k/3     3k   e-.1   e+.1  gap-10%  gap+10%\n"
            "    displacement, base  +33 %  -16 %   -1 %   +1 %     -7 %     +7 %\n"
            "    acceleration, base  -41 %  +64 %   +1 %   -1 %     -7 %     +6 %\n"
            "    impact force, moat  -16 %  +32 %   -2 %   +3 %     -3 %     +2 %\n"
            "    impacts 7               8      6      7      7        7        7\n"
            "    Rigid walls: a wall that gives way changes this more than k.\n");
}

TEST(SensitivityTable, HidesChangesBelowHalfAPercentAndBelowTheError) {
  ContactSensitivity sensitivity = first_tour();
  sensitivity.changes.resize(2);
  sensitivity.peaks = {{"displacement", "base", "m", 1.0, 1e-5, {1.0049, 0.9949}},
                       {"drift", "storey 1", "m", 1.0, 0.04, {1.11, 0.87}},
                       {"storey_shear", "storey 1", "N", 1.0, unknown, {1.11, 0.0}}};
  const std::string text = sensitivity_table(sensitivity, 1.0);
  EXPECT_NE(text.find("displacement, base          0   -1 %"), std::string::npos) << text;
  EXPECT_NE(text.find("drift, storey 1             0  -13 %"), std::string::npos)
      << "11 % are below three times the error, 13 % are not\n"
      << text;
  EXPECT_NE(text.find("storey shear, storey 1  +11 %   none"), std::string::npos) << text;
}

TEST(SensitivityTable, GivesNoPercentageOfZero) {
  ContactSensitivity sensitivity = first_tour();
  sensitivity.impacts = 1;
  sensitivity.changes = {
      {.parameter = "clearance", .factor = 0.9, .impacts = 2, .contact = {{"moat", "more"}, {"step", "appears"}}},
      {.parameter = "clearance", .factor = 1.1, .impacts = 0, .contact = {{"moat", "vanishes"}}}};
  sensitivity.peaks = {{"displacement", "base", "m", 0.1423, 1e-7, {0.14, -0.1498}},
                       {"impact_force", "moat", "N", 1.148e6, 1.0, {2e6, 0.0}},
                       {"impact_force", "step", "N", 0.0, 0.0, {1e6, 0.0}}};
  std::string text = sensitivity_table(sensitivity, 1.0);
  EXPECT_NE(text.find("    impact force, moat    +74 %     none\n"), std::string::npos) << text;
  EXPECT_NE(text.find("    impacts 1                 2        0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("    gap-10%: contact appears at step; impact force none -> 1000 kN; displacement, base 14.23 cm "
                      "-> 14.00 cm.\n"),
            std::string::npos)
      << text;
  EXPECT_NE(
      text.find("    gap+10%: contact vanishes at moat; impact force 1148 kN -> none; displacement, base 14.23 cm "
                "-> -14.98 cm.\n"),
      std::string::npos)
      << text;
  sensitivity.peaks[1].value = 0.0;
  text = sensitivity_table(sensitivity, 1.0);
  EXPECT_NE(text.find("    impact force, moat  appears        0\n"), std::string::npos) << text;
}

TEST(SensitivityTable, SaysWhatTheNumbersDoNot) {
  ContactSensitivity sensitivity = first_tour();
  sensitivity.unsettled = true;
  sensitivity.rigid_walls = false;
  sensitivity.unchanged_laws = {"Mine"};
  sensitivity.changes[0].failure = "a step did not converge.";
  for (ChangedPeak& peak : sensitivity.peaks) peak.changed[0] = unknown;
  sensitivity.changes[2].restitutions = {1e-3, 0.55};
  sensitivity.changes[3].restitutions = {0.75, 1.0};
  EXPECT_EQ(sensitivity_notes(sensitivity),
            (std::vector<std::string>{
                "The case itself is not settled numerically: small changes among these may have no meaning.",
                "k/3: no results, a step did not converge.", "e-.1: a restitution reached 0.001, its smallest value.",
                "e+.1: a restitution reached 1, its largest value.",
                "The law Mine has no parameter that moat can change: it has no fields stiffness and restitution."}));
  EXPECT_NE(sensitivity_table(sensitivity, 1.0).find("displacement, base      -  -16 %"), std::string::npos)
      << sensitivity_table(sensitivity, 1.0);
}

TEST(SensitivityTable, IsOneLineWhereThereAreNoRuns) {
  EXPECT_EQ(sensitivity_table({}, 1.0), "") << "a model without contacts";
  EXPECT_EQ(sensitivity_table({.reason = "It was not wanted."}, 1.0), "");
  EXPECT_EQ(sensitivity_table({.runs_left_out = 6}, 2.0),
            "\nSensitivity to contact parameters: not computed, at most 12 s; --sensitivity\n");
  EXPECT_EQ(sensitivity_table({.runs_left_out = 6}, 0.0),
            "\nSensitivity to contact parameters: not computed; --sensitivity\n");
  EXPECT_EQ(sensitivity_table({.computed = true, .reason = "No contact.", .rigid_walls = true}, 1.0),
            "\n  if contact differs\n    No contact.\n");
}

TEST(LabelOfAVariation, NamesTheChange) {
  EXPECT_EQ(label_of({.parameter = "stiffness", .factor = 1.0 / 3.0}), "k/3");
  EXPECT_EQ(label_of({.parameter = "stiffness", .factor = 3.0}), "3k");
  EXPECT_EQ(label_of({.parameter = "restitution", .difference = -0.1}), "e-.1");
  EXPECT_EQ(label_of({.parameter = "restitution", .difference = 0.1}), "e+.1");
  EXPECT_EQ(label_of({.parameter = "clearance", .factor = 0.9}), "gap-10%");
  EXPECT_EQ(label_of({.parameter = "clearance", .factor = 1.1}), "gap+10%");
  EXPECT_EQ(label_of({.parameter = "soil", .factor = 1.0 / 1.6}), "soil/1.6");
  EXPECT_EQ(label_of({.parameter = "soil", .factor = 1.6}), "1.6soil");
}

}  // namespace
}  // namespace moat
