// Tables of peaks and clearances.
#pragma once

#include <string>

#include "output/files/case_result.hpp"

namespace moat::html {

/// Rows of one quantity that are shown; of more places those with the largest values.
inline constexpr std::size_t most_places = 40;

/// A table for each quantity, side by side where there is room, with errors and the method behind them.
std::string peak_section(const CaseResult& result);

/// The smallest opening of every gap; empty without gaps.
std::string clearance_section(const CaseResult& result);

/// The deformation of every isolator at the end; empty without isolators.
std::string section_at_the_end(const CaseResult& result);

}  // namespace moat::html
