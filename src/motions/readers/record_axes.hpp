// The steps, starts and axes of channels that make one record.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motions/readers/record_table.hpp"

namespace moat {

/// The channels of one record.
using RecordGroup = std::vector<SortedChannel*>;

/// Says where the component of a channel was found: its header says "N-S", 0 deg.
std::string reason_of(const SortedChannel& channel);
/// The name of a record by its table, else its station.
std::string label_of(const SortedChannel& channel);
/// The name of the file alone.
std::string file_name_of(const SortedChannel& channel);

/// Gives all channels one step and one start, and as many samples.
void align(const SortedFiles& all, const RecordGroup& group);

/// Completes azimuths: of L and T, or H1 and H2, the second is 90 degrees clockwise of the first.
void assume_azimuths(RecordChannel& one, RecordChannel& two);

/// Takes two channels as x and y without regard to their azimuths.
void take_as_they_are(const SortedFiles& all, SortedChannel& x, SortedChannel& y, Record& record);

/// Resolves two horizontal channels of known azimuths along x and y of the record's frame.
void resolve(const SortedFiles& all, SortedChannel& one, SortedChannel& two, const std::optional<Angle>& x_azimuth,
             Record& record);

}  // namespace moat
