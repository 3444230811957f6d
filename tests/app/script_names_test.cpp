// Names that a script may give its options.

#include <gtest/gtest.h>

#include "app/script/script.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/near_fault_pulse.hpp"

namespace moat {
namespace {

using testing::message_of;
using units::m;

class OptionNames : public ::testing::Test {
 protected:
  std::string program = "script";
  std::vector<char*> arguments{program.data(), nullptr};
  Script script{1, arguments.data(), "names"};
};

TEST_F(OptionNames, AreUsedOnce) {
  script.length("gap", 1 * m, "");
  const std::string message = message_of([&] { script.number("gap", 1.0, ""); });
  EXPECT_TRUE(message.starts_with("--gap: there is an option of this name. Name each once; ")) << message;
  EXPECT_NO_THROW(script.number("gap_2", 1.0, ""));
}

TEST_F(OptionNames, OfTheScriptItselfAreTaken) {
  EXPECT_THROW(script.text("help", "", ""), InputError);
  script.motion(near_fault_pulse());
  EXPECT_THROW(script.text("record", "", ""), InputError);
  script.number("quiet", 1.0, "");
  Model model;
  add(model, Node{.name = "body", .mass = 1 * units::kg});
  const std::string message = message_of([&] { script.run(model, near_fault_pulse()); });
  EXPECT_TRUE(message.starts_with("--quiet: there is an option of this name.")) << message;
}

TEST_F(OptionNames, AreLettersDigitsDashesAndUnderscores) {
  for (const char* name : {"", "-gap", "two words", "a=b", "gap,g"})
    EXPECT_EQ(message_of([&] { script.text(name, "", ""); }),
              std::string{"Script: \""} + name + "\" cannot be the name of an option. Use letters, digits, - and _.");
}

}  // namespace
}  // namespace moat
