// The inputs on which the numbers of a study depend, and their changes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "study/cases.hpp"

namespace moat {

/// The inputs of the numbers of a study besides its axes, as pairs of name and value: hashes of script, program,
/// library and files, options of the script.
using StudyIdentity = std::vector<std::pair<std::string, std::string>>;

/// The identity in the order of its names, with the hashes behind the values of axes: "record KBU000".
StudyIdentity with_hashes_of_axes(const StudyIdentity& identity, const StudyCases& cases);

/// One line for each difference, empty if there is none:
///
///     script: 3f2a... -> 77b1...
std::string differences(const StudyIdentity& before, const StudyIdentity& now);

/// Differences of names, units, values and labels.
std::string differences(const StudyCases& before, const StudyCases& now);

}  // namespace moat
