// Which combinations of parameters a study computes.

#include "study/cases.hpp"

#include <gtest/gtest.h>

#include <set>

#include "base/error.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using testing::message_of;

const StudyAxis gap{.name = "gap", .unit = "cm", .values = {10.0, 20.0, 40.0}};
const StudyAxis record = StudyAxis::of_names("record", {"north", "south"});
const StudyAxis law = StudyAxis::of_names("law", {"Hertz", "Kelvin"});

TEST(StudyCases, AreEveryCombinationWithTheLastAxisFastest) {
  const StudyCases cases{gap, record, law};
  ASSERT_EQ(cases.count(), 12u);
  std::set<std::string> seen;
  for (std::size_t number = 0; number < cases.count(); ++number) {
    const StudyCase each{cases, number};
    EXPECT_EQ(each.position("gap") * 4 + each.position("record") * 2 + each.position("law"), number);
    seen.insert(each.description());
  }
  EXPECT_EQ(seen.size(), 12u);
  EXPECT_TRUE(seen.contains("gap = 20 cm, record = south, law = Hertz"));
}

TEST(StudyCases, OfAListTimesAnAxisAreEachWithEach) {
  const StudyAxis mass{.name = "mass", .unit = "t", .values = {1.0, 2.0, 3.0}};
  const StudyCases cases = StudyCases{law}.times(StudyCases::list({gap, mass})).times({record});
  ASSERT_EQ(cases.count(), 12u);
  for (std::size_t number = 0; number < cases.count(); ++number) {
    const StudyCase each{cases, number};
    EXPECT_EQ(each.position("gap"), each.position("mass"));
    EXPECT_EQ(each.position("law") * 6 + each.position("mass") * 2 + each.position("record"), number);
  }
}

TEST(StudyCases, KnowTheirLabels) {
  const StudyCases cases{gap, record};
  const StudyCase last{cases, 5};
  EXPECT_EQ(last.label("record"), "south");
  EXPECT_EQ(last.label("gap"), "40");
  EXPECT_EQ(message_of<InputError>([&] { (void)last.label("mass"); }),
            "The study has no axis \"mass\". Its axes are: gap, record.");
}

TEST(StudyCases, RefuseWhatCannotBe) {
  EXPECT_NE(message_of<InputError>([] {
              (void)StudyCases::list({gap, record});
            }).find("it has 2 values, and axis \"gap\" has 3"),
            std::string::npos);
  EXPECT_NE(message_of<InputError>([] { (void)StudyCases{gap}.times({gap}); }).find("the name appears twice"),
            std::string::npos);
  StudyAxis labelled = gap;
  labelled.labels = {"one"};
  EXPECT_NE(message_of<InputError>([&] { (void)StudyCases{labelled}; }).find("numbers of labels and values differ"),
            std::string::npos);
  const StudyAxis long_axis{.name = "a", .unit = "", .values = std::vector<double>(40000, 1.0)};
  StudyAxis other = long_axis;
  other.name = "b";
  EXPECT_NE(message_of<InputError>([&] { (void)StudyCases({long_axis, other}); }).find("<= 1e9"), std::string::npos);
}

}  // namespace
}  // namespace moat
