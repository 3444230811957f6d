#include "output/files/peak_table.hpp"

#include <gtest/gtest.h>

namespace moat {
namespace {

TEST(PeakTable, WritesAMomentInThousands) {
  CaseResult result;
  result.peaks = {{"overturning_moment", "base", 2.5e6, "N m", 1.0}};
  EXPECT_EQ(peak_table(result).find("peak overturning moment [kN m]\n  base  2500"), 0U) << peak_table(result);
}

TEST(PeakTable, GroupsByQuantityInEngineeringUnits) {
  CaseResult result;
  result.peaks = {{"displacement", "base", -0.1234567, "m", 4.5},
                  {"absolute_acceleration", "floor 5", 12.5, "m/s^2", 12.25},
                  {"displacement", "floor 5", 0.05, "m", 14.5},
                  {"impact_force", "moat left", 25.65e6, "N", 4.25}};
  EXPECT_EQ(peak_table(result),
            "peak displacement [cm]\n"
            "  base       -12.35   at  4.500 s\n"
            "  floor 5      5.00   at 14.500 s\n"
            "peak absolute acceleration [m/s^2]\n"
            "  floor 5     12.50   1.275 g   at 12.250 s\n"
            "peak impact force [kN]\n"
            "  moat left   25650   at  4.250 s\n");
  EXPECT_EQ(peak_table(CaseResult{}), "");
}

TEST(PeakTable, GivesEveryValueTheDigitsThatItsErrorLeaves) {
  CaseResult result;
  result.peaks = {{"displacement", "base", 0.532812, "m", 4.5, 0.000151},
                  {"displacement", "floor 1", 0.532812, "m", 14.5, 0.0031},
                  {"displacement", "floor 2", 0.532812, "m", 14.5, 0.0000036},
                  {"displacement", "floor 3", 0.532812, "m", 4.5},
                  {"impact_force", "moat left", 25.6512e6, "N", 4.25, 33e3},
                  {"impact_force", "moat right", 0.0, "N", 0.0, 0.0}};
  EXPECT_EQ(peak_table(result),
            "peak displacement [cm], +- numerical error\n"
            "  base       53.28 +- 0.016    at  4.500 s\n"
            "  floor 1    53.3  +- 0.4      at 14.500 s\n"
            "  floor 2    53.28 +- 0.0004   at 14.500 s\n"
            "  floor 3    53.28             at  4.500 s\n"
            "peak impact force [kN], +- numerical error\n"
            "  moat left  25650 +- 40       at  4.250 s\n")
      << "a gap that stayed open has no row";
}

TEST(PeakTable, NamesTheElementThatReachedThePeakOfSeveral) {
  CaseResult result;
  result.peaks = {{"displacement", "base", -0.5, "m", 4.5, 0.0, "left"},
                  {"impact_force", "moat", 25.65e6, "N", 4.25, 0.0, "moat right"}};
  EXPECT_EQ(peak_table(result),
            "peak displacement [cm], +- numerical error\n"
            "  base  -50.00 +- 0   at 4.500 s\n"
            "peak impact force [kN], +- numerical error\n"
            "  moat   25650 +- 0   at 4.250 s   moat right\n");
}

TEST(PeakTable, ShowsTheLargestAndTheSmallestOfManyPlaces) {
  CaseResult result;
  for (int floor = 1; floor <= 12; ++floor)
    result.peaks.push_back({"drift", "storey " + std::to_string(floor), 0.01 * floor, "m", 1.0});
  EXPECT_EQ(peak_table(result).find("of 12"), std::string::npos);
  result.peaks.push_back({"drift", "storey 13", -0.5, "m", 2.0});
  result.peaks.push_back({"displacement", "base", 0.25, "m", 3.0});
  EXPECT_EQ(peak_table(result),
            "peak drift [cm]\n"
            "  storey 13 (largest of 13)  -50.00   at 2.000 s\n"
            "  storey 1 (smallest of 13)    1.00   at 1.000 s\n"
            "peak displacement [cm]\n"
            "  base                        25.00   at 3.000 s\n");
}

TEST(PeakTable, LeavesOutWhatNeverChanges) {
  CaseResult result;
  result.peaks = {{"displacement", "base", 0.25, "m", 3.0}, {"friction_coefficient", "bearings", 0.05, "1", 0.0}};
  EXPECT_NE(peak_table(result).find("friction"), std::string::npos);
  result.histories.columns = {{"friction_coefficient", "bearings", "1", {0.05, 0.05}}};
  EXPECT_EQ(peak_table(result), "peak displacement [cm]\n  base  25.00   at 3.000 s\n");
}

TEST(TableAtTheEnd, ShowsIsolators) {
  EXPECT_EQ(table_at_the_end({}), "");
  EXPECT_EQ(table_at_the_end({{"isolator_deformation_at_the_end", "bearings", -0.0123, "m", 21.4}}),
            "isolator deformation at the end [cm]\n  bearings  -1.230   at 21.400 s\n");
}

TEST(ClearanceTable, ShowsTheLargestAndTheSmallestOfManyGaps) {
  CaseResult result;
  for (int gap = 1; gap <= 13; ++gap)
    result.clearances.push_back({"gap " + std::to_string(gap), 0.5, gap == 7 ? -0.02 : 0.01 * gap, 1.0});
  EXPECT_EQ(clearance_table(result),
            "clearance left [cm]\n"
            "  gap 13 (largest of 13)  13.00   at 1.000 s   of 50 cm\n"
            "  gap 7 (smallest of 13)  -2.00   at 1.000 s   of 50 cm\n");
}

TEST(ClearanceTable, SaysHowMuchWasLeft) {
  CaseResult result;
  EXPECT_EQ(clearance_table(result), "");
  result.clearances = {{"moat left", 0.5, 0.20187, 3.25, 0.0021}, {"moat right", 0.1, -0.0123, 4.5, 0.00004}};
  EXPECT_EQ(clearance_table(result),
            "clearance left [cm], +- numerical error\n"
            "  moat left   20.2  +- 0.3     at 3.250 s   of 50 cm\n"
            "  moat right  -1.23 +- 0.004   at 4.500 s   of 10 cm\n");
}

}  // namespace
}  // namespace moat
