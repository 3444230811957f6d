// Peaks of the paper's building under recorded motions against those of an independent program.
//
// benchmarks/paper/reference_peaks.csv says how they were computed. The records are not part of moat: the
// environment variable MOAT_RECORDS names a folder with them.

#include <gtest/gtest.h>

#include <string>

#include "analyses/case/case_run.hpp"
#include "motions/readers/read_motion.hpp"
#include "paper_building.hpp"
#include "reference_rows.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

// The accuracy required of a step; 0 s: moat's default.
struct Precision {
  Time step;
  double tolerance;
};

class ReferencePeaks : public OnReferenceRecords {
 protected:
  CaseResult run(const Model& model, Time step) const {
    return run_case(model, *motion_, {.transient = {.step = step}});
  }

  static void expect(const Row& row, const std::string& column, double unit, double computed, double tolerance) {
    const auto cell = row.find(column);
    ASSERT_NE(cell, row.end()) << column;
    const double expected = std::stod(cell->second) * unit;
    EXPECT_NEAR(computed, expected, tolerance * expected) << column;
  }

  static void expect_isolated(const CaseResult& result, const Row& row, double tolerance) {
    expect(row, "base_displacement_cm", 0.01, peak(result, "displacement", "base"), tolerance);
    expect(row, "top_displacement_cm", 0.01, peak(result, "displacement", "floor 5"), tolerance);
    expect(row, "base_acceleration_m_s2", 1.0, peak(result, "absolute_acceleration", "base"), tolerance);
    expect(row, "top_acceleration_m_s2", 1.0, peak(result, "absolute_acceleration", "floor 5"), tolerance);
    expect(row, "isolator_force_kN", 1e3, peak(result, "isolator_force", "bearings"), tolerance);
    expect(row, "first_storey_shear_kN", 1e3, peak(result, "storey_shear", "storey 1"), tolerance);
    expect(row, "total_base_shear_kN", 1e3, peak(result, "total_base_shear", "base"), tolerance);
    expect(row, "sum_of_floor_inertia_maxima_kN", 1e3, peak(result, "sum_of_floor_inertia_maxima", "base"), tolerance);
    expect(row, "largest_drift_cm", 0.01, largest(result, "drift"), tolerance);
  }
};

TEST_P(ReferencePeaks, HertzDamp) {
  const Row row = reference_row(record(), "hertz_damp");
  for (const Precision& options : {Precision{1.25 * ms, 0.002}, Precision{2.5 * ms, 0.01}, Precision{0 * s, 5e-5}}) {
    SCOPED_TRACE("step " + std::to_string(options.step.si()) + " s (0: default)");
    Model model = pounding_building();
    const CaseResult result = run(model, options.step);
    expect_isolated(result, row, options.tolerance);
    expect(row, "impact_force_kN", 1e3, peak(result, "impact_force", "moat"), options.tolerance);
    ASSERT_EQ(static_cast<int>(result.impacts.size()), std::stoi(row.at("impacts")));
    expect(row, "first_approach_speed_m_s", 1.0, result.impacts.front().approach_speed, options.tolerance);
  }
}

// Contacts ten times stiffer, and more dissipative ones: defaults against a tight run, which has no error to speak of.
TEST_P(ReferencePeaks, OtherContacts) {
  struct Contact {
    double stiffness, restitution;  // times that of the paper's building
  };
  for (const Contact& contact : {Contact{1.0, 0.65}, Contact{10.0, 0.65}, Contact{1.0, 0.4}, Contact{10.0, 0.4}}) {
    SCOPED_TRACE(contact.stiffness);
    SCOPED_TRACE(contact.restitution);
    HertzDamp law = paper_hertz_damp();
    law.stiffness = contact.stiffness * law.stiffness.value();
    law.restitution = contact.restitution;
    Model model;
    add(model, Moat<HertzDamp>{.around = add(model, paper_building()).base, .clearance = 10 * cm, .law = law});
    const CaseResult tight =
        run_case(model, *motion_,
                 {.transient = {.tolerance = 1e-8, .steps_per_contact = 2048}, .error_bars = ErrorBarMode::never});
    const CaseResult defaults = run(model, 0 * s);
    ASSERT_EQ(defaults.impacts.size(), tight.impacts.size());
    for (std::size_t i = 0; i < tight.peaks.size(); ++i)
      EXPECT_NEAR(defaults.peaks[i].magnitude(), tight.peaks[i].magnitude(), 5e-5 * tight.peaks[i].magnitude())
          << tight.peaks[i].quantity << " " << tight.peaks[i].where;
  }
}

INSTANTIATE_TEST_SUITE_P(Records, ReferencePeaks,
                         ::testing::Values("RSN1161_KOCAELI_GBZ000", "RSN982_NORTHR_JEN022", "RSN803_LOMAP_WVC270"),
                         [](const auto& record) { return std::string{record.param}; });

}  // namespace
}  // namespace moat
