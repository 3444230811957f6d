// Mistakes in a script, compiled as the launcher does, and the sentence that must come first.

#include "launcher/compile_errors.hpp"

#include <gtest/gtest.h>

#include "launcher/explanation.hpp"
#include "launcher/process.hpp"
#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

class CompileErrors : public moat::testing::InTemporaryFolder {
 protected:
  // The message to the user about a script with this text in main(), which begins at line 4.
  std::string explained_for(const std::string& text) const {
    const std::filesystem::path script = folder / "tower.cpp", log = folder / "log";
    write_text(script, "#include <moat.hpp>\nusing namespace moat;\nusing namespace moat::units;\n" + text + "\n");
    Command compile = lines_of(text_of(std::filesystem::path{BUILD_FOLDER} / "script_compile.txt"));
    compile.insert(compile.end(), {"-fsyntax-only", script});
    EXPECT_NE(run_into(log, compile), 0) << "compiles: " << text;
    const std::string sentence = explained(text_of(log), script, MOAT_SOURCE_DIR);
    return replaced(sentence, folder.string() + "/", "");
  }

  void expect_first(const std::string& text, const std::string& sentence) const {
    const std::string all = explained_for(text);
    EXPECT_TRUE(all.starts_with(sentence)) << text << "\ngives:\n" << all << "instead of:\n" << sentence;
  }
};

const std::string wall = "Model model;\nconst NodeId base = add(model, Node{.name = \"base\", .mass = 1 * kg});\n";

TEST_F(CompileErrors, NameTheDimensionThatIsNeeded) {
  expect_first("const Node node{.name = \"base\",\n.mass = 500 * kN};",
               "tower.cpp:5: 500 * kN is a force [N], but a mass [kg] is needed here\n");
  expect_first("const Length gap = 0.10;",
               "tower.cpp:4: 0.10 is a number without unit, but a length [m] is needed here; give it a unit");
  expect_first("const HertzDamp law{.stiffness = 2.95e9 * N / m, .restitution = 0.65};",
               "tower.cpp:4: 2.95e9 * N / m is a stiffness [N/m], but a Hertz stiffness [N/m^1.5] is needed here");
  expect_first("const Node node{.name = \"base\", .mass = {500 * tonne, 400 * tonne}};",
               "tower.cpp:4: this is a list in braces, but a mass [kg] is needed here");
}

TEST_F(CompileErrors, NameTheMissingField) {
  expect_first("const Node node{.name = \"base\"};", "tower.cpp:4: field mass of Node is missing");
  expect_first("int main() {" + wall + "add(model, Moat{.around = base, .law = Hertz{.stiffness = 1 * N / m_3_2}}); }",
               "tower.cpp:6: field clearance of Moat is missing");
  expect_first("int main() {" + wall + "add(model, Moat{.around = base, .clearance = 1 * m}); }",
               "tower.cpp:6: field law of Moat is missing");
  expect_first("const ShearBuilding building{.storeys = 5, .storey_stiffness = 1 * GN / m};",
               "tower.cpp:4: field floor_mass of ShearBuilding is missing");
}

TEST_F(CompileErrors, NameTheDimensionOfAMissingFieldWithoutName) {
  expect_first("const Viscous law{};", "tower.cpp:4: a required field is missing: a damping coefficient [N s/m]");
}

// Isolation takes any law, and the compiler does not say why one is none.
TEST_F(CompileErrors, NameTheFunctionThatALawOfTheScriptLacks) {
  const auto building_on = [](const std::string& functions) {
    return "struct Rubber {\nusing State = NoState;\n" + functions +
           "};\nconst ShearBuilding building{.storeys = 2, .floor_mass = 1 * kg, .storey_stiffness = 1 * GN / m, "
           ".base_mass = 1 * kg, .isolation = Rubber{}};";
  };
  const std::string evaluate =
      "Response evaluate(const State&, double, double, State&) const { return {.force = 0.0, .stiffness = 0.0}; }\n";
  const std::string all =
      explained_for(building_on(evaluate + "double stored_energy(const State&, double) const { return 0.0; }\n"
                                           "double linear_stiffness(StiffnessStage) const { return 0.0; }\n"));
  EXPECT_NE(all.find("the law lacks dissipation_rate (docs/guide.md"), std::string::npos) << all;
  // In an unnamed namespace, behind a struct whose name begins like that of the law.
  const std::string several = explained_for(
      "struct RubberTest {\nint State, evaluate, stored_energy;\n};\nnamespace {\n" + building_on(evaluate) + "\n}");
  EXPECT_NE(several.find("the law lacks stored_energy, dissipation_rate, linear_stiffness (docs/guide.md"),
            std::string::npos)
      << several;
}

TEST_F(CompileErrors, SayHowAScriptIsRun) {
  for (const char* arguments : {"model, near_fault_pulse(), {drift, other}", "model, near_fault_pulse(), drift",
                                "model, near_fault_pulse(), GeneralizedAlpha{}", "model, \"record.AT2\""}) {
    const std::string all = explained_for(
        "struct Drift final : StepObserver {\nvoid start(const StepView&) override {}\n"
        "void step(const StepView&) override {}\n};\nint main(int argc, char** argv) {\nScript script{argc, argv, "
        "\"a\"};\nModel model;\nDrift drift, other;\nreturn script.run(" +
        std::string{arguments} + ");\n}");
    EXPECT_TRUE(
        all.starts_with("tower.cpp:12: this call of Script::run does not fit: it takes the model, the motion (of "
                        "a file: read_motion(\"record.AT2\")), then options by their names, as in {.step = 1 * "
                        "ms}, and observers by their addresses, as in {&drift}\n"))
        << arguments << "\n"
        << all;
  }
}

TEST_F(CompileErrors, NameTheFunctionThatARecorderLacks) {
  const std::string all = explained_for(
      "struct Drift final : QuantityRecorder {\n"
      "std::vector<OfferedQuantity> quantities() const override { return {}; }\n};\nDrift drift;");
  EXPECT_TRUE(all.starts_with("tower.cpp:7: Drift lacks sample() of QuantityRecorder; ")) << all;
}

// The words of a law stand elsewhere in the script.
TEST_F(CompileErrors, SayNothingOfFunctionsOfALawThatIsNotOfTheScript) {
  const std::string all = explained_for(
      "struct Rubber {\nusing State = NoState;\ndouble stored_energy(const State&, double) const;\n};\n"
      "const HertzDamp law{.stiffness = 1 * N / m_3_2, .restitution = 0.65};\n"
      "const ShearBuilding building{.storeys = 2, .floor_mass = 1 * kg, .storey_stiffness = 1 * GN / m, "
      ".base_mass = 1 * kg, .isolation = law};");
  EXPECT_EQ(all.find("lacks"), std::string::npos) << all;
  EXPECT_NE(all.find("a bearing, such as LeadRubberBearing, is needed here"), std::string::npos) << all;
}

TEST_F(CompileErrors, AcceptANodeAtTheEndOfAGapInWords) {
  const std::string all = explained_for(
      "struct Tower {} tower;\nconst Gap<HertzDamp> gap{.left = tower, .right = tower, .clearance = 1 * m, "
      ".law = {.stiffness = 1 * N / m_3_2, .restitution = 0.65}};");
  EXPECT_NE(all.find("a node, or a MemberPoint between two, is needed here"), std::string::npos) << all;
}

TEST_F(CompileErrors, PointAtAFieldInTheWrongPlaceAndGiveTheOrder) {
  const std::string text = explained_for("const Node node{.mass = 1 * kg,\n.name = \"base\"};");
  EXPECT_TRUE(text.starts_with("tower.cpp:5: field name of Node stands in the wrong place; the order is name, mass"))
      << text;
  EXPECT_NE(text.find("   5 | .name = \"base\"};\n     | ^^^^^\n"), std::string::npos) << text;
}

TEST_F(CompileErrors, SuggestTheNearestField) {
  expect_first("const Node node{.name = \"base\",\n.masses = 1 * kg};",
               "tower.cpp:5: Node has no field masses; did you mean mass?");
  expect_first("const Node node{.colour_of_paint = 1 * kg};",
               "tower.cpp:4: Node has no field colour_of_paint; it has name");
}

TEST_F(CompileErrors, NameLawsThatAreMadeFromATemplate) {
  expect_first("const HertzDamp law{.stiffness = 1 * N / m_3_2};",
               "tower.cpp:4: field restitution of HertzDamp is missing");
  expect_first("const auto law = HertzDamp{.stifness = 1 * N / m_3_2, .restitution = 0.65};",
               "tower.cpp:4: HertzDamp has no field stifness; did you mean stiffness?");
  expect_first("const HuGuo law{.restitution = 0.65, .stiffness = 1 * N / m_3_2};",
               "tower.cpp:4: field stiffness of HuGuo stands in the wrong place; the order is stiffness, restitution, "
               "may_pull");
  expect_first("const HertzDamp law{.stiffness = 1 * N / m_3_2, .restitution = 0.65};\nconst Length gap = law;",
               "tower.cpp:5: law is a HertzDamp, but a length [m] is needed here");
}

TEST_F(CompileErrors, NameTheDimensionOfAConstant) {
  expect_first("const Stiffness k = 1 * N / m;\nconst HertzDamp law{.stiffness = k, .restitution = 0.65};",
               "tower.cpp:5: this is a stiffness [N/m], but a Hertz stiffness [N/m^1.5] is needed here");
}

TEST_F(CompileErrors, SayWhatIsNoImpactLaw) {
  expect_first(
      "int main() {" + wall + "add(model, Moat{.around = base, .clearance = 1 * m, .law = Viscous{1 * N * s / m}}); }",
      "tower.cpp:6: Moat needs an impact law, such as HertzDamp; Viscous is none");
}

TEST_F(CompileErrors, SayWhichFieldOfATemplateHasTheWrongType) {
  expect_first("int main() {" + wall +
                   "add(model, Moat{.around = 7,\n.clearance = 1 * m,\n.law = Hertz{.stiffness = 1 * N / m_3_2}}); }",
               "tower.cpp:6: this is a number without unit, but a NodeId is needed here");
  expect_first("int main() {" + wall +
                   "add(model, Moat{.around = base,\n.clearance = 0.10,\n.law = Hertz{.stiffness = 1 * N / m_3_2}}); }",
               "tower.cpp:7: 0.10 is a number without unit, but a length [m] is needed here; give it a unit");
}

TEST_F(CompileErrors, SuggestTheNearestFieldOfATemplate) {
  const std::string law = ", .law = Hertz{.stiffness = 1 * N / m_3_2}";
  const std::string text =
      explained_for("int main() {" + wall + "add(model, Moat{.around = base,\n.clearence = 10 * cm" + law + "\n}); }");
  EXPECT_TRUE(
      text.starts_with("tower.cpp:7: Moat has no field clearence; did you mean clearance?\n"
                       "   7 | .clearence = 10 * cm" +
                       law + "\n     | ^^^^^^^^^^\n"))
      << text;
  expect_first("int main() {" + wall + "const Moat moat{.around = base, .clearence = 10 * cm" + law + "}; }",
               "tower.cpp:6: Moat has no field clearence; did you mean clearance?");
  expect_first("auto make(NodeId base) {\nreturn Gap{.left = ground, .rihgt = base, .clearance = 1 * m" + law + "}; }",
               "tower.cpp:5: Gap has no field rihgt; did you mean right?");
  expect_first("int main() {" + wall + "add(model, Moat{.around = base, .colour_of_paint = 1 * m" + law + "}); }",
               "tower.cpp:6: Moat has no field colour_of_paint; it has name, around, clearance, law, sides, wall");
}

TEST_F(CompileErrors, NameTheTypeOfAValueThatIsLookedForInATemplate) {
  const std::string moat =
      "{.around = base, .clearance = 1 * m, .law = Hertz{.stiffness = 1 * N / m_3_2},\n"
      ".sides = Moat::right}";
  const std::string sentence = "tower.cpp:7: field sides of Moat is a Sides; write Sides::right, not Moat::right\n";
  expect_first("int main() {" + wall + "add(model, Moat" + moat + "); }", sentence);
  expect_first("int main() {" + wall + "const Moat west" + moat + "; }", sentence);
}

TEST_F(CompileErrors, NameTheUnitThatAnArgumentNeeds) {
  expect_first("void set(Length gap);\nvoid run() { set(0.10); }",
               "tower.cpp:5: 0.10 is a number without unit, but a length [m] is needed here; give it a unit");
  expect_first("void run(Script& script) { script.length(\"gap\", 0.10, \"clearance\"); }",
               "tower.cpp:4: 0.10 is a number without unit, but a length [m] is needed here; give it a unit");
  EXPECT_EQ(explained_for("void run(Length gap) { gap = 0.5; }").find("aka"), std::string::npos);
}

TEST_F(CompileErrors, NameTheFieldOfAnArgumentInBraces) {
  expect_first(
      "const GroundMotion pulse = near_fault_pulse({.pulse_period = 1.3});",
      "tower.cpp:4: field pulse_period of NearFaultPulse is a time [s], but 1.3 is a number without unit; give "
      "it a unit, as in 1.3 * s\n");
  expect_first("const GroundMotion pulse = near_fault_pulse({\n.pulse_period = 1.3 * s,\n.amplitude = 0.8});",
               "tower.cpp:6: field amplitude of NearFaultPulse is a speed [m/s], but 0.8 is a number without unit");
  expect_first(
      "void run(Model& model, const GroundMotion& motion) {\n"
      "run_case(model, motion, {.title = \"x\", .transient = {.step = 0.01}}); }",
      "tower.cpp:5: field step of TransientOptions is a time [s], but 0.01 is a number without unit; give it a "
      "unit, as in 0.01 * s\n");
  expect_first("const GroundMotion pulse = near_fault_pulse({.puls_period = 1.3 * s});",
               "tower.cpp:4: NearFaultPulse has no field puls_period; did you mean pulse_period?");
  expect_first(
      "const GroundMotion pulse = near_fault_pulse({.amplitude = 1 * m / s, .pulse_period = 1.3 * s});",
      "tower.cpp:4: field pulse_period of NearFaultPulse stands in the wrong place; the order is pulse_period, ");
  expect_first("const GroundMotion pulse = near_fault_pulse({.pulse_period = 1.3 * m, .phase = 0.5});",
               "tower.cpp:4: field pulse_period of NearFaultPulse is a time [s], but 1.3 * m is a length [m]\n");
  expect_first("const Length period = 1.3 * m;\nconst GroundMotion pulse = near_fault_pulse({.pulse_period = period});",
               "tower.cpp:5: a value does not fit its field of NearFaultPulse: pulse_period is a time [s]\n");
  expect_first(
      "void set(const NearFaultPulse&);\nvoid take(NearFaultPulse);\nvoid run() {\nset({.phase = 1 * s});\n"
      "take({.pulse_period = 2});\n}",
      "tower.cpp:7: field phase of NearFaultPulse is a number without unit, but 1 * s is a time [s]\n");
  expect_first("void take(NearFaultPulse);\nvoid run() { take({.pulse_period = 2}); }",
               "tower.cpp:5: field pulse_period of NearFaultPulse is a time [s], but 2 is a number");
}

TEST_F(CompileErrors, AskForTheTypeOfALaw) {
  expect_first("int main() {" + wall +
                   "add(model, Moat{.around = base, .clearance = 1 * m,\n"
                   ".law = {.stiffness = 1 * N / m_3_2, .restitution = 0.65}}); }",
               "tower.cpp:7: field law of Moat needs the name of a type in front of the braces, as in .law = "
               "HertzDamp{...}\n   7 | .law");
  expect_first("auto make(NodeId base) {\nreturn Spring{.lower = ground, .upper = base, .law = {1 * N / m}}; }",
               "tower.cpp:5: field law of Spring needs the name of a type in front of the braces, as in .law = "
               "Linear{...}\n");
}

TEST_F(CompileErrors, AskForTheTypeOfAFieldThatTakesSeveral) {
  expect_first(
      "const ShearBuilding building{.storeys = 2, .floor_mass = 1 * kg, .storey_stiffness = 1 * N / m,\n"
      ".isolation = {.yield_force = 2 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19 * MN / m}};",
      "tower.cpp:5: field isolation of ShearBuilding needs the name of a type in front of the braces, as in "
      ".isolation = LeadRubberBearing{...}\n   5 | .isolation");
  expect_first("const ShearBuilding building{.storeys = 2, .floor_mass = 1 * kg,\n.storey = {.stiffness = 1 * N / m}};",
               "tower.cpp:5: field storey of ShearBuilding needs the name of a type in front of the braces, as in "
               ".storey = YieldingStorey{...}\n");
  expect_first("const auto law = FrictionPendulum{.radius = 2 * m, .friction = {.slow = 0.05, .fast = 0.1}};",
               "tower.cpp:4: field friction of FrictionPendulum needs the name of a type in front of the braces, as in "
               ".friction = VelocityDependent{...}\n");
}

TEST_F(CompileErrors, NameTheFieldOfAnArgumentOfAnOverloadedFunction) {
  expect_first("const auto columns = grid(3, 2, {.stiffness = 100 * MN});",
               "tower.cpp:4: field stiffness of StoreyColumn is a stiffness [N/m], but 100 * MN is a force [N]\n");
  expect_first("const auto columns = grid(3, 2, {.stifness = 100 * MN / m});",
               "tower.cpp:4: StoreyColumn has no field stifness; did you mean stiffness?");
  expect_first("const auto columns = grid(3, 2, {.stiffness_x = 1 * MN / m, .stiffness_y = 100 * MN});",
               "tower.cpp:4: field stiffness_y of StoreyColumn is a stiffness [N/m], but 100 * MN is a force [N]\n");
}

TEST_F(CompileErrors, AskForAWholeNumber) {
  expect_first("const ShearBuilding building{.storeys = 5.0, .floor_mass = 1 * kg, .storey_stiffness = 1 * N / m};",
               "tower.cpp:4: 5.0 is a number with a decimal point, but a whole number is needed here; write 5\n");
  expect_first("const ShearBuilding building{.storeys = 2 * m, .floor_mass = 1 * kg, .storey_stiffness = 1 * N / m};",
               "tower.cpp:4: 2 * m is a length [m], but a whole number is needed here\n");
}

TEST_F(CompileErrors, GiveAUnitOfTheRightDimension) {
  expect_first("const Linear law{5e6};",
               "tower.cpp:4: 5e6 is a number without unit, but a stiffness [N/m] is needed here; give it a unit, as in "
               "5e6 * N / m\n");
  const auto hint = [](const std::string& needed) { return unit_hint(needed, "10"); };
  const std::string all = "const Speed a = 10 * m / s;\nconst Acceleration b = 10 * m / (s * s);\n";
  EXPECT_EQ(hint("a mass [kg], or one per storey,"), "; give it a unit, as in 10 * kg");
  EXPECT_EQ(hint("a frequency [1/s]"), "; give it a unit, as in 10 * Hz");
  EXPECT_EQ(hint("a speed [m/s]"), "; give it a unit, as in 10 * m / s");
  EXPECT_EQ(hint("an acceleration [m/s^2]"), "; give it a unit, as in 10 * m / (s * s)");
  EXPECT_EQ(hint("an energy [J = N m]"), "; give it a unit, as in 10 * J");
  EXPECT_EQ(hint("a damping coefficient [N s/m]"), "; give it a unit, as in 10 * N * s / m");
  EXPECT_EQ(hint("a Hertz stiffness [N/m^1.5]"), "; give it a unit, as in 10 * N / m_3_2");
  EXPECT_EQ(unit_hint("a length [m]", "a + b"), "; give it a unit, as in (a + b) * m");
  EXPECT_EQ(unit_hint("a stiffness [N/m]", ""), "; give it a unit, as in 10 * N / m");
}

TEST_F(CompileErrors, FindTheWrongValueOfAStorey) {
  const std::string front = "const ShearBuilding building{.storeys = 2,\n",
                    rest = ",\n.storey_stiffness = 1 * GN / m};";
  expect_first(front + ".floor_mass = {500 * tonne, 500 * kN}" + rest,
               "tower.cpp:5: each value of field floor_mass of ShearBuilding is a mass [kg], but 500 * kN is a force "
               "[N]\n   5 | .floor_mass");
  expect_first("const Force weight = 5 * MN;\n" + front + ".floor_mass = {500 * tonne, weight}" + rest,
               "tower.cpp:6: a value does not fit: each value of field floor_mass of ShearBuilding is a mass [kg]\n");
}

TEST_F(CompileErrors, PointAtABracketThatDoesNotFit) {
  const std::string text = explained_for(
      "int main() {\n" + wall +
      "add(model, Moat{.around = base, .clearance = 1 * m,\n.law = Hertz{.stiffness = 1 * N / m_3_2});\n}");
  EXPECT_TRUE(
      text.starts_with("tower.cpp:8: the '{' behind Moat in line 7 is not closed before this ')', or this ')' "
                       "is one too many\n   8 | .law = Hertz"))
      << text;
  EXPECT_EQ(text.find("template arguments"), std::string::npos) << text;
  expect_first("int main() { return 0; }\n}", "tower.cpp:5: this '}' is one too many\n   5 | }\n     | ^\n");
  expect_first("int main() { const char a = '{';\nreturn a }", "tower.cpp:5: expected ';' before '}' token\n");
}

TEST_F(CompileErrors, SuggestTheNearestTypeAndLeaveOutTheErrorsItCauses) {
  const std::string text =
      explained_for("int main() {\n" + wall +
                    "add(model, Moat{.around = base, .clearance = 1 * m,\n.law = HertzDump{.stiffness = 1 * N / "
                    "m_3_2, .restitution = 0.65}});\n}");
  EXPECT_TRUE(text.starts_with("tower.cpp:8: 'HertzDump' was not declared in this scope; did you mean 'HertzDamp'?\n"))
      << text;
  EXPECT_EQ(text.find("template arguments"), std::string::npos) << text;
}

TEST_F(CompileErrors, NameTheOptionsOfARun) {
  const std::string front =
      "int run(Script& script, Model& model, const GroundMotion& motion) {\nreturn script.run(model, motion, ";
  expect_first(front + "{.transient = {.step = 0.01 * s}}); }",
               "tower.cpp:5: TransientOptions has no field transient; it has integrator, step, ");
  expect_first(
      front + "{.step = 0.01}); }",
      "tower.cpp:5: field step of TransientOptions is a time [s], but 0.01 is a number without unit; give it a "
      "unit, as in 0.01 * s\n");
}

TEST_F(CompileErrors, SuggestNoNameThatTheScriptDoesNotKnow) {
  expect_first("int main() { add(model, 1); }", "tower.cpp:4: 'model' was not declared in this scope\n");
  expect_first("int main() { int frames = 1; return frame; }",
               "tower.cpp:4: 'frame' was not declared in this scope; did you mean 'frames'?\n");
}

TEST_F(CompileErrors, KeepTheCompilersWordsOtherwise) {
  expect_first("int main() { modl.add(); }", "tower.cpp:4: 'modl' was not declared in this scope");
  EXPECT_NE(explained_for("int main() { Model model; model.add(1 * kN); }").find("has no member named 'add'"),
            std::string::npos);
}

TEST_F(CompileErrors, AreFiveAtMost) {
  std::string text;
  for (int i = 0; i < 8; ++i) text += "int a" + std::to_string(i) + " = b" + std::to_string(i) + ";\n";
  const std::string all = explained_for(text);
  EXPECT_NE(all.find("'b4' was not declared"), std::string::npos);
  EXPECT_EQ(all.find("'b5' was not declared"), std::string::npos);
  EXPECT_TRUE(all.ends_with("... and 3 more errors\n")) << all;
}

TEST(CompilerOutput, ThatHoldsNoErrorIsShownAsItIs) {
  EXPECT_EQ(explained("undefined reference to `moat::add'\n", "tower.cpp", "."),
            "undefined reference to `moat::add'\n");
}

TEST(LinkErrors, BeginWithASentence) {
  const auto first_line = [](const std::string& output) {
    return lines_of(explained(output, "tower.cpp", ".")).front();
  };
  const std::string no_main =
      "tower.cpp: the script has no function main; a script needs int main(int argc, char** argv)";
  EXPECT_EQ(first_line("/usr/lib/Scrt1.o:function _start: error: undefined reference to 'main'\n"), no_main);
  EXPECT_EQ(first_line("/usr/bin/ld: /usr/lib/Scrt1.o: in function `_start':\n"
                       "(.text+0x1b): undefined reference to `main'\n"),
            no_main);
  EXPECT_EQ(first_line("/tmp/a.o:tower.cpp:function main: error: undefined reference to 'gap_of(moat::Quantity<0, 2, "
                       "0>)'\n"),
            "tower.cpp: nothing defines gap_of(Length), which the script uses; write its definition in the script");
}

TEST(LinkErrors, KeepTheLinkersTextAndNameEachFunctionOnce) {
  const std::string line = "a.cpp:function main: error: undefined reference to 'f()'\n";
  EXPECT_EQ(explained(line + line, "a.cpp", "."),
            "a.cpp: nothing defines f(), which the script uses; write its definition in the script\n" + line + line);
}

}  // namespace
}  // namespace moat::launcher
