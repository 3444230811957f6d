#include "launcher/script_build.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "launcher/stop.hpp"
#include "launcher_testing.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;
using ScriptBuildTest = InSmallCheckout;

// A script as the user names it.
struct Script {
  const Places& places;
  fs::path file;
  [[nodiscard]] fs::path program() const {
    for (const auto& entry : fs::directory_iterator{places.work / "scripts"})
      if (entry.path().filename().string().starts_with(file.stem().string())) return entry.path() / "program";
    return {};
  }
};

fs::path built(const Script& script) { return program_of_script(script.places, script.file); }

TEST_F(ScriptBuildTest, CompilesOnlyWhatHasChanged) {
  const Script script{places, write_script("tower.cpp", "first")};
  EXPECT_EQ(output_of_program(built(script)), "first\n");
  const auto before = identity(script.program());
  EXPECT_EQ(identity(built(script)), before);
  write_script("tower.cpp", "second");
  EXPECT_EQ(output_of_program(built(script)), "second\n");
}

TEST_F(ScriptBuildTest, NoticesAChangedInclude) {
  const fs::path script_file = write_script("tower.cpp", "%d metres");
  const fs::path header = folder / "study" / "height of it.hpp";
  write_text(script_file,
             "#include <cstdio>\n#include \"height of it.hpp\"\nint main() { std::printf(\"%d\", height); }\n");
  write_text(header, "const int height = 30;\n");
  const Script script{places, script_file};
  EXPECT_EQ(output_of_program(built(script)), "30");
  write_text(header, "const int height = 40;\n");
  EXPECT_EQ(output_of_program(built(script)), "40");
}

// Ninja compares dates of writing, which moving and copying a file keep.
TEST_F(ScriptBuildTest, NoticesAnOlderFileInThePlaceOfTheScript) {
  const fs::path old = write_script("old_tower.cpp", "old");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours{24});
  const Script script{places, write_script("tower.cpp", "new")};
  EXPECT_EQ(output_of_program(built(script)), "new\n");
  fs::rename(old, folder / "study" / "tower.cpp");
  EXPECT_EQ(output_of_program(built(script)), "old\n");
}

TEST_F(ScriptBuildTest, NoticesChangedHeadersOfTheLibrary) {
  fs::create_directories(places.build / "script_header");
  const fs::path precompiled = places.build / "script_header" / "moat.hpp.gch";
  write_text(precompiled, "");
  const Script script{places, write_script("tower.cpp", "text")};
  const auto before = identity(built(script));
  write_text(precompiled, "newer");
  EXPECT_NE(identity(built(script)), before);
}

TEST_F(ScriptBuildTest, NoticesChangedOptionsOfTheCompiler) {
  const Script script{places, write_script("tower.cpp", "text")};
  const auto before = identity(built(script));
  write_text(places.build / "script_compile.txt", text_of(places.build / "script_compile.txt") + "-O1\n");
  EXPECT_NE(identity(built(script)), before);
}

TEST_F(ScriptBuildTest, TakesStrangeNames) {
  for (const std::string& name :
       std::vector<std::string>{std::string(251, 'a') + ".cpp", "a tower.cpp", "my $study #1/it's.cpp",
                                "semi;colon & more/t:w*r.cpp", "back\\slash.cpp", "[x] \"quoted\" `tick` %d.cpp",
                                "Wände.cpp", "(a) <b> |c| ~d^.cpp", "new\nline.cpp", "tab\tulator.cpp"}) {
    const Script script{places, write_script(name, "hello")};
    EXPECT_EQ(output_of_program(built(script)), "hello\n") << name;
    EXPECT_EQ(output_of_program(built(script)), "hello\n") << name;
  }
}

// As a power cut or a damaged disk leaves it: empty, cut at any place, with one other bit, or another program.
TEST_F(ScriptBuildTest, CompilesADamagedProgramAgain) {
  const Script script{places, write_script("tower.cpp", "hello")};
  const std::string whole = text_of(built(script));
  std::string flipped = whole, zeros = whole;
  flipped[whole.size() / 2] ^= 1;
  zeros.replace(whole.size() / 2, std::string::npos, whole.size() - whole.size() / 2, '\0');
  for (const std::string& damaged :
       {std::string{}, std::string{"no program"}, whole.substr(0, whole.size() - 1), whole.substr(0, whole.size() / 2),
        whole.substr(0, 5000), flipped, zeros, text_of("/bin/true")}) {
    write_text(script.program(), damaged);
    EXPECT_EQ(output_of_program(built(script)), "hello\n") << damaged.size();
    const auto after = identity(script.program());
    EXPECT_EQ(identity(built(script)), after) << "a whole program is not compiled again";
  }
}

TEST_F(ScriptBuildTest, CompilesAgainWhereTheListOfFilesWasCut) {
  const Script script{places, write_script("tower.cpp", "hello")};
  const fs::path list = built(script).parent_path() / "rule";
  const std::string whole = text_of(list);
  for (const std::size_t length : {whole.size() - 2, whole.size() / 2, std::size_t{0}}) {
    const auto before = identity(script.program());
    write_text(list, whole.substr(0, length));
    EXPECT_NE(identity(built(script)), before) << length;
  }
}

// As a compilation leaves it that was killed behind its last write.
TEST_F(ScriptBuildTest, CompilesAgainWithoutTheHashOfTheProgram) {
  const Script script{places, write_script("tower.cpp", "hello")};
  const auto before = identity(built(script));
  fs::remove(script.program().parent_path() / "hash");
  EXPECT_NE(identity(built(script)), before);
  const auto after = identity(script.program());
  EXPECT_EQ(identity(built(script)), after);
}

TEST_F(ScriptBuildTest, StopsWhereAScriptDoesNotCompile) {
  const fs::path file = write_script("tower.cpp", "hello");
  const Script script{places, file};
  built(script);
  const std::string source = text_of(file);
  write_text(file, "#include <cstdio>\nint main() { return hight; }\n");
  ::testing::internal::CaptureStderr();
  EXPECT_THROW(built(script), Stop);
  const std::string errors = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(errors.find(file.string() + ":2:21: error: ‘hight’ was not declared in this scope"), std::string::npos)
      << errors;
  EXPECT_NE(text_of(script.program().parent_path() / "compile.log").find("hight"), std::string::npos);
  EXPECT_THROW(built(script), Stop) << "the old program must not run";
  write_text(file, source);
  EXPECT_EQ(output_of_program(built(script)), "hello\n");
}

TEST_F(ScriptBuildTest, ShowsWarningsOfTheScript) {
  const fs::path file = write_script("tower.cpp", "hello");
  write_text(file, "int main() { int unused; }\n");
  ::testing::internal::CaptureStderr();
  program_of_script(places, file);
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("unused variable"), std::string::npos);
}

TEST_F(ScriptBuildTest, RemovesProgramsThatWereNotRunForTwoWeeks) {
  const Script old{places, write_script("old.cpp", "old")}, used{places, write_script("used.cpp", "used")};
  const fs::path program = built(old);
  built(used);
  fs::last_write_time(program.parent_path(), fs::file_time_type::clock::now() - std::chrono::hours{15 * 24});
  const Script script{places, write_script("tower.cpp", "hello")};
  built(script);
  EXPECT_FALSE(fs::exists(program.parent_path()));
  EXPECT_TRUE(fs::exists(used.program()));
  EXPECT_TRUE(fs::exists(script.program()));
}

}  // namespace
}  // namespace moat::launcher
