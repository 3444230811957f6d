// How peaks move when contacts change, as text.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/files/case_result.hpp"

namespace moat {

/// "k/3", "3k", "e-.1", "e+.1", "gap-10%", "gap+10%", "soil/1.6", "1.6soil".
std::string label_of(const ContactVariation& variation);

/// "displacement, base"; an absolute acceleration is called acceleration.
std::string name_of(const ChangedPeak& peak);

/// The peaks that readers compare: of displacements, accelerations, drifts, storey shears, and forces of impacts and
/// walls the largest of each quantity. All others stand in summary.json.
std::vector<ChangedPeak> largest_changed_peaks(const ContactSensitivity& sensitivity);

/// The change of the magnitude of a peak over the nominal one. Zero where it is below three times the numerical error
/// of the peak; nothing where the nominal peak is zero, where the changed one is (a contact that vanished), or where it
/// is not known.
std::optional<double> relative_change(const ChangedPeak& peak, std::size_t change);

/// Sentences beside the numbers: impacts that appear or vanish, with the values, a restitution that
/// reached the end of its range, walls that cannot give way, laws that cannot be changed, and runs that failed.
std::vector<std::string> sensitivity_notes(const ContactSensitivity& sensitivity);

/// One line for each of the largest peaks, a column for each change, changes in whole per cents from 0.5 % on, and the
/// number of impacts; then the notes. Where nothing was computed one line says so, and with `seconds` > 0, the time of
/// the main run, how long it would take. Empty without contacts, and where it was not wanted.
std::string sensitivity_table(const ContactSensitivity& sensitivity, double seconds);

}  // namespace moat
