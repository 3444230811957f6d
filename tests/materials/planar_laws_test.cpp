// Duties of every law of two components. The tests of each law have its own properties.
#include "materials/plan/planar_laws.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "materials/contact/named_impact_law.hpp"
#include "message_of.hpp"
#include "planar_cases.hpp"

namespace moat::testing {
namespace {

TEST(EveryPlanarLaw, PassesTheBattery) {
  AllPlanarLaws::for_each([]<class Law>() {
    int count = 0;
    for (const PlanarCase<Law>& each : planar_cases<Law>()) {
      SCOPED_TRACE(std::string{Law::name} + " " + std::to_string(++count));
      EXPECT_EQ(message_of([&] { each.law.check(Check{"PlanSpring", "bearing"}); }), "nothing was thrown");
      expect_sound_planar_law(each.law, each.trial);
    }
    EXPECT_GT(count, 0) << Law::name;
  });
}

// Whether a header in `materials` has a law of two components: its name says so, or a function that gives the force of
// one.
bool has_planar_law(const std::filesystem::path& header) {
  std::ostringstream text;
  text << std::ifstream{header}.rdbuf();
  return header.stem().string().starts_with("biaxial_") ||
         text.str().find("PlanarResponse evaluate(") != std::string::npos;
}

TEST(AllPlanarLaws, AreTheHeadersInTheFolderOfMaterials) {
  std::set<std::string> headers, laws;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{MOAT_SOURCE_DIR "/materials"})
    if (entry.path().extension() == ".hpp" && has_planar_law(entry.path())) headers.insert(entry.path().stem());
  AllPlanarLaws::for_each([&]<class Law>() { laws.insert(option_name(Law::name)); });
  EXPECT_EQ(headers, laws) << "every header of a law of two components has the name of its law, and a place in "
                              "AllPlanarLaws (materials/plan/planar_laws.hpp)";
}

}  // namespace
}  // namespace moat::testing
