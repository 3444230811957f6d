#include "output/files/csv_writer.hpp"

#include <cmath>
#include <sstream>
#include <vector>

#include "output_testing.hpp"

namespace moat {
namespace {

using testing_output::message_of;
using testing_output::read_file;

class CsvWriter : public testing_output::InFolder {};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream{text};
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

// Such a table is written in several pieces.
TEST_F(CsvWriter, KeepsEveryNumberOfALongTable) {
  for (const std::size_t rows : {0, 1, 100'000}) {
    Table table{{{"time", "", "s", {}}, {"peak", "base", "m", {}}}};
    for (std::size_t row = 0; row < rows; ++row) {
      table.columns[0].values.push_back(0.1 * static_cast<double>(row));
      table.columns[1].values.push_back(std::sin(static_cast<double>(row)));
    }
    write_csv(table, folder / "long.csv");
    std::istringstream lines{read_file(folder / "long.csv")};
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    std::size_t row = 0;
    for (; std::getline(lines, line); ++row) {
      const std::vector<std::string> parts = split(line, ',');
      ASSERT_EQ(parts.size(), 2u) << row;
      for (std::size_t i = 0; i < 2; ++i) ASSERT_EQ(std::stod(parts[i]), table.columns[i].values[row]) << row;
    }
    EXPECT_EQ(row, rows);
  }
}

TEST_F(CsvWriter, LabelsStandInPlaceOfTheirNumbers) {
  const Table table{{{"record", "", "1", {0.0, 1.0}, {"KJM000", "Erzincan, NS"}}, {"peak", "base", "m", {0.5, 0.25}}}};
  write_csv(table, folder / "study.csv");
  EXPECT_EQ(read_file(folder / "study.csv"), "record,peak [m] base\nKJM000,0.5\n\"Erzincan, NS\",0.25\n");
  EXPECT_THROW(write_csv(Table{{{"record", "", "1", {0.0, 1.0}, {"KJM000"}}}}, folder / "bad.csv"), InputError);
}

TEST_F(CsvWriter, QuotesNamesThatHoldASeparator) {
  write_csv(Table{{{"force", "gap, \"left\"", "N", {1.0}}}}, folder / "table.csv");
  EXPECT_EQ(read_file(folder / "table.csv"), "\"force [N] gap, \"\"left\"\"\"\n1\n");
}

TEST_F(CsvWriter, RefusesColumnsOfDifferentLength) {
  const Table table{{{"time", "", "s", {0.0, 1.0}}, {"drift", "storey 1", "m", {0.0}}}};
  EXPECT_EQ(message_of<InputError>([&] { write_csv(table, folder / "table.csv"); }),
            "Table: column \"drift [m] storey 1\" has 1 values, the first column has 2. Every column needs one value "
            "per row.");
}

TEST_F(CsvWriter, NamesTheFileItCannotWrite) {
  const std::filesystem::path path = folder / "missing" / "table.csv";
  const std::string message = message_of<FileError>([&] { write_csv(Table{}, path); });
  EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  EXPECT_NE(message.find("No such file or directory"), std::string::npos) << message;
}

TEST_F(CsvWriter, WritesPeaksWithTheirBuildings) {
  CaseResult result;
  result.buildings = {{.name = "north", .places = {"north base", "between"}}, {.name = "south", .places = {"between"}}};
  result.peaks = {{"displacement", "north base", -0.125, "m", 4.5, 0.25, "left"},
                  {"impact_force", "between", 2.5e6, "N", 3.0, 0.0, "between, right"},
                  {"roof_tilt", "elsewhere", 0.5, "1", 1.0}};
  write_peaks_csv(result, folder / "peaks.csv");
  EXPECT_EQ(read_file(folder / "peaks.csv"),
            "building,place,quantity,unit,value,error,time [s],side\n"
            "north,north base,displacement,m,-0.125,0.25,4.5,left\n"
            "north and south,between,impact_force,N,2500000,0,3,\"between, right\"\n"
            ",elsewhere,roof_tilt,1,0.5,,1,\n");
}

TEST_F(CsvWriter, WritesImpactsWithUnits) {
  const std::string header =
      "where,start [s],duration [s],approach_speed [m/s],largest_indentation [m],largest_force [N],rebound_ratio [1],"
      "restitution [1],energy_lost [J]\n";
  write_csv(std::vector<Impact>{}, folder / "none.csv");
  EXPECT_EQ(read_file(folder / "none.csv"), header);
  write_csv(std::vector<Impact>{{"moat left", 3.25, 0.125, 0.5, 0.0078125, 2.5e7, 0.75, 0.5, 4e5}}, folder / "one.csv");
  EXPECT_EQ(read_file(folder / "one.csv"), header + "moat left,3.25,0.125,0.5,0.0078125,2.5e+07,0.75,0.5,4e+05\n");
}

TEST_F(CsvWriter, ChecksOfBearingsSayWhyTheyAreNotJudged) {
  CaseResult result;
  write_bearing_checks_csv(result, folder / "none.csv");
  EXPECT_FALSE(std::filesystem::exists(folder / "none.csv"));
  result.bearing_checks = {
      {"bearing 1",
       "LRB, large",
       {.check = "shear strain", .unit = "1", .demand = 1.25, .capacity = 2.5, .source = "EN 15129", .time = 4.5}},
      {"bearing 1",
       "LRB, large",
       {.check = "tension", .unit = "N", .demand = 1e5, .source = "not judged: no tension_capacity", .time = 3.0}}};
  write_bearing_checks_csv(result, folder / "checks.csv");
  EXPECT_EQ(read_file(folder / "checks.csv"),
            "check,bearing,type,unit,demand,capacity,ratio,time [s],source\n"
            "shear strain,bearing 1,\"LRB, large\",1,1.25,2.5,0.5,4.5,EN 15129\n"
            "tension,bearing 1,\"LRB, large\",N,1e+05,nan,nan,3,not judged: no tension_capacity\n");
}

TEST_F(CsvWriter, FloorSpectraHaveARowForEachPeriod) {
  CaseResult result;
  write_floor_spectra_csv(result, folder / "none.csv");
  EXPECT_FALSE(std::filesystem::exists(folder / "none.csv"));
  result.floor_spectra = {
      {.floor = "base", .spectrum = {0.05, {0.5, 1.0}, {}, {4.0, 2.0}, {}}},
      {.floor = "floor 1", .corner = "corner 2", .direction = "y", .spectrum = {0.25, {0.5}, {}, {3.0}, {3.5}}}};
  write_floor_spectra_csv(result, folder / "spectra.csv");
  EXPECT_EQ(read_file(folder / "spectra.csv"),
            "floor,place,direction,damping [1],period [s],pseudo_acceleration [m/s^2],absolute_acceleration [m/s^2]\n"
            "base,centre,x,0.05,0.5,4,\n"
            "base,centre,x,0.05,1,2,\n"
            "floor 1,corner 2,y,0.25,0.5,3,3.5\n");
}

TEST_F(CsvWriter, ParticipatingMassesHaveARowForEachModeWithSums) {
  CaseResult result;
  write_participating_masses_csv(result, folder / "none.csv");
  EXPECT_FALSE(std::filesystem::exists(folder / "none.csv"));
  result.buildings = {{.name = "tower", .modes = {{1.5, 0.75, 0.0, 0.125}, {0.5, 0.125, 0.5, 0.25}}}};
  write_participating_masses_csv(result, folder / "masses.csv");
  EXPECT_EQ(read_file(folder / "masses.csv"),
            "building,mode,period [s],x [%],y [%],rotation [%],sum x [%],sum y [%],sum rotation [%]\n"
            "tower,1,1.5,75,0,12.5,75,0,12.5\n"
            "tower,2,0.5,12.5,50,25,87.5,50,37.5\n");
}

}  // namespace
}  // namespace moat
