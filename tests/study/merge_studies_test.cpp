// Parts of a study, put together.

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "message_of.hpp"
#include "run_program.hpp"
#include "study/file/store.hpp"

namespace moat {
namespace {

using testing::message_of;

class Merge : public testing::InTemporaryFolder {
 protected:
  const StudyCases cases{{.name = "gap", .unit = "cm", .values = {10.0, 20.0, 0.1}},
                         StudyAxis::of_names("record", {"north", "south"})};
  const StudyIdentity identity{{"script", std::string(64, 'a')}};

  /// A part with these numbers and values.
  std::filesystem::path part(const std::string& name, const std::vector<std::pair<std::size_t, double>>& values,
                             const StudyIdentity& by = {{"script", std::string(64, 'a')}},
                             const std::string& unit = "m") {
    StudyStore store{folder / name, cases, by, {.title = "A study", .command_line = name}};
    for (const auto& [number, value] : values)
      store.write(number, {.state = CaseState::done, .results = {{"x", "", unit, value}}});
    store.end_session("finished");
    return folder / name;
  }
  std::string refusal(const std::vector<std::filesystem::path>& parts) {
    return message_of<InputError>([&] { merge_studies(folder / "all.db", parts); });
  }
};

TEST_F(Merge, HasEveryCaseOfItsParts) {
  const auto a = part("a.db", {{0, 0.0}, {1, 1.0}, {2, 2.0}}), b = part("b.db", {{2, 2.0}, {3, 3.0}});
  merge_studies(folder / "all.db", {a, b});
  const StoredStudy all = read_study(folder / "all.db");
  EXPECT_EQ(all.result.count(CaseState::done), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(all.result.values("x", "")[i], static_cast<double>(i));
  EXPECT_EQ(all.title, "A study");
  EXPECT_EQ(all.versions, std::vector<StudyIdentity>(1, identity));
  ASSERT_EQ(all.sessions.size(), 2u);
  EXPECT_EQ(all.sessions[all.session_of_case[3]].command_line, "b.db");
  EXPECT_EQ(all.sessions[0].cases + all.sessions[1].cases, 4u);
  // The same parts again, and the study itself, change nothing.
  merge_studies(folder / "all.db", {a, folder / "all.db", b});
  EXPECT_EQ(read_study(folder / "all.db").sessions.size(), 2u);
  // The script goes on with it.
  EXPECT_NO_THROW((StudyStore{folder / "all.db", cases, identity, {}}));
}

TEST_F(Merge, TakesTheSessionOfEveryCase) {
  part("a.db", {{0, 0.0}});
  merge_studies(folder / "all.db", {part("a.db", {{1, 1.0}})});
  EXPECT_EQ(read_study(folder / "all.db").sessions.size(), 2u) << "the part was computed in two sessions";
}

TEST_F(Merge, RefusesCasesThatDiffer) {
  const auto a = part("a.db", {{2, 2.0}, {3, 3.0}});
  for (const auto& other : {part("b.db", {{1, 1.0}, {3, 3.5}}), part("c.db", {{1, 1.0}, {3, 3.0}}, identity, "cm")})
    EXPECT_NE(refusal({a, other}).find("merge: case 3 of " + other.string() + " differs from the one in " + a.string()),
              std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "all.db")) << "nothing is written";
}

TEST_F(Merge, ComparesEveryBit) {
  const auto a = part("a.db", {{2, 0.0}}), b = part("b.db", {{2, -0.0}});
  EXPECT_NE(refusal({a, b}).find("case 2 of"), std::string::npos);
  const auto c = part("c.db", {{2, std::nan("1")}}), d = part("d.db", {{2, -std::nan("")}});
  merge_studies(folder / "all.db", {c, d});
  EXPECT_EQ(read_study(folder / "all.db").result.count(CaseState::done), 1u);
}

TEST_F(Merge, RefusesPartsOfOtherStudies) {
  const auto a = part("a.db", {{0, 0.0}}), b = part("b.db", {{1, 1.0}}, {{"script", std::string(64, 'b')}});
  EXPECT_NE(refusal({a, b}).find("is not of the same study as"), std::string::npos);
  { StudyStore other{folder / "c.db", {cases.axes()[0]}, identity, {}}; }
  EXPECT_NE(refusal({a, folder / "c.db"}).find("axes: gap, record -> gap"), std::string::npos);
  EXPECT_THROW(merge_studies(folder / "all.db", {a, folder / "none.db"}), FileError);
  EXPECT_NE(refusal({}).find("there is nothing to merge"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "all.db")) << "nothing is written";
}

}  // namespace
}  // namespace moat
