// Mistakes in a script, compiled as the launcher does, and the sentence that must come first. GCC's first error follows
// unchanged.

#include "launcher/compile_errors.hpp"

#include <gtest/gtest.h>

#include "launcher/process.hpp"
#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

class CompileErrors : public moat::testing::InTemporaryFolder {
 protected:
  // The message to the user about a script with this text, which begins at line 4.
  std::string explained_for(const std::string& text) const {
    const std::filesystem::path script = folder / "tower.cpp", log = folder / "log";
    write_text(script, "#include <moat.hpp>\nusing namespace moat;\nusing namespace moat::units;\n" + text + "\n");
    Command compile = lines_of(text_of(std::filesystem::path{BUILD_FOLDER} / "script_compile.txt"));
    compile.insert(compile.begin(), {"env", "LC_ALL=C.UTF-8"});
    compile.insert(compile.end(), {"-fsyntax-only", script});
    EXPECT_NE(run(compile, log), 0) << "compiles: " << text;
    const std::string message = explained(text_of(log), MOAT_SOURCE_DIR);
    const std::size_t first = message.find(": error: "), begin = message.rfind('\n', first) + 1;
    EXPECT_NE(text_of(log).find(message.substr(begin, message.find('\n', first) - begin)), std::string::npos)
        << "not the compiler's words: " << message;
    return replaced(message, folder.string() + "/", "");
  }

  void expect_first(const std::string& text, const std::string& sentence) const {
    const std::string all = explained_for(text);
    EXPECT_TRUE(all.starts_with("tower.cpp:" + sentence)) << text << "\ngives:\n" << all << "instead of:\n" << sentence;
  }

  void expect_no_sentence(const std::string& text) const {
    const std::string all = explained_for(text), first = all.substr(0, all.find('\n'));
    EXPECT_NE(first.find(": error: "), std::string::npos) << text << "\ngives:\n" << all;
  }
};

const std::string wall = "Model model;\nconst NodeId base = add(model, Node{.name = \"base\", .mass = 1 * kg});\n";
const std::string law = ", .law = Hertz{.stiffness = 1 * N / m_3_2}";

TEST_F(CompileErrors, NameTheDimensionOfAValueInAList) {
  expect_first("const Node node{.name = \"base\",\n.mass = 500 * kN};",
               "5: field mass of Node: 500 * kN is a force [N], but a mass [kg] is needed\n");
  expect_first(
      "const HertzDamp law{.stiffness = 2.95e9 * N / m, .restitution = 0.65};",
      "4: field stiffness of HertzDamp: 2.95e9 * N / m is a stiffness [N/m], but a Hertz stiffness [N/m^1.5] is "
      "needed\n");
  expect_first(
      "int main() {" + wall + "add(model, Moat{.around = base,\n.clearance = 0.10" + law + "}); }",
      "7: field clearance of Moat: 0.10 is a number without unit, but a length [m] is needed; give it a unit, as "
      "in 0.10 * m\n");
  expect_first("const ShearBuilding building{.storeys = 2,\n.floor_mass = 500 * kN, .storey_stiffness = 1 * GN / m};",
               "5: field floor_mass of ShearBuilding: 500 * kN is a force [N], but a mass [kg] is needed\n");
}

TEST_F(CompileErrors, NameTheDimensionOfAnArgumentInBraces) {
  expect_first(
      "const GroundMotion pulse = near_fault_pulse({\n.pulse_period = 1.3 * s,\n.amplitude = 0.8});",
      "6: field amplitude of NearFaultPulse: 0.8 is a number without unit, but a speed [m/s] is needed; give it a "
      "unit, as in 0.8 * m / s\n");
  expect_first(
      "void run(Model& model, const GroundMotion& motion) {\n"
      "run_case(model, motion, {.title = \"x\", .transient = {.step = 0.01}}); }",
      "5: field step of TransientOptions: 0.01 is a number without unit, but a time [s] is needed");
  expect_first(
      "int run(Script& script, Model& model, const GroundMotion& motion) {\n"
      "return script.run(model, motion, {.step = 0.01}); }",
      "5: field step of TransientOptions: 0.01 is a number without unit, but a time [s] is needed");
  expect_first("const auto columns = grid(3, 2, {.stiffness_x = 1 * MN / m, .stiffness_y = 100 * MN});",
               "4: field stiffness_y of StoreyColumn: 100 * MN is a force [N], but a stiffness [N/m] is needed\n");
  expect_first("const GroundMotion pulse = near_fault_pulse({.phase = 1 * s});",
               "4: field phase of NearFaultPulse: 1 * s is a time [s], but a number without unit is needed\n");
}

TEST_F(CompileErrors, NameTheDimensionsOfOtherValues) {
  const std::string sentence = "this is a number without unit, but a length [m] is needed\n";
  expect_first("const Length gap = 0.10;", "4: " + sentence);
  expect_first("void set(Length gap);\nvoid run() { set(0.10); }", "5: " + sentence);
  expect_first("void run(Script& script) { script.length(\"gap\", 0.10, \"clearance\"); }", "4: " + sentence);
  expect_first("const Stiffness k = 1 * N / m;\nconst HertzDamp law{.stiffness = k, .restitution = 0.65};",
               "5: this is a stiffness [N/m], but a Hertz stiffness [N/m^1.5] is needed\n");
  expect_first("const Length a = 1 * m + 2 * kN;", "4: left stands a length [m], right a force [N]\n");
  expect_first("const Length a = 1 * kg * m * m;", "4: this is a quantity in kg m^2, but a length [m] is needed\n");
}

TEST_F(CompileErrors, NameTheDimensionOfAVariableInATemplate) {
  expect_first("int main() {" + wall + "const double wide = 0.1;\nadd(model, Moat{.around = base,\n.clearance = wide" +
                   law + "}); }",
               "8: this is a number without unit, but a length [m] is needed\n");
}

TEST_F(CompileErrors, NameTheMissingField) {
  expect_first("const Node node{.name = \"base\"};", "4: field mass of Node is missing\n");
  expect_first("const Viscous law{};", "4: field damping of Viscous is missing\n");
  expect_first("const HertzDamp law{.stiffness = 1 * N / m_3_2};", "4: field restitution of HertzDamp is missing\n");
  expect_first("int main() {" + wall + "add(model, Moat{.around = base" + law + "}); }",
               "6: field clearance of Moat is missing\n");
  expect_first("int main() {" + wall + "add(model, Moat{.around = base, .clearance = 1 * m}); }",
               "6: field law of Moat is missing\n");
  expect_first("const ShearBuilding building{.storeys = 5, .storey_stiffness = 1 * GN / m};",
               "4: field floor_mass of ShearBuilding is missing\n");
}

TEST_F(CompileErrors, SuggestTheNearestField) {
  expect_first("const Node node{.name = \"base\",\n.masses = 1 * kg};",
               "5: Node has no field masses; did you mean mass?\n");
  expect_first("const Node node{.colour_of_paint = 1 * kg};", "4: Node has no field colour_of_paint; it has name, ");
  expect_first("const auto law = HertzDamp{.stifness = 1 * N / m_3_2, .restitution = 0.65};",
               "4: HertzDamp has no field stifness; did you mean stiffness?\n");
  const std::string moat =
      "Moat{.name = \"a } TOWER\", .around = base,  // the {base\n.clearence = 10 * cm" + law + "\n}";
  expect_first("int main() {" + wall + "add(model, " + moat + "); }",
               "7: Moat has no field clearence; did you mean clearance?\n");
  expect_first("int main() {" + wall + "const Moat west{.clearence = 10 * cm" + law + "}; }",
               "6: Moat has no field clearence; did you mean clearance?\n");
  expect_first("auto make(NodeId base) {\nreturn Gap{.left = ground, .rihgt = base, .clearance = 1 * m" + law + "}; }",
               "5: Gap has no field rihgt; did you mean right?\n");
  expect_first("const GroundMotion pulse = near_fault_pulse({.puls_period = 1.3 * s});",
               "4: NearFaultPulse has no field puls_period; did you mean pulse_period?\n");
  expect_first("const auto columns = grid(3, 2, {.stifness = 100 * MN / m});",
               "4: StoreyColumn has no field stifness; did you mean stiffness?\n");
  expect_first(
      "int run(Script& script, Model& model, const GroundMotion& motion) {\n"
      "return script.run(model, motion, {.transient = {.step = 0.01 * s}}); }",
      "5: TransientOptions has no field transient; it has integrator, step, ");
}

TEST_F(CompileErrors, NameTheFieldInTheWrongPlaceAndGiveTheOrder) {
  expect_first("const Node node{.mass = 1 * kg,\n.name = \"base\"};",
               "5: field name of Node stands in the wrong place; the order is name, mass");
  expect_first(
      "const HuGuo law{.restitution = 0.65, .stiffness = 1 * N / m_3_2};",
      "4: field stiffness of HuGuo stands in the wrong place; the order is stiffness, restitution, may_pull\n");
  expect_first("int main() {" + wall + "add(model, Moat{.clearance = 10 * cm, .around = base" + law + "}); }",
               "6: field around of Moat stands in the wrong place; the order is name, around, clearance, law, ");
  expect_first("const GroundMotion pulse = near_fault_pulse({.amplitude = 1 * m / s, .pulse_period = 1.3 * s});",
               "4: field pulse_period of NearFaultPulse stands in the wrong place; the order is pulse_period, ");
}

TEST_F(CompileErrors, PointAtTheLineWithoutSemicolon) {
  const std::string sentence = "a semicolon is missing at the end of this line\n";
  expect_first("int main() {\nconst Length a = 1 * m  // the gap\n\nconst Length b = 2 * m; }", "5: " + sentence);
  expect_first("int main() {\nModel model\nconst Length b = 2 * m; }", "5: " + sentence);
  expect_first("int main() {\nModel model;\nmodel.is_plan()\nreturn 0; }", "6: " + sentence);
  expect_first("int main() { const char a = '{';\nreturn a }", "5: " + sentence);
  expect_first("struct Tower {\nint storeys = 3;\n}\nint main() {}", "6: " + sentence);
}

// A tabulator and letters of several bytes stand in front of the list.
TEST_F(CompileErrors, PointAtASemicolonInsideAList) {
  expect_first("int main() {" + wall + "add(model, Moat{.around = base;\n.clearance = 10 * cm" + law + "}); }",
               "6: this semicolon stands inside a list in braces; take a comma\n");
  expect_first("const ShearBuilding building{.storeys = 4;\n  .floor_mass = 500 * tonne};",
               "4: this semicolon stands inside a list in braces; take a comma\n");
}

TEST_F(CompileErrors, NameAFunctionWithoutReturn) {
  const std::string begin = "int main(int argc, char** argv) {\nScript script{argc, argv, \"gaps\"};\n";
  const std::string study = "script.study({StudyAxis{.name = \"gap\", .values = {1}}}, [](const StudyCase&) {\n";
  const std::string model = "StudyModel one{Model{}, near_fault_pulse({.pulse_period = 1 * s})};\n";
  expect_first(begin + study + model + "});\nreturn script.finish();\n}",
               "6: the function that is given here returns nothing; end it with `return NAME;`\n");
  expect_no_sentence(begin + study + model + "return 3 * m;\n});\nreturn script.finish();\n}");
  expect_no_sentence(begin + "script.integer(\"storeys\", [](int) {});\n}");
}

TEST_F(CompileErrors, NameTheDimensionOfTheValuesOfAnAxis) {
  expect_first("const StudyAxis gap{.name = \"gap\", .unit = \"cm\",\n.values = {10 * cm, 20 * cm}};",
               "5: field values of StudyAxis: 10 * cm is a length [m], but a number without unit is needed\n");
}

TEST_F(CompileErrors, CountColumnsAsTheCompiler) {
  expect_first(
      "\tconst std::string a = \"\xC3\xA4\xC3\xB6\xC3\xBC\"; const Node n{.name = \"\xC3\xA4\", .masses = 1 * kg};",
      "4: Node has no field masses; did you mean mass?\n");
}

// Where nothing is certain the compiler's words stand alone.
TEST_F(CompileErrors, GiveNoSentenceElsewhere) {
  expect_no_sentence("int main() { modl.add(); }");
  expect_no_sentence("int main() { Model model; model.add(1 * kN); }");
  expect_no_sentence("int main() {\nadd(Model{, 1); }");
  expect_no_sentence("int main() {" + wall + "add(model, Moat{.around = base, .clearence = 1 * m); }");
  expect_no_sentence(
      "const ShearBuilding building{.storeys = 2, .isolation = LeadRubberBearing{.yield_force = 1 * MN, "
      ".law = 1);");
  expect_no_sentence("int main()\nconst Length a = 1 * m; }");
  expect_no_sentence("for (int i = 0, i < 3; ++i) {}");
  expect_no_sentence("struct Tower { int storeys; };\nconst Tower tower{.storey = 3};");
  expect_no_sentence("const std::string a = R\"x(})x\";\nconst Node node{.name = \"base\", .masses = 1 * kg};");
  expect_no_sentence(
      "const double g = 9.81;\nvoid set(NearFaultPulse, int);\nvoid run() { set({.phase = 0.4 * g}, \"\"); }");
  expect_no_sentence(
      "const ShearBuilding building{.storeys = 5.0, .floor_mass = 1 * kg, .storey_stiffness = 1 * N / m};");
  expect_no_sentence("int main() {" + wall + "add(model, Moat{base, 1 * m, Viscous{1 * N * s / m}}); }");
}

TEST_F(CompileErrors, AreTheFirstAlone) {
  EXPECT_EQ(explained_for("int a = b;\nint c = d;"),
            "tower.cpp:4:9: error: ‘b’ was not declared in this scope\n    4 | int a = b;\n      |         ^\n");
}

TEST_F(CompileErrors, InHeadersNameTheLineOfTheScript) {
  const std::string all = explained_for(
      "#include <vector>\nstruct NoCopy { NoCopy(const NoCopy&) = delete; };\n"
      "void run(std::vector<NoCopy>& all, NoCopy& one) { all.push_back(one); }");
  EXPECT_NE(all.find("tower.cpp:6:"), std::string::npos) << all;
  EXPECT_NE(all.find("required from"), std::string::npos) << all;
}

TEST(CompilerOutput, ThatHoldsNoErrorIsShownAsItIs) {
  EXPECT_EQ(explained("undefined reference to `moat::add'\n", "."), "undefined reference to `moat::add'\n");
}

}  // namespace
}  // namespace moat::launcher
