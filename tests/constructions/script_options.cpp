// Options of scripts, on the command line.
#include <gtest/gtest.h>

#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

// A script that is started with these words.
template <class Use>
std::function<void()> script(const std::vector<std::string>& words, Use use) {
  return [words, use] {
    std::vector<std::string> line{"tower"};
    line.insert(line.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& word : line) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    Script script{static_cast<int>(line.size()), arguments.data(), "tower"};
    use(script);
  };
}
constexpr auto gap = [](Script& script) { script.length("gap", 10 * cm, "clearance"); };
constexpr auto storeys = [](Script& script) { script.integer("storeys", 5, "count"); };
constexpr auto motion = [](Script& script) { static_cast<void>(script.motion(still_ground(1 * s))); };
constexpr auto run = [](Script& script) {
  Model model;
  add(model, Node{.name = "body", .mass = 1 * kg, .free = true});
  script.run(model, still_ground(1 * s));
};
constexpr auto study = [](Script& script) {
  script.study({StudyAxis{.name = "gap", .unit = "cm", .values = {1}}}, [](const StudyCase&) { return StudyRecord{}; });
};

}  // namespace

Constructions script_options() {
  return {
      {"a length in seconds",
       script({"--gap", "10 s"}, gap),
       {"--gap", "10 s", "in s", "it must be", "in m or multiples of it"}},
      {"a length in words",
       script({"--gap", "wide"}, gap),
       {"--gap", "wide", "does not start with a number", "Write a number", "with its unit"}},
      {"a length without unit",
       script({"--gap", "10"}, gap),
       {"--gap", "10", "has no unit", "Write", "\"10 cm\" or \"10 m\""}},
      {"a length of infinite size",
       script({"--gap", "1e999 m"}, gap),
       {"--gap", "1e999 m", "is too large", "Check", "its exponent"}},
      {"half a storey",
       script({"--storeys", "2.5"}, storeys),
       {"--storeys", "2.5", "is not a whole number", "Write", "digits alone"}},
      {"an option of two words",
       script({}, [](Script& all) { all.text("two words", "", ""); }),
       {"Script", "two words", "name of an option", "Use", "letters, digits, - and _"}},
      {"an option twice",
       script({},
              [](Script& all) {
                gap(all);
                gap(all);
              }),
       {"--gap", "an option", "of this name", "Name each once", "--help"}},
      {"a unit of no record",
       script({"--record-unit", "g"}, motion),
       {"--record-unit", "give it", "together with", "--record", "FILE"}},
      {"a record that is not there",
       script({"--record", "no such record.AT2"}, motion),
       {"no such", "record.AT2", "there is no such file", "Check", "the path"}},
      {"a second component of no first",
       script({"--record-2", "b.AT2"},
              [](Script& all) {
                static_cast<void>(all.plan_motion(PlanMotion{still_ground(1 * s), still_ground(1 * s)}));
              }),
       {"--record", "--record-2", "give", "both components", "or none"}},
      {"results in no folder",
       script({"--out", ""}, run),
       {"results folder", "path", "is empty", "Give a folder", "results/run"}},
      {"an integrator that is misspelt",
       script({"--integrator", "newmrak"}, run),
       {"--integrator", "newmrak", "is not known", "Give one of", "newmark, hht-alpha"}},
      {"an observer that is not there",
       script({},
              [](Script& all) {
                Model model;
                add(model, Node{.name = "body", .mass = 1 * kg, .free = true});
                all.run(model, still_ground(1 * s), {nullptr});
              }),
       {"Script::run", "an observer", "is null", "Give", "the addresses of observers"}},
      {"threads beyond counting",
       script({"--threads", "5000"}, study),
       {"--threads", "5000", "is not allowed", "from 0 to 1024", "0 takes one thread per core"}},
      {"a case of no number",
       script({"--case", "first"}, study),
       {"--case:", "first", "is not allowed", "Write", "--case 17"}},
      {"cases without end", script({"--cases", "3"}, study), {"--cases:", "3", "Write --case 17", "cases", "0:100"}},
      {"a case and cases",
       script({"--case", "1", "--cases", "0:1"}, study),
       {"--case", "and --cases", "give", "one of", "them"}},
      {"a study called as a path",
       script({},
              [](Script& all) {
                all.study(
                    {StudyAxis{.name = "gap", .unit = "cm", .values = {1}}},
                    [](const StudyCase&) { return StudyRecord{}; }, {}, "../study");
              }),
       {"Script::study", "../study", "the name of a study", "Use", "letters, digits, blanks, - and _"}},
      {"an answer before its study",
       script({}, [](Script& all) { all.answer("yes"); }),
       {"Script", "answers and pictures", "belong to a study", "Call study()", "before"}},
      {"a gap in an odd unit",
       script({"--gap", "1e-3 km"},
              [](Script& all) { EXPECT_NEAR(all.length("gap", 10 * cm, "clearance").si(), 1.0, 1e-12); })},
  };
}

}  // namespace moat::constructions
