// Numbers that a document quotes from the tables of another one, and defaults that it says.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>

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

struct Quote {
  const char *page, *says, *table, *has;
};

// Where a table is written again with other numbers, the text that quotes them is found here.
TEST(Documents, QuoteTheNumbersOfTheirTables) {
  const char *paper = "docs/verification/paper.md", *random = "docs/verification/random_models.md",
             *experiments = "docs/verification/experiments.md", *performance = "docs/performance.md",
             *verification = "docs/verification.md";
  const Quote quotes[]{
      {"README.md", "| 240 peaks | 0.0009 % |", paper, "| modified Hertz-damp as printed, on approach | 0.0009 |"},
      {verification, "| 0.0009 % | `MOAT_RECORDS", paper, "| modified Hertz-damp as printed, on approach | 0.0009 |"},
      {"README.md", "0.12 % of a model's worst peak", random, "| largest | 0.12 % |"},
      {"README.md", "0.0004 % in the median", random, "worst peak: median | 0.00038 % |"},
      {verification, "0.12 %; median 0.0004 %", random, "worst peak: median | 0.00038 % |"},
      {verification, "| 10,497 peaks | 0.1 % of the bars", random, "with an error bar | 10497 |"},
      {verification, "0.1 % of the bars are too small", random, "true error within the bar | 99.9 % |"},
      {"docs/reference/analysis.md", "bars of 200 random models 99.9 %", random,
       "true error within the bar | 99.9 % |"},
      {verification, "1.1 % of a peak; 6.3 % with other laws", random, "| largest | 0.59 % | 0.71 % | 1.1 % |"},
      {verification, "1.1 % of a peak; 6.3 % with other laws", random, "| 279 | 2.5 % | 6.3 % |"},
      {"README.md", "| 42 peaks | 0.0005 % |", experiments, "Largest difference of all peaks: 0.0005 %."},
      {verification, "42 peaks | 0.0005 % |", experiments, "Largest difference of all peaks: 0.0005 %."},
      {"README.md", "12.6 %; 2.9 % in the tests that were predicted", experiments,
       "| fpgm172s1 | identifies | 0.67 | 0.75 | 1.126 |"},
      {"README.md", "12.6 %; 2.9 % in the tests that were predicted", experiments,
       "| fpgm152s2 | predicted | 2.58 | 2.50 | 0.971 |"},
      {verification, "up to 37 %", experiments, "| fbgm152s4 | predicted | 1.37,"},
      {"README.md", "displacements agree within 8 %", paper, "11.15 / 10.41 = 1.071 |"},
      {verification, "Accelerations stay 59 to 82 % below", paper, "6.05 / 14.77 = 0.410 | 4.91"},
      {verification, "Accelerations stay 59 to 82 % below", paper, "3.62 / 20.45 = 0.177 |"},
      {paper, "4 hold, 24 hold in part or for some of the records, and 9 do not", paper, "Of 37 claims"},
      {"README.md", "takes 5 to 10 ms", performance, "| moat | 4.89 ("},
      {"README.md", "takes 5 to 10 ms", performance, "| 9.9 (0.000328 % ... 0.000328 %) | 9.75 ("},
      {"README.md", "8 to 17 ms", performance, "everything a script records | 8.11 | 10.9 | 12.3 | 16.9 |"},
      {"README.md", "5 to 15 times as long", performance, "| WVC270, linear contact | 16.7 (16.3 to 16.9) | 5.01 ("},
      {"README.md", "its textbook setting 17 to 29 times", performance,
       "| pulse, Hertz-damp contact | 29.4 (29.3 to 29.5) | 15.2 ("},
      {verification, "takes 1.2 to 104 times", performance, "| rebound, Hertz-damp | 2.13 (2.02 to 2.27) | 1.17 ("},
      {verification, "takes 1.2 to 104 times", performance, "320 (320 to 322) | 104 ("},
      {performance, "right to 0.0003 to 0.007 %", performance,
       "| moat | 4.89 (0.00264 % ... 0.00264 %) | 5.02 (0.00686 %"},
      {performance, "8 to 24 times less than the best", performance,
       "3.11 (0.00215 % ... 0.00215 %) | 3.23 (0.00646 %"},
      {performance, "28 to 51 times less than the textbook's", performance, "107 (0.826 % ... 0.0127 %) | 146 (1.17 %"},
  };
  for (const Quote& quote : quotes) {
    expect_on(quote.page, quote.says);
    expect_on(quote.table, quote.has);
  }
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
