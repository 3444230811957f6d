// Every law in `materials` is in a list, and the tests of that list try it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

#include "base/units.hpp"
#include "materials/bilinear.hpp"
#include "materials/contact/impact_laws.hpp"
#include "materials/contact/named_impact_law.hpp"
#include "materials/linear.hpp"
#include "materials/plan/planar_laws.hpp"
#include "materials/spring_laws.hpp"
#include "materials/viscous.hpp"
#include "random_spring.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

// Laws without a folder of their own, of which elements are made.
using BasicLaws = LawList<Linear, Viscous, Bilinear>;

template <ForceLaw Law>
struct BasicCase {
  Law law;
  SpringTrial trial{};
};
template <ForceLaw Law>
BasicCase<Law> basic_case() = delete;

const Bilinear bearing{.yield_force = 1.93 * MN, .yield_displacement = 1 * cm, .post_yield_stiffness = 19.3 * MN / m};

template <>
BasicCase<Linear> basic_case() {
  return {{.stiffness = 1 * MN / m, .damping = 0.3 * MN * s / m}};
}
template <>
BasicCase<Viscous> basic_case() {
  return {{.damping = 0.767 * MN * s / m}};
}
template <>
BasicCase<Bilinear> basic_case() {
  return {bearing};
}

TEST(BasicLaws, PassTheBattery) {
  BasicLaws::for_each([]<class Law>() {
    SCOPED_TRACE(Law::name);
    expect_sound_spring(basic_case<Law>().law, basic_case<Law>().trial);
  });
}

// Whether a header has a law: a function that gives the force of one.
bool has_law(const std::filesystem::path& header) {
  std::ostringstream text;
  text << std::ifstream{header}.rdbuf();
  return text.str().find("\n  Response evaluate(") != std::string::npos ||
         text.str().find("\n  PlanarResponse evaluate(") != std::string::npos;
}

TEST(LawsInTheFolderOfMaterials, AreAllInAList) {
  // These hold another law.
  std::set<std::string> tested{"any_contact", "repeated", "shared_contact"};
  const auto add = [&]<class Law>() { tested.insert(option_name(Law::name)); };
  BasicLaws::for_each(add);
  AllPlanarLaws::for_each(add);
  AllSpringLaws::for_each([&]<class Law>() {
    tested.insert(option_name(Law::name));
    tested.insert(option_name(name_of(force_law(Law::typical()))));
  });
  AllImpactLaws::for_each([&]<class Law>() {
    using Contact = std::remove_cvref_t<decltype(std::declval<const Law&>().between(1.0))>;
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
