// Lines of a megabyte in sources, headers, logs, and words of the compiler and the linker.

#include <gtest/gtest.h>

#include <functional>

#include "launcher/compile_errors.hpp"
#include "launcher/compiler_output.hpp"
#include "launcher/designated_list.hpp"
#include "launcher/dimension_names.hpp"
#include "launcher/explanation.hpp"
#include "launcher/link_errors.hpp"
#include "launcher/list_errors.hpp"
#include "launcher/misfit.hpp"
#include "launcher/process.hpp"
#include "launcher/struct_fields.hpp"
#include "launcher/text.hpp"
#include "launcher/value_dimension.hpp"
#include "launcher/without_progress.hpp"
#include "run_program.hpp"

namespace moat::launcher {
namespace {

constexpr std::size_t megabyte = 1'000'000, longest_message = 10'000;

std::string repeated(const std::string& piece) {
  std::string text;
  while (text.size() < megabyte) text += piece;
  return text;
}

// A megabyte of each would bring std::regex to the end of the stack in one of the patterns.
const std::vector<std::string> pieces{"a",    " ", "1 * ", "'",       ".a=1,", "Quantity<", "moat::Required<",
                                      "{}, ", "[", "‘",    "' from '"};

// Texts of GCC, of its linker and of Ninja; LONG stands for the long piece.
const std::vector<std::string> lines{
    "tower.cpp:3:5: error: 'LONG' was not declared in this scope",
    "tower.cpp:3:5: error: could not convert 'LONG' from 'moat::Force' to 'moat::Length'",
    "tower.cpp:3:5: error: could not convert 'x' from 'LONG' to 'moat::Length'",
    "tower.cpp:3:5: error: cannot convert 'LONG' to 'moat::Length'",
    "tower.cpp:3:5: error: 'moat::Node' has no non-static data member named 'LONG'",
    "tower.cpp:3:5: error: no matching function for call to 'LONG(int)'",
    "tower.cpp:3:5: error: designated initializers cannot be used with a non-aggregate type 'LONG'",
    "tower.cpp:3:5: error: class template argument deduction failed:\n"
    "tower.cpp:3:5: note:   couldn't deduce template parameter 'LONG'",
    "tower.cpp:3:5: error: cannot declare variable 'LONG' to be of abstract type 'LONG'",
    "tower.cpp:3: error: 'x' was not declared in this scope\n    3 | LONG x\n      | ",
    "tower.cpp:3:900: error: 'x' was not declared in this scope\n    3 | LONG x\n      | LONG^",
    "LONG:3:5: error: x",
    "/usr/bin/ld: tower.o: undefined reference to `LONG'",
    "[1/2] LONG\nFAILED: LONG\nLONG\nLONG"};

TEST(LongLines, AreExplainedInMessagesThatFitOnAScreen) {
  for (const std::string& line : lines)
    for (const std::string& piece : pieces) {
      const std::string output = replaced(line, "LONG", repeated(piece)) + "\n";
      const std::string text = explained(output, "tower.cpp", MOAT_SOURCE_DIR);
      EXPECT_LT(text.size(), longest_message) << line << ": " << piece;
      EXPECT_FALSE(text.empty()) << line << ": " << piece;
      EXPECT_LT(without_progress(output).size(), longest_message) << line << ": " << piece;
    }
}

TEST(LongLines, AreTakenByEveryToolForText) {
  for (const std::string& piece : pieces) {
    const std::string text = repeated(piece), list = "Node{.name = " + text + ", .mass = 1 * kg}";
    const NamedField field{.name = "mass", .value = text, .offset = 0};
    for (const auto& tool : std::vector<std::function<void()>>{
             [&] { (void)with_dimension_names(text); }, [&] { (void)described("PerStorey<" + text + ">"); },
             [&] { (void)type_of_product(text); }, [&] { (void)is_number(text); },
             [&] { (void)misfit_of_field(field, "Node", "Mass"); }, [&] { (void)items_of("{" + text + "}"); },
             [&] { (void)list_around(list, list.size() - 1); }, [&] { (void)list_around(text + "{.a = 1", megabyte); },
             [&] { (void)list_in_call("(" + list + ")", 0); }, [&] { (void)link_explanation(text, "tower.cpp"); },
             [&] { (void)without_second_names(text); }, [&] { (void)needed_in_words("optional<" + text + ">"); },
             [&] { (void)unit_hint("a time [" + text + "]", text); }, [&] { (void)whole_number_hint(text); },
             [&] {
               (void)no_such_field("Node", text, {"name", "mass"});
             },
             [&] { (void)error_groups(text, "tower.cpp"); }})
      EXPECT_NO_THROW(tool()) << piece;
  }
}

TEST(LongLines, ShowTheCompilersFirstErrorAndTheSurroundingsOfItsMarks) {
  const std::string left = repeated("1.0, "), blanks(left.size(), ' ');
  const std::string text = explained("tower.cpp:3:900: error: 'oops' was not declared in this scope\n    3 | " + left +
                                         "oops, 2.0};\n      | " + blanks + "^~~~\n",
                                     "tower.cpp", MOAT_SOURCE_DIR);
  const std::vector<std::string> shown = lines_of(text);
  ASSERT_EQ(shown.size(), 3u) << text;
  EXPECT_EQ(shown[0], "tower.cpp:3: 'oops' was not declared in this scope");
  EXPECT_EQ(shown[1].substr(shown[2].find('^'), 4), "oops");
}

TEST(LongLines, LoseTheirMiddleAlone) {
  EXPECT_EQ(with_short_lines("short\n" + std::string(longest_line, 'a') + "\nlast"),
            "short\n" + std::string(longest_line, 'a') + "\nlast");
  const std::string cut = with_short_lines("first\nbegin" + repeated("x") + "end\nlast\n");
  EXPECT_TRUE(cut.starts_with("first\nbeginxxx")) << cut;
  EXPECT_TRUE(cut.ends_with("xxxend\nlast\n")) << cut;
  EXPECT_NE(cut.find("x ... x"), std::string::npos) << cut;
  for (const std::string& line : lines_of(cut)) EXPECT_LE(line.size(), longest_line);
}

using LongLinesOfFiles = moat::testing::InTemporaryFolder;

TEST_F(LongLinesOfFiles, MayStandInHeaders) {
  std::filesystem::create_directories(folder / "elements");
  for (const std::string& piece : pieces) {
    const std::string text = repeated(piece);
    write_text(folder / "elements" / "gap.hpp", "template <ImpactLaw Law" + text + ">\nstruct Gap {\n  double left" +
                                                    text + " = 0.0;\n  double right = " + text + ";\n  Length x{}, " +
                                                    text + "{};\n  decltype(" + text +
                                                    ") area;\n  double law;\n};\nusing " + text + " = Gap<" + text +
                                                    ">;\nusing Other = Gap<" + text + ">;\nstruct " + text + " {\n");
    EXPECT_EQ(fields_of("Gap", folder).back(), "law") << piece;
    EXPECT_EQ(concept_of("Gap", folder), "") << piece;
    (void)name_in_scripts("Gap<" + text + ">", folder);
    (void)names_of_types(folder);
  }
}

// The compiler gives no column behind the 4,096th.
TEST_F(LongLinesOfFiles, MayStandInScripts) {
  const std::string table = "double t[] = {" + repeated("1.0, ");
  for (const auto& [source, words] : std::vector<std::pair<std::string, std::string>>{
           {"int main() { " + table + "oops}; }", "2: 'oops' was not declared in this scope\n"},
           {"const Node node{.mass = 1 * kg, .name = \"" + repeated("x") + "\"};",
            "2: field name of Node stands in the wrong place; the order is name, mass, "},
           {"int main() { return " + std::string(megabyte / 5, 'a') + "; }", "2: 'aaa"}}) {
    const std::filesystem::path script = folder / "tower.cpp";
    write_text(script, "#include <moat.hpp>\nusing namespace moat; using namespace moat::units; " + source + "\n");
    Command compile = lines_of(text_of(std::filesystem::path{BUILD_FOLDER} / "script_compile.txt"));
    compile.insert(compile.end(), {"-fsyntax-only", script});
    EXPECT_NE(run_into(folder / "log", compile), 0);
    const std::string text = explained(text_of(folder / "log"), script, MOAT_SOURCE_DIR);
    EXPECT_TRUE(text.starts_with(script.string() + ":" + words)) << text;
    EXPECT_LT(text.size(), longest_message);
  }
}

}  // namespace
}  // namespace moat::launcher
