// Numbers that a document quotes from the tables of another one, and defaults that it says.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/text/number_format.hpp"
#include "in_folder.hpp"
#include "moat.hpp"

namespace moat::testing {
namespace {

using namespace units;

// A page as one line.
std::string page(const std::string& name) {
  return std::regex_replace(read_file(MOAT_SOURCE_DIR "/" + name), std::regex{"\\s+"}, " ");
}

void expect_on(const std::string& name, const std::string& text) {
  EXPECT_NE(page(name).find(text), std::string::npos) << name << " does not say: " << text;
}

using Numbers = std::vector<double>;

// Returns the numbers in the groups of a pattern, wherever it stands on the page.
Numbers numbers(const std::string& name, const std::string& pattern) {
  const std::string text = read_file(MOAT_SOURCE_DIR "/" + name);
  const std::regex regex{pattern};
  Numbers found;
  for (std::sregex_iterator each{text.begin(), text.end(), regex}, end; each != end; ++each)
    for (std::size_t group = 1; group < each->size(); ++group) found.push_back(std::stod((*each)[group]));
  if (found.empty()) throw std::runtime_error{name + " has no " + pattern};
  return found;
}

std::string times(int count, const std::string& text) { return count == 0 ? "" : text + times(count - 1, text); }

// Returns the numbers at equal steps.
Numbers every(std::size_t step, std::size_t first, const Numbers& all) {
  Numbers some;
  for (std::size_t i = first; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

Numbers quotients(const Numbers& above, const Numbers& below) {
  Numbers ratios;
  for (std::size_t i = 0; i < below.size(); ++i) ratios.push_back(above.at(i) / below[i]);
  return ratios;
}

// Returns the largest distance from 1, in %.
double percent_off(const Numbers& ratios) {
  double largest = 0.0;
  for (const double ratio : ratios) largest = std::max(largest, 100.0 * std::abs(ratio - 1.0));
  return largest;
}

std::string range(const Numbers& all, int of_least = 0, int of_largest = 0) {
  const auto [least, largest] = std::ranges::minmax(all);
  return to_fixed(least, of_least) + " to " + to_fixed(largest, of_largest);
}

const std::string paper = "docs/verification/paper.md", random_models = "docs/verification/random_models.md",
                  experiments = "docs/verification/experiments.md", performance = "docs/performance.md",
                  verification = "docs/verification.md";

TEST(Documents, QuoteTheNumbersOfThePaper) {
  const std::string law = to_fixed(std::ranges::max(numbers(paper, R"(\| (0\.\d{4}) \| \w+, RSN)")), 4);
  expect_on("README.md", "| 240 peaks | " + law + " % |");
  expect_on(verification, "| " + law + " % | `MOAT_RECORDS");
  const std::string ratios = times(5, R"( [\d.]+ / [\d.]+ = ([\d.]+) \|)");
  const double off = percent_off(numbers(paper, R"(\n\| \w+ displacement \[cm\] \|)" + ratios));
  expect_on("README.md", "displacements agree within " + to_fixed(std::ceil(off), 0) + " %");
  Numbers below;
  for (const double ratio : numbers(paper, R"(\n\| \w+ acceleration \[m/s²\] \|)" + ratios))
    below.push_back(100.0 * (1.0 - ratio));
  expect_on(verification, "Accelerations stay " + range(below) + " % below");
  const Numbers claims = numbers(paper, R"(Of (\d+) claims, (\d+) hold, (\d+) hold in part[^,]*, and (\d+) do not)");
  EXPECT_EQ(claims[0], claims[1] + claims[2] + claims[3]);
}

TEST(Documents, QuoteTheNumbersOfRandomModels) {
  const auto number = [](const std::string& pattern) { return numbers(random_models, pattern).front(); };
  const std::string largest = to_fixed(number(R"(\n\| largest \| ([\d.]+) %)"), 2),
                    median = to_fixed(number(R"(worst peak: median \| ([\d.]+) %)"), 4);
  expect_on("README.md", largest + " % of a model's worst peak, " + median + " % in the median");
  expect_on(verification, largest + " %; median " + median + " %");
  std::string bars = to_fixed(number(R"(with an error bar \| (\d+) \|)") / 1e3, 3);
  std::ranges::replace(bars, '.', ',');
  const double within = number(R"(true error within the bar \| ([\d.]+) %)");
  expect_on(verification, "| " + bars + " peaks | " + to_fixed(100.0 - within, 1) + " % of the bars are too small");
  expect_on("docs/reference/analysis.md", "bars of " + to_fixed(number(R"(models compared \| (\d+))"), 0) +
                                              " random models " + to_fixed(within, 1) + " % hold the true error");
  const std::string streets = R"(\n\| largest \|)" + times(3, R"( ([\d.]+) % \|)") + R"(\n\| rebounds)",
                    laws = R"(\n\| `\w+` \| \d+ \| \d+ \| [\d.]+ % \| ([\d.]+) % \|)";
  expect_on(verification, to_fixed(std::ranges::max(numbers(random_models, streets)), 1) + " % of a peak; " +
                              to_fixed(std::ranges::max(numbers(random_models, laws)), 1) + " % with other laws");
}

TEST(Documents, QuoteTheNumbersOfExperiments) {
  const std::string peaks = to_fixed(numbers(experiments, R"(difference of all peaks: ([\d.]+) %)").front(), 4);
  expect_on("README.md", "| 42 peaks | " + peaks + " % |");
  expect_on(verification, "42 peaks | " + peaks + " % |");
  const std::string ratio = R"( \| [\d.]+ \| [\d.]+ \| ([\d.]+) \|)";
  expect_on("README.md", to_fixed(percent_off(numbers(experiments, R"(\n\| fpgm\w+ \| \w+)" + ratio)), 1) + " %; " +
                             to_fixed(percent_off(numbers(experiments, R"(\n\| fpgm\w+ \| predicted)" + ratio)), 1) +
                             " % in the tests that were predicted");
  const Numbers drifts = numbers(experiments, R"(\n\| fbgm\w+ \| predicted \| ([\d.]+), ([\d.]+), ([\d.]+) \|)");
  expect_on(verification, "wrong by up to " + to_fixed(percent_off(drifts), 0) + " %");
}

TEST(Documents, QuoteTheNumbersOfPerformance) {
  // A row has eight cells with three numbers: the time, and the errors of the loosest and the tightest setting.
  const std::string cells = times(8, R"( ([\d.]+(?:e\+\d+)?) \(([\d.]+) % \.\.\. ([\d.]+) %\) \|)") + "\n";
  const Numbers moat = numbers(performance, R"(\n\| moat \|)" + cells);
  expect_on("README.md", "takes " + range(every(3, 0, moat)) + " ms");
  expect_on(performance, "right to " + range(every(3, 1, moat), 4, 3) + " %");
  expect_on("README.md", range(numbers(performance, R"(\n\| moat adaptive, everything a script records \|)" +
                                                        times(4, R"( ([\d.]+) \|)"))) +
                             " ms with all that a script records");
  const Numbers five_storeys =
      numbers(performance, R"(\n\| \w+, [\w-]+ contact \| ([\d.]+) \([^)]+\) \| ([\d.]+) \([^)]+\))");
  expect_on("README.md", "takes " + range(every(2, 1, five_storeys)) +
                             " times as long as the first, its textbook setting " + range(every(2, 0, five_storeys)) +
                             " times");
  const Numbers best =
      numbers(performance, R"(\n\| [^|\n]+ \| [\d.]+ \([^)]+\) \| ([\d.]+) \([^)]+\) \| [^|\n]+ \| moat)");
  expect_on(verification, "takes " + range(best, 1) + " times");
  const Numbers exact = every(3, 0, numbers(performance, R"(\n\| moat, `--integrator automatic` \|)" + cells));
  const Numbers newmark = every(3, 0, numbers(performance, R"(\n\| OpenSees, Newmark, [^|\n]+ \|)" + cells)),
                sixth = every(3, 0, numbers(performance, R"(\n\| OpenSees, Newmark with [^|\n]+ \|)" + cells)),
                explicit_steps =
                    every(3, 0, numbers(performance, R"(\n\| OpenSees, NewmarkExplicit[^|\n]+ \|)" + cells));
  Numbers fastest;
  for (std::size_t i = 0; i < exact.size(); ++i)
    fastest.push_back(std::min({newmark.at(i), sixth.at(i), explicit_steps.at(i)}));
  expect_on(performance, range(quotients(fastest, exact)) + " times less than the best");
  expect_on(performance, range(quotients(newmark, exact)) + " times less than the textbook's");
}

struct Default {
  const char *page, *says;
  bool holds;
};

TEST(Documents, SayTheDefaultsOfTheLibrary) {
  const TransientOptions options;
  const NearFaultPulse pulse;
  const std::string formats = motion_formats();
  const double return_time = wave_return_time({.length = 20 * m, .width = 20 * m, .thickness = 50 * cm}).si();
  const double wall =
      FlexibleWall::from_geometry({.height = 2 * m, .thickness = 50 * cm, .width = 20 * m, .youngs_modulus = 30 * GPa})
          .stiffness.si();
  const Default defaults[]{
      {"docs/reference/analysis.md", "| `tolerance` | 3e-5 |", options.tolerance == 3e-5},
      {"docs/reference/analysis.md", "| `steps_per_contact` | 32 |", options.steps_per_contact == 32},
      {"docs/reference/analysis.md", "| `max_halvings` | 24 |", options.max_halvings == 24},
      {"docs/reference/analysis.md", "| `location_tolerance` | 1e-12 m |", options.location_tolerance.si() == 1e-12},
      {"docs/reference/analysis.md", "| `force_tolerance` | 1e-8 |", options.force_tolerance == 1e-8},
      {"docs/reference/analysis.md", "| `max_iterations`, `max_cuts` | 20, 12 |", options.max_iterations == 20},
      {"docs/reference/analysis.md", "| `max_iterations`, `max_cuts` | 20, 12 |", options.max_cuts == 12},
      {"docs/reference/analysis.md", "| `max_events_per_second` | 10000 |", options.max_events_per_second == 10000},
      {"docs/reference/analysis.md", "at most 16 degrees of freedom", Automatic::most_degrees_of_freedom == 16},
      {"docs/how-to/records.md", "| `pulse_period` | 1.3 s |", pulse.pulse_period == 1.3 * s},
      {"docs/how-to/records.md", "| `amplitude` | 0.8 m/s |", pulse.amplitude == 0.8 * (m / s)},
      {"docs/how-to/records.md", "| `oscillation_ratio` | 2 |", pulse.oscillation_ratio == 2.0},
      {"docs/how-to/records.md", "| `phase` | pi/4 |", pulse.phase == pi / 4},
      {"docs/how-to/records.md", "| `time_step` | 5 ms |", pulse.time_step == 0.005 * s},
      {"docs/how-to/records.md", "| `lead_in`, `quiet_after` | 1.4 s, 16 s |", pulse.lead_in == 1.4 * s},
      {"docs/how-to/records.md", "| `lead_in`, `quiet_after` | 1.4 s, 16 s |", pulse.quiet_after == 16.0 * s},
      {"docs/how-to/studies.md", "(`GapSearch::largest`, 10 m)", GapSearch{}.largest == 10 * m},
      {"docs/how-to/floor_spectra.md", "with 5 % damping", FloorSpectraOptions{}.dampings == std::vector{0.05}},
      {"docs/how-to/contact_stiffness_and_restitution.md", "0.65 for concrete",
       restitution_of(Faces::concrete) == 0.65},
      {"docs/how-to/contact_stiffness_and_restitution.md", "0.6 for steel", restitution_of(Faces::steel) == 0.6},
      {"docs/how-to/contact_stiffness_and_restitution.md", "0.2 for a corner",
       restitution_of(Faces::crushed_corner) == 0.2},
      {"docs/how-to/contact_stiffness_and_restitution.md", "20 x 2 x 0.5 m: 2.3e9 N/m", std::abs(wall - 2.3e9) < 5e7},
      {"docs/explanation/limits.md", "(35 ms for 20 m of concrete)", std::abs(3.0 * return_time - 0.035) < 5e-4},
      {"README.md", "records of twelve formats", std::ranges::count(formats, ',') == 12},
  };
  for (const Default& each : defaults) {
    expect_on(each.page, each.says);
    EXPECT_TRUE(each.holds) << each.page << ": " << each.says;
  }
}

}  // namespace
}  // namespace moat::testing
