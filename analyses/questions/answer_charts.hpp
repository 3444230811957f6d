// Pictures of the answers of studies.
#pragma once

#include <string>
#include <vector>

#include "analyses/questions/fragility.hpp"
#include "analyses/questions/incremental_dynamic_analysis.hpp"
#include "analyses/questions/smallest_gap.hpp"
#include "output/charts/chart.hpp"

namespace moat {

/// The fitted curve with its confidence band, and the shares that were counted. level_label: "Sa(2 s) [g]".
Chart fragility_chart(const LognormalFit& fit, const std::vector<EventCount>& counts, const std::string& title,
                      const std::string& level_label);

/// All curves in light blue, and the responses that 16, 50 and 84 % of the records do not exceed; response over level.
/// A curve ends where the model collapsed. per_unit: value of one unit of the response in SI, 0.01 for cm.
Chart ida_chart(const std::vector<IdaCurve>& curves, const std::string& title, const std::string& level_label,
                const std::string& response_label, double per_unit = 1.0);

/// The probability of pounding against the gap, in cm, with its confidence band, and the share of the records that
/// need more, as far as it is known. The legend says how many need more than the largest gap.
Chart pounding_chart(const GapDemand& demand, const std::string& title);

}  // namespace moat
