// The quantities that a model reports, with their names.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_set>

namespace moat {

/// One reported quantity. Its list has the names.
struct Channel {
  std::string_view quantity;  ///< "displacement", "absolute_acceleration", "drift", "storey_shear", ...
  std::string_view where;     ///< node, element or report: "base", "moat left"
  std::string_view place;     ///< where its peak is listed: "moat" for "moat left"
  std::string_view unit;      ///< SI
  bool of_gap = false;        ///< Whether a gap reports it, whose sign is no side.
};

/// A list of channels that has every name once: strings of their own would take most of the memory of a large model.
class ChannelList {
 public:
  ChannelList() = default;
  ChannelList(const ChannelList&) = delete;
  ChannelList& operator=(const ChannelList&) = delete;

  /// Appends a channel.
  void add(std::string_view quantity, std::string_view where, std::string_view place, std::string_view unit,
           bool of_gap = false) {
    channels_.push_back({kept(quantity), kept(where), kept(place), kept(unit), of_gap});
  }
  [[nodiscard]] std::size_t size() const { return channels_.size(); }              ///< Number of channels.
  [[nodiscard]] const std::deque<Channel>& channels() const { return channels_; }  ///< In the order of add().

 private:
  std::string_view kept(std::string_view name) { return *names_.insert(std::string{name}).first; }

  std::deque<Channel> channels_;
  std::unordered_set<std::string> names_;  // they do not move when others are added
};

}  // namespace moat
