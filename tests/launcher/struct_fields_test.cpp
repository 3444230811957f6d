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

TEST_F(StructFields, HaveTheirTypes) {
  std::filesystem::create_directories(folder / "structures");
  write_text(folder / "structures" / "wall.hpp",
             "struct Wall {\n  Required<decltype(units::N / (units::m * units::m))> modulus;\n"
             "  decltype(units::kg / units::m) density =\n      2400.0 * units::kg / units::m;\n"
             "  double force(double x) const;\n  Sides sides = Sides::both;\n};\n");
  const std::vector<Field> fields = declared_fields("Wall", folder);
  ASSERT_EQ(fields.size(), 3u);
  EXPECT_EQ(fields[0].name, "modulus");
  EXPECT_EQ(fields[1].name, "density");
  EXPECT_EQ(fields[2].name, "sides");
  EXPECT_EQ(fields[2].type, "Sides");
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

TEST_F(StructFields, MayShareALine) {
  std::filesystem::create_directories(folder / "structures");
  write_text(folder / "structures" / "column.hpp", "struct Column {\n  Stiffness x{}, y{};  ///< N/m\n};\n");
  EXPECT_EQ(fields_of("Column", folder), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(declared_fields("Column", folder).back().type, "Stiffness");
}

TEST_F(StructFields, BelongToTypesWithNamesAndConcepts) {
  std::filesystem::create_directories(folder / "elements");
  write_text(folder / "elements" / "gap.hpp",
             "template <ImpactLaw Law>\nstruct Gap {\n};\nclass Names : public Base {\n};\nusing Ye = Gap<X>;\n");
  EXPECT_EQ(names_of_types(folder), (std::vector<std::string>{"Ye", "Gap", "Names"}));
  EXPECT_EQ(concept_of("Gap", folder), "ImpactLaw");
  EXPECT_EQ(concept_of("Names", folder), "");
  EXPECT_TRUE(is_in_headers("Base", folder));
  EXPECT_FALSE(is_in_headers("Bas", folder));
}

}  // namespace
}  // namespace moat::launcher
