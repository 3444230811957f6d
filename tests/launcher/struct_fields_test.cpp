#include "launcher/struct_fields.hpp"

#include <gtest/gtest.h>

#include "launcher/text.hpp"
#include "run_program.hpp"

namespace moat::launcher {
namespace {

using StructFields = moat::testing::InTemporaryFolder;

TEST_F(StructFields, AreReadFromTheHeaders) {
  std::filesystem::create_directories(folder / "elements");
  write_text(
      folder / "elements" / "gap.hpp",
      "struct Other {\n  int no_field = 0;\n};\n"
      "template <ImpactLaw Law>\nstruct Gap {\n  static constexpr int no_field = 1;\n  /// Its name;\n"
      "  std::string name;\n  Required<MemberPoint> left;\n  std::optional<Wall> wall{};\n  bool pulls = false;\n"
      "  Law law;\n  using State = int;\n  void check(const Check& check) const { check.that(law); }\n};\n"
      "struct After {\n  int no_field;\n};\n");
  EXPECT_EQ(fields_of("Gap", folder), (std::vector<std::string>{"name", "left", "wall", "pulls", "law"}));
  EXPECT_TRUE(fields_of("Nothing", folder).empty());
}

TEST_F(StructFields, AreThoseOfTheTemplateBehindAName) {
  std::filesystem::create_directories(folder / "materials");
  write_text(folder / "materials" / "law.hpp",
             "template <class Factor>\nstruct Law {\n  double stiffness;\n};\nstruct Plain {\n  double x;\n};\n");
  write_text(folder / "materials" / "ye.hpp", "using Ye = Law<YeFactor>;\nusing SecondName = Plain;\n");
  EXPECT_EQ(fields_of("Ye", folder), std::vector<std::string>{"stiffness"});
  EXPECT_EQ(fields_of("SecondName", folder), std::vector<std::string>{"x"});
  EXPECT_EQ(name_in_scripts("Law<YeFactor>", folder), "Ye");
  EXPECT_EQ(name_in_scripts("Law<OtherFactor>", folder), "Law");
  EXPECT_EQ(name_in_scripts("Plain", folder), "Plain");
}

}  // namespace
}  // namespace moat::launcher
