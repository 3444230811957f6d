// Components, peaks and units as record files write them. Shared by the readers of all layouts.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "motions/readers/record_channel.hpp"

namespace moat {

/// A word for a component.
struct ComponentWord {
  bool vertical = false, down = false;  ///< Vertical, and pointing down.
  std::optional<double> azimuth{};      ///< From north clockwise, >= 0 and < 360 degrees.
};

/// The meaning of UP, DWN, V, Z, N, E, N-S, L, T, H1, 090, "360 DEG", S16W or HNE; nothing for other words.
std::optional<ComponentWord> component_word(std::string_view word);

/// The name of a file without its ending, divided at its component; the latter is empty where it has none.
struct DividedName {
  std::string station, component;  ///< Both parts; the second in capitals.
};
DividedName divided_name(const std::filesystem::path& file);

/// Takes a word for the component of the channel, if it is one. Samples that are there already are turned if it points
/// down.
bool set_component(RecordChannel& channel, std::string_view word, const std::string& source = "its header");

/// Appends values in the unit of the channel; down becomes up.
void set_samples(RecordChannel& channel, const std::vector<double>& values);

/// Takes the first number in a text, in `unit`, m/s^2, as the peak that the header states.
void state_peak(RecordChannel& channel, std::string_view text, double unit);
/// Takes a peak that is not rounded.
void state_peak(RecordChannel& channel, double peak, double unit);

/// Adds the warnings about peak and mean.
void check_samples(RecordChannel& channel);

}  // namespace moat
