// One parameter of the building varied under several ground motions, as in Figs. 7 to 11.
#pragma once

#include <moat.hpp>

#include <functional>
#include <string>
#include <vector>

#include "paper/exhibit.hpp"

namespace moat::paper {

struct Sweep {
  std::string name;   ///< of figure and table of numbers: "fig7"
  std::string title;  ///< "isolation period"
  StudyAxis axis;
  std::string x_label;  ///< with unit
  bool logarithmic = false;
  /// Adds the building of one case to an empty model, with floors 1 to `storeys`.
  std::function<Building(Model&, const StudyCase&)> build;
  std::string caption;
};

/// Peaks of a sweep, by axis and record.
struct SweepResult {
  std::vector<double> x;
  std::vector<std::string> labels;  ///< of the motions
  StudyResult study;

  /// One curve in SI units: "top_acceleration", "base_acceleration", "largest_drift", "first_storey_drift",
  /// "base_displacement", "impact_force", "isolator_force", "total_base_shear", "first_storey_shear",
  /// "sum_of_floor_inertia_maxima" or "impacts".
  [[nodiscard]] std::vector<double> curve(const std::string& response, std::size_t motion) const {
    return study.values(response, "", {{"record", motion}});
  }
};

/// Computes all cases and shows six responses over the axis, a curve for every motion.
SweepResult run_sweep(Exhibit& exhibit, const Sweep& sweep, const std::vector<GroundMotion>& motions,
                      const std::vector<std::string>& labels);

/// `count` values, or five of them where the exhibit is coarse.
int points(const Exhibit& exhibit, int count);

// The numbers that decide statements about curves.

/// Spearman's rank correlation of two sequences: 1 if y always grows with x, -1 if it always falls.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);
/// Largest over smallest value.
double spread(const std::vector<double>& y);
/// Position of the smallest value.
std::size_t position_of_minimum(const std::vector<double>& y);
std::size_t position_of_maximum(const std::vector<double>& y);

/// The result of a claim for one motion: whether it holds, and the number that decides.
struct Answer {
  bool holds;
  std::string number;
};

/// A statement of the paper about a response, with our criterion.
struct Claim {
  std::string source, text, criterion, response;
};

/// Adds a finding: it holds if the answer of the response's curve does for all motions, partly if for some.
void judge(Exhibit& exhibit, const SweepResult& result, const Claim& claim,
           const std::function<Answer(const std::vector<double>& y)>& answer);
/// Adds such a finding where an answer needs several curves of a motion; the response is not used.
void judge_motions(Exhibit& exhibit, const SweepResult& result, const Claim& claim,
                   const std::function<Answer(std::size_t motion)>& answer);

}  // namespace moat::paper
