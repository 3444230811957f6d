// The outcomes of a study, as they are kept in its table.
#include "study/result.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "in_folder.hpp"

namespace moat {
namespace {

const StudyCases four{StudyAxis::of_names("record", {"a", "b", "c", "d"})};

std::vector<std::string> names_of(const StudyRecord& record) {
  std::vector<std::string> names;
  for (const NamedNumber& each : record) names.push_back(each.quantity + " " + each.where + " " + each.unit);
  return names;
}

std::vector<std::string> results_of(const Table& table) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < table.columns.size(); ++i)
    names.push_back(table.columns[i].quantity + " " + table.columns[i].where + " " + table.columns[i].unit);
  return names;
}

using StudyResultsInFile = testing::InFolder;

CaseOutcome done(StudyRecord results) { return {.state = CaseState::done, .results = std::move(results)}; }

TEST(StudyResults, GiveBackEveryOutcome) {
  StudyResult study{four};
  const std::vector<FileRead> north{{"/north", "1"}}, other{{"/north", "1"}, {"/south", "1"}};
  const CaseOutcome first{.state = CaseState::done,
                          .results = {{"x", "", "1", std::nan("")}, {"drift", "storey 1", "m", 0.5}},
                          .files = north,
                          .steps = 7,
                          .energy_error = 0.25,
                          .seconds = 2.0};
  study.set(0, first);
  study.set(1, {.state = CaseState::done, .results = {{"drift", "storey 1", "m", 1.5}}, .files = other});
  study.set(2, {.state = CaseState::failed, .reason = "no", .files = north});
  const CaseOutcome found = study.outcome(0);
  EXPECT_EQ(found.state, CaseState::done);
  EXPECT_EQ(names_of(found.results), names_of(first.results));
  EXPECT_TRUE(std::isnan(found.results[0].value)) << "a result without value is one";
  EXPECT_EQ(found.results[1].value, 0.5);
  EXPECT_EQ(found.files, north);
  EXPECT_EQ(found.steps, 7);
  EXPECT_EQ(found.energy_error, 0.25);
  EXPECT_EQ(study.seconds(0), 2.0);
  EXPECT_EQ(names_of(study.outcome(1).results), std::vector<std::string>{"drift storey 1 m"}) << "it has no x";
  EXPECT_EQ(study.outcome(1).files, other);
  EXPECT_EQ(study.state(2), CaseState::failed);
  EXPECT_EQ(study.outcome(2).reason, "no");
  EXPECT_EQ(study.outcome(2).files, north);
  EXPECT_TRUE(study.outcome(2).results.empty());
  EXPECT_EQ(study.state(3), CaseState::open);
  EXPECT_TRUE(study.outcome(3).files.empty());
}

// Threads end in any order; a table does not depend on it, nor on the places of results in their cases.
TEST(StudyResults, HaveTheColumnsOfTheCasesInTheirOrder) {
  const std::vector<StudyRecord> results{{{"x", "", "1", 0.0}, {"y", "", "1", 10.0}},
                                         {{"y", "", "1", 11.0}, {"z", "", "1", 21.0}, {"x", "", "1", 1.0}},
                                         {{"w", "", "1", 32.0}, {"x", "", "m", 2.0}},
                                         {{"x", "", "1", 3.0}, {"y", "", "1", 13.0}}};
  for (const std::vector<std::size_t>& order :
       std::vector<std::vector<std::size_t>>{{0, 1, 2, 3}, {3, 2, 1, 0}, {2, 0, 3, 1}, {1, 3, 0, 2}}) {
    StudyResult study{four};
    for (const std::size_t number : order) study.set(number, done(results[number]));
    EXPECT_EQ(results_of(study.table()), (std::vector<std::string>{"x  1", "y  1", "z  1", "w  1", "x  m"}));
    for (std::size_t number = 0; number < 4; ++number) {
      const StudyRecord found = study.outcome(number).results;
      ASSERT_EQ(names_of(found), names_of(results[number]));
      for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].value, results[number][i].value);
    }
    EXPECT_EQ(study.table().columns[3].values[1], 21.0);
    EXPECT_TRUE(std::isnan(study.table().columns[3].values[0]));
  }
}

// The file is written in parts.
TEST_F(StudyResultsInFile, HaveALineForEveryCase) {
  constexpr int count = 2500;
  StudyResult study{StudyCases{{.name = "gap", .unit = "cm", .values = linearly_spaced(1.0, count, count)},
                               StudyAxis::of_names("record", {"a"})}};
  for (std::size_t number = 0; number < count; ++number)
    study.set(number, number == 1000 ? CaseOutcome{.state = CaseState::failed, .reason = "no"}
                                     : done({{"x", "", "1", 0.5 * static_cast<double>(number)}}));
  write_csv(study, folder / "study.csv");
  std::ifstream file{folder / "study.csv"};
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "case [1],gap [cm],record,state,reason,steps [1],energy_error [1],seconds [s],x [1]");
  for (std::size_t number = 0; number < count; ++number) {
    ASSERT_TRUE(std::getline(file, line)) << number;
    const std::string x = std::to_string(number / 2) + (number % 2 == 0 ? "" : ".5");
    const std::string expected = std::to_string(number) + "," + std::to_string(number + 1) + ",a,";
    EXPECT_EQ(line, expected + (number == 1000 ? "failed,no,0,nan,0,nan" : "done,,0,nan,0," + x));
  }
  EXPECT_FALSE(std::getline(file, line));
}

TEST(StudyResults, KeepNothingOfAFormerOutcome) {
  StudyResult study{four};
  study.set(0, done({{"x", "", "1", 1.0}, {"y", "", "1", 2.0}}));
  const StudyResult before = study;
  study.set(0, done({{"y", "", "1", 3.0}}));
  EXPECT_TRUE(std::isnan(study.values("x", "")[0]));
  EXPECT_EQ(study.values("y", "")[0], 3.0);
  EXPECT_EQ(before.values("x", "")[0], 1.0) << "a copy made before";
  EXPECT_EQ(before.values("y", "")[0], 2.0);
}

}  // namespace
}  // namespace moat
