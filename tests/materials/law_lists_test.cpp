// Every law in `materials` is in a list, and the tests of that list try it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

#include "moat.hpp"
#include "random_spring.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Laws without a folder of their own, of which elements are made.
using BasicLaws = LawList<Linear, Viscous, Bilinear>;

TEST(BasicLaws, PassTheBattery) {
  expect_sound_spring(Linear{.stiffness = 1 * MN / m, .damping = 0.3 * MN * s / m}, {});
  expect_sound_spring(Viscous{.damping = 0.767 * MN * s / m}, {});
  expect_sound_spring(
      Bilinear{.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m}, {});
}

// Whether a header has a law: it stands in a folder of laws, or has a function that gives the force of one.
bool has_law(const std::filesystem::path& header) {
  const std::set<std::string> folders{"impact", "isolation", "dampers", "storeys", "soil"};
  if (folders.contains(header.parent_path().filename())) return true;
  std::ostringstream text;
  text << std::ifstream{header}.rdbuf();
  return text.str().find("\n  Response evaluate(") != std::string::npos ||
         text.str().find("\n  PlanarResponse evaluate(") != std::string::npos;
}

TEST(LawsInTheFolderOfMaterials, AreAllInAList) {
  // These hold another law.
  std::set<std::string> tested{"any_contact", "repeated", "rubber_under_weight"};
  const auto add = [&]<class Law>() { tested.insert(option_name(Law::name)); };
  BasicLaws::for_each(add);
  AllPlanarLaws::for_each(add);
  AllSpringLaws::for_each([&]<class Law>() {
    tested.insert(option_name(Law::name));
    tested.insert(option_name(name_of(force_law(Law::typical()))));
    if constexpr (requires(const Law& law) { law.under_changing_weight(1 * N); })
      tested.insert(option_name(Law::typical().under_changing_weight(1 * N).name));
  });
  AllImpactLaws::for_each([&]<class Law>() {
    using Contact = std::remove_cvref_t<decltype(std::declval<const Law&>().between(1.0))>;
    tested.insert(option_name(Law::name));
    tested.insert(option_name(Contact::name));
  });
  std::set<std::string> headers;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{MOAT_SOURCE_DIR "/materials"})
    if (entry.path().extension() == ".hpp" && has_law(entry.path())) headers.insert(entry.path().stem());
  for (const std::string& header : headers)
    EXPECT_TRUE(tested.contains(header))
        << "the law in " << header
        << ".hpp is in none of AllSpringLaws, AllImpactLaws, AllPlanarLaws and the BasicLaws of this test";
  BasicLaws::for_each([&]<class Law>() {
    EXPECT_TRUE(headers.contains(option_name(Law::name))) << Law::name << ": the header does not have its name";
  });
}

}  // namespace
}  // namespace moat::testing
