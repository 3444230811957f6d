// The numbers of a ground motion, as the command `moat motion` shows them.
#pragma once

#include <string>
#include <vector>

#include "motions/ground_motion.hpp"
#include "motions/motion_measures.hpp"
#include "motions/response_spectrum.hpp"
#include "output/charts/chart.hpp"
#include "output/files/table.hpp"

namespace moat {

/// A motion with its measures and its spectrum, SI units.
struct MotionSheet {
  GroundMotion motion;
  double arias_intensity = 0.0;  ///< m/s
  MotionInterval significant_duration{};
  double pulse_period = 0.0;  ///< s
  ResponseSpectrum spectrum{};
};

/// Periods of the spectrum from 0.02 to 10 s. damping_ratio: >= 0 and < 1. Throws InputError for a motion that is zero.
MotionSheet sheet_of(const GroundMotion& motion, double damping_ratio);

/// For the terminal: the measures of every motion, and one table of pseudo-accelerations.
std::string text_of(const std::vector<MotionSheet>& sheets);

/// Returns the sheets as JSON text, all numbers in SI units; with all periods.
std::string json_of(const std::vector<MotionSheet>& sheets);

/// The spectra of all motions: one chart, and one table with a column per motion.
Chart spectrum_chart(const std::vector<MotionSheet>& sheets);
Table spectrum_table(const std::vector<MotionSheet>& sheets);

}  // namespace moat
