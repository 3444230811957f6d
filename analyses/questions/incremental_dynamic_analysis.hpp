// Incremental dynamic analysis: the response of a structure to one record at growing intensity.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "analyses/questions/lognormal_fit.hpp"
#include "study/result.hpp"

namespace moat {

/// The response to one record, at ascending levels.
struct IdaCurve {
  std::string record;  ///< Name of the record.
  /// Intensities and largest responses, one beside the other; infinite where the model collapsed.
  std::vector<double> levels, responses;
  /// Levels whose analysis failed or did not converge. They are no points: neither safe nor collapsed.
  std::vector<double> without_solution{};
  /// Limit of a hunt: a curve whose last response is above it ended there, and counts as larger at higher levels.
  double response_limit = std::numeric_limits<double>::infinity();
};

/// One curve for every combination of the other axes of a study over fixed levels, called by their labels; the
/// responses are in the result's SI unit, and infinite in cases with a result `collapsed` > 0. Throws InputError for an
/// unknown axis or result.
std::vector<IdaCurve> ida_curves(const StudyResult& study, std::string_view level_axis, std::string_view quantity,
                                 std::string_view where);

/// How hunt_and_fill() chooses its levels, all in one unit.
struct HuntAndFill {
  double first_level = 0.1;     ///< > 0
  double first_step = 0.1;      ///< > 0, from the first level to the second
  double step_increment = 0.1;  ///< >= 0; every step is longer than the one before by so much
  /// > 0. The hunt ends with the first response above it.
  double response_limit = 0.0;
  double largest_level = 10.0;  ///< >= first_level; the hunt ends there in any case
  /// >= 0. Further levels, each in the middle of the widest distance up to the first response above the limit.
  int fill = 5;
};

/// The trace of Vamvatsikos & Cornell (2004): levels grow with growing steps until the response exceeds the limit
/// (hunt), then the widest distances below are halved (fill). response: at a level; ConvergenceError from it ends the
/// hunt there, or leaves out a level of the fill, which the curve lists. Every level depends on the responses before
/// alone, so that equal runs give equal curves. Throws InputError for a parameter outside its range.
IdaCurve hunt_and_fill(const std::function<double(double level)>& response, const HuntAndFill& options);

/// A curve as results of a case: a study over an axis of records computes one hunt in each case.
///
///     script.study({record_axis("record", records)}, [&](const StudyCase& each) {
///       return record_of(hunt_and_fill([&](double sa) { ... return value_of(peaks, "drift", "storey 1"); }, hunt));
///     });
StudyRecord record_of(const IdaCurve& curve);
/// The curves of such a study.
std::vector<IdaCurve> ida_curves(const StudyResult& hunts);

/// Responses that 16, 50 and 84 % of the records do not exceed, at one level.
struct IdaFractiles {
  double level = 0.0;  ///< Intensity.
  /// Quantiles of the response; infinite where too many records have collapsed or exceeded their limit.
  double low = 0.0, median = 0.0, high = 0.0;
  std::size_t records = 0;           ///< that have a response at this level, or exceeded their limit below it
  std::size_t without_solution = 0;  ///< whose analysis did not converge just there
};
/// At every level that any curve has, each curve interpolated between its levels. A curve that ended above its response
/// limit counts as infinite at higher levels; one that ended otherwise, or begins above the level, does not count
/// there. Fractiles are those of the empirical distribution with linear interpolation.
std::vector<IdaFractiles> ida_fractiles(const std::vector<IdaCurve>& curves);

/// The level at which each curve first exceeds a response, as an interval between its levels, for LognormalFit.
std::vector<KnownInterval> capacities(const std::vector<IdaCurve>& curves, double response);

}  // namespace moat
