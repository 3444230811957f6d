// The numbers of docs/tutorial/3_check_by_hand.md: by hand calculation, and as the first tour gives them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace moat {
namespace {

constexpr double floor_mass = 500e3, base_mass = 550e3, total_mass = 5.0 * floor_mass + base_mass;  // kg
constexpr double stiffness = 1e10, restitution = 0.65;                                              // N/m^1.5

// The page, without its line ends.
std::string page() {
  std::string text = testing::text_of(std::string{MOAT_SOURCE_DIR} + "/docs/tutorial/3_check_by_hand.md");
  std::ranges::replace(text, '\n', ' ');
  return text;
}

// The page has the text, and `value` rounds to the number at the beginning of the text.
void expect_on_page(const std::string& text, double value) {
  static const std::string all = page();
  EXPECT_NE(all.find(text), std::string::npos) << "the page does not say " << text;
  const std::string number = text.substr(0, text.find_first_not_of("0123456789."));
  const std::size_t point = number.find('.');
  const double decimals = point == std::string::npos ? 0.0 : static_cast<double>(number.size() - point - 1);
  EXPECT_NEAR(value, std::stod(number), 0.5000001 * std::pow(10.0, -decimals)) << text;
}

using Row = std::map<std::string, double>;

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream stream{line};
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

// The numbers of a table by their titles; the column "where" has none.
std::vector<Row> rows_of(const std::filesystem::path& file) {
  std::istringstream table{testing::text_of(file)};
  std::string line;
  std::getline(table, line);
  const std::vector<std::string> titles = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(table, line)) {
    const std::vector<std::string> cells = cells_of(line);
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (titles.at(i) != "where") row[titles[i]] = std::stod(cells[i]);
  }
  return rows;
}

// m dv/dt = -k d^1.5 (1 + z u) with u = v/v0 gives (d/d0)^2.5 = 2 (G(1) - G(u)), with the elastic indentation d0.
double left_at(double u, double z) { return u / z - std::log1p(z * u) / (z * z); }

double indentation_ratio(double u, double z) { return std::pow(2.0 * (left_at(1.0, z) - left_at(u, z)), 0.4); }

// The contact ends with u = -e.
double damping_of_free_impact() {
  double low = 1e-3, high = (1.0 - 1e-12) / restitution;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (left_at(1.0, middle) > left_at(-restitution, middle) ? low : high) = middle;
  }
  return low;
}

// Runs the tour once.
class HandCalculation : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    struct Tour : testing::InTemporaryFolder {
      Tour() {
        const auto run = testing::run_program(FIRST_TOUR, {"--out", "tour", "--frame-interval", "0 s"}, folder);
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        summary = nlohmann::json::parse(testing::text_of(folder / "tour/summary.json"));
        impacts = rows_of(folder / "tour/impacts.csv");
        histories = rows_of(folder / "tour/histories.csv");
      }
      void TestBody() override {}
    };
    const Tour tour;
  }
  inline static nlohmann::json summary;
  inline static std::vector<Row> impacts, histories;
};

TEST_F(HandCalculation, OfTheIsolatedBuilding) {
  const double weight = total_mass * 9.80665, after_yield = 19.3e6, strength = 1.93e6 - after_yield * 0.01;
  const double period = 2.0 * std::numbers::pi * std::sqrt(total_mass / after_yield);
  expect_on_page("3050 t", total_mass / 1e3);
  expect_on_page("29.91 MN", weight / 1e6);
  expect_on_page("2.498 s", period);
  expect_on_page("1.737 MN", strength / 1e6);
  expect_on_page("5.8 %", 100.0 * strength / weight);
  const nlohmann::json periods = summary.at("periods");
  ASSERT_EQ(periods.at(1).at("name"), "isolation, rigid building");
  EXPECT_NEAR(periods.at(1).at("value").get<double>(), period, 1e-9);
}

TEST_F(HandCalculation, OfOneImpact) {
  ASSERT_EQ(impacts.size(), 6U);
  const Row& impact = impacts[2];
  const double speed = impact.at("approach_speed [m/s]"), force = impact.at("largest_force [N]");
  expect_on_page("3.32 s", impact.at("start [s]"));
  expect_on_page("1.755 m/s", speed);
  const double deepest = std::pow(5.0 * base_mass * speed * speed / (4.0 * stiffness), 0.4);
  const double elastic = stiffness * std::pow(deepest, 1.5);
  expect_on_page("3.39 cm", 100.0 * deepest);
  expect_on_page("62.4 MN", elastic / 1e6);
  // The integral of dx/sqrt(1 - x^2.5) from 0 to 1, twice: 0.8 sqrt(pi) Gamma(0.4)/Gamma(0.9).
  const double shape = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
  expect_on_page("2.943 d / v", shape);
  expect_on_page("57 ms", 1e3 * shape * deepest / speed);

  const double z = damping_of_free_impact();
  double largest = 0.0;
  for (double u = 0.0; u <= 1.0; u += 1e-4)
    largest = std::max(largest, std::pow(indentation_ratio(u, z), 1.5) * (1.0 + z * u));
  expect_on_page("0.904", largest);
  expect_on_page("0.849", indentation_ratio(0.0, z));
  expect_on_page("56.4 MN", largest * elastic / 1e6);
  expect_on_page("2.88 cm", 100.0 * indentation_ratio(0.0, z) * deepest);

  expect_on_page("60162 +-", force / 1e3);
  expect_on_page("3.044 +-", 100.0 * impact.at("largest_indentation [m]"));
  expect_on_page("7 % more force", 100.0 * (force / (largest * elastic) - 1.0));
  expect_on_page("2500 t", 5.0 * floor_mass / 1e3);
  expect_on_page("0.29 s", impact.at("duration [s]"));
  expect_on_page("0.36 of its approach speed", impact.at("rebound_ratio [1]"));
  EXPECT_NEAR(impact.at("restitution [1]"), restitution, 1e-8);

  // The indentation has a smallest value between two larger ones.
  std::vector<double> indentation;
  for (const Row& row : histories)
    if (const double d = row.at("indentation [m] moat left"), t = row.at("time [s]") - impact.at("start [s]");
        t > 0.0 && t < impact.at("duration [s]"))
      indentation.push_back(d);
  int turns = 0;
  for (std::size_t i = 1; i + 1 < indentation.size(); ++i)
    turns += indentation[i] < indentation[i - 1] && indentation[i] < indentation[i + 1] ? 1 : 0;
  expect_on_page("2 times", turns);
}

TEST_F(HandCalculation, OfTheAcceleration) {
  const auto row =
      std::ranges::find_if(histories, [](const Row& each) { return std::abs(each.at("time [s]") - 3.34) < 1e-6; });
  ASSERT_NE(row, histories.end());
  const auto of = [&](const std::string& column) { return row->at(column); };
  const double acceleration = of("absolute_acceleration [m/s^2] base"), contact = of("impact_force [N] moat left"),
               storey = -of("storey_shear [N] storey 1"), bearings = -of("isolator_force [N] bearings");
  // The dampers at the base: that of storey 1, and those of the mass of all floors.
  double dampers = 0.0;
  const nlohmann::json elements = summary.at("model").at("elements");
  for (const auto& element : elements)
    if (element.at("law") == "Viscous" && element.at("first") == "base")
      dampers += element.at("parameters").at("damping").at("value").get<double>() *
                 (of("velocity [m/s] base") - of("velocity [m/s] " + element.at("second").get<std::string>()));
  EXPECT_NEAR(contact + bearings - storey - dampers, base_mass * acceleration, 1e-4 * contact);
  expect_on_page("59.3 MN / 550 t", contact / 1e6);
  expect_on_page("108 m/s^2", contact / base_mass);
  expect_on_page("93.8 m/s^2", acceleration);
  expect_on_page("8.9 MN", storey / 1e6);
  expect_on_page("3.0 MN", dampers / 1e6);
  expect_on_page("4.2 MN", bearings / 1e6);
  // F grows with k d^1.5 and d with k^-0.4.
  expect_on_page("1.55 times", std::pow(3.0, 0.4));
}

TEST_F(HandCalculation, OfTheEnergy) {
  ASSERT_EQ(impacts.size(), 6U);
  const double speed = impacts[2].at("approach_speed [m/s]"), kinetic = 0.5 * base_mass * speed * speed,
               share = 1.0 - restitution * restitution;
  expect_on_page("0.578 x", share);
  expect_on_page("847 kJ", kinetic / 1e3);
  expect_on_page("489 kJ", share * kinetic / 1e3);
  expect_on_page("398 kJ", impacts[2].at("energy_lost [J]") / 1e3);
  double lost = 0.0;
  for (const Row& each : impacts) lost += each.at("energy_lost [J]");
  expect_on_page("1007 kJ", lost / 1e3);
}

}  // namespace
}  // namespace moat
