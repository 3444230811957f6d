// Lines of a megabyte in sources, headers, and words of the compiler and the linker.

#include <gtest/gtest.h>

#include <algorithm>

#include "launcher/compile_errors.hpp"
#include "launcher/process.hpp"
#include "launcher/text.hpp"
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

using LongLines = moat::testing::InTemporaryFolder;

TEST_F(LongLines, AreExplainedInMessagesThatFitOnAScreen) {
  // Texts of GCC and of its linker; LONG stands for the long piece.
  for (const std::string line :
       {"tower.cpp:3:5: error: 'LONG' was not declared in this scope",
        "tower.cpp:3:5: error: could not convert 'LONG' from 'moat::Force' to 'moat::Length'",
        "tower.cpp:3:5: error: could not convert 'x' from 'LONG' to 'moat::Length'",
        "tower.cpp:3:5: error: class template argument deduction failed:\n"
        "tower.cpp:3:5: note:   cannot convert 'x' (type 'LONG') to type 'moat::Length'",
        "tower.cpp:3: error: 'x' was not declared in this scope\n    3 | LONG x\n      | ",
        "tower.cpp:3:900: error: 'x' was not declared in this scope\n    3 | LONG x\n      | LONG^",
        "LONG:3:5: error: x", "/usr/bin/ld: tower.o: undefined reference to `LONG'"})
    for (const std::string& piece : pieces) {
      const std::string text = explained(replaced(line, "LONG", repeated(piece)) + "\n", MOAT_SOURCE_DIR);
      EXPECT_LT(text.size(), longest_message) << line << ": " << piece;
      EXPECT_FALSE(text.empty()) << line << ": " << piece;
    }
}

TEST_F(LongLines, LoseTheirMiddleAlone) {
  EXPECT_EQ(with_short_lines("short\n" + std::string(longest_line, 'a') + "\nlast"),
            "short\n" + std::string(longest_line, 'a') + "\nlast");
  const std::string cut = with_short_lines("first\nbegin" + repeated("x") + "end\nlast\n");
  EXPECT_TRUE(cut.starts_with("first\nbeginxxx")) << cut;
  EXPECT_TRUE(cut.ends_with("xxxend\nlast\n")) << cut;
  EXPECT_NE(cut.find("x ... x"), std::string::npos) << cut;
  for (const std::string& line : lines_of(cut)) EXPECT_LE(line.size(), longest_line);
}

// In the list with the mistake, and in the struct that it is compared with.
TEST_F(LongLines, MayStandInHeadersAndScripts) {
  const std::filesystem::path script = folder / "tower.cpp";
  std::filesystem::create_directories(folder / "elements");
  for (const std::string& piece : pieces) {
    const std::string text = repeated(piece);
    write_text(folder / "elements" / "gap.hpp", "\nstruct Gap {\n  double left" + text +
                                                    " = 0.0;\n  double right = " + text + ";\n  Length x{}, " + text +
                                                    "{};\n  decltype(" + text + ") area;\n  double law;\n};\nusing " +
                                                    text + " = Gap<" + text + ">;\n");
    write_text(script, "// " + text + "\nGap gap{.law = " + text + "};\n" + text + "{.a = 1};\nGap other{.lew = 1};\n");
    const std::string error = ": error: class template argument deduction failed:\n";
    const std::string at_last_list = explained(script.string() + ":4:18" + error, folder);
    if (piece != "‘") {
      EXPECT_LT(at_last_list.size(), longest_message) << piece;
    }
    for (const char* place : {":2:5", ":3:12", ":2:1000005"})
      EXPECT_LT(explained(script.string() + place + error, folder).size(), longest_message) << piece;
  }
}

// Each could be a list of fields; comparing all of them with the headers would not end.
TEST_F(LongLines, MayBeBracesInBraces) {
  const std::filesystem::path script = folder / "tower.cpp";
  for (const std::string open : {"{", "Gap{", "{.law = "}) {
    std::string text = repeated(open);
    text += std::string(static_cast<std::size_t>(std::ranges::count(text, '{')), '}');
    write_text(script, text);
    EXPECT_FALSE(explained(script.string() + ":1:1000001: error: x\n", MOAT_SOURCE_DIR).empty()) << open;
  }
}

// The compiler gives no column behind the 4,096th.
TEST_F(LongLines, OfScriptsAreShownInPart) {
  const std::string table = "double t[] = {" + repeated("1.0, ");
  for (const auto& [source, words] : std::vector<std::pair<std::string, std::string>>{
           {"int main() { " + table + "oops}; }", ": error: ‘oops’ was not declared in this scope\n"},
           {"int main() { return " + std::string(megabyte / 5, 'a') + "; }", ": error: ‘aaa"}}) {
    const std::filesystem::path script = folder / "tower.cpp";
    write_text(script, "#include <moat.hpp>\nusing namespace moat; using namespace moat::units; " + source + "\n");
    Command compile = lines_of(text_of(std::filesystem::path{BUILD_FOLDER} / "script_compile.txt"));
    compile.insert(compile.begin(), {"env", "LC_ALL=C.UTF-8"});
    compile.insert(compile.end(), {"-fsyntax-only", script});
    EXPECT_NE(run(compile, folder / "log"), 0);
    const std::string text = explained(text_of(folder / "log"), MOAT_SOURCE_DIR);
    EXPECT_NE(text.find(words), std::string::npos) << text;
    EXPECT_LT(text.size(), longest_message);
  }
}

}  // namespace
}  // namespace moat::launcher
