// Every impact law is compared with the independent reference on random models, or named here with a reason.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "materials/contact/impact_laws.hpp"
#include "moat_model.hpp"
#include "plain_model.hpp"

namespace moat::testing {
namespace {

// Laws that the reference does not know, and the tests that compare them with exact solutions.
const std::map<std::string, std::string> without_reference{
    {"BilinearImpact",
     "The contacts of the reference have no memory; this one yields. tests/materials/bilinear_impact_test.cpp has its "
     "closed forms, tests/analyses/contact/impact_restitution_test.cpp its restitution in an analysis."},
};

TEST(IndependentReference, KnowsEveryImpactLawOrThisTestSaysWhyNot) {
  std::set<std::string> known;
  for (int kind = 0; kind < plain_law_kinds; ++kind) known.emplace(moat_law_name(static_cast<PlainLawKind>(kind)));
  std::set<std::string> laws;
  AllImpactLaws::for_each([&]<class Law>() {
    const std::string name{Law::name};
    laws.insert(name);
    EXPECT_NE(known.contains(name), without_reference.contains(name))
        << name
        << (known.contains(name)
                ? " is in the reference: take it out of the list above."
                : " is not compared with the independent reference. Give it a PlainLawKind "
                  "(tests/support/reference/plain_model.hpp), its equations (reference_contact.cpp) and its name in "
                  "moat_model.cpp; or name it in the list above with the reason.");
  });
  for (const auto& [name, reason] : without_reference) EXPECT_TRUE(laws.contains(name)) << name << " is no impact law";
  for (const std::string& name : known) EXPECT_TRUE(laws.contains(name)) << name << " is not in AllImpactLaws";
}

}  // namespace
}  // namespace moat::testing
