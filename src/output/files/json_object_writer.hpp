// JSON of large results, written piece by piece.
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

namespace moat {

/// Writes an object member by member, as Json::dump(2) writes the whole: of the long lists of large models one item is
/// in memory.
class JsonObjectWriter {
 public:
  using Json = nlohmann::ordered_json;

  explicit JsonObjectWriter(std::ostream& stream, int depth = 0) : stream_{&stream}, depth_{depth} { stream << "{"; }

  void add(std::string_view name, const Json& value) {
    begin(name);
    write(value, depth_ + 1);
  }
  template <class Items, class ToJson>
  void add_list(std::string_view name, const Items& items, const ToJson& json) {
    begin(name);
    *stream_ << "[";
    bool is_first = true;
    for (const auto& each : items) {
      begin_line(std::exchange(is_first, false), depth_ + 2);
      write(json(each), depth_ + 2);
    }
    if (!is_first) begin_line(true, depth_ + 1);
    *stream_ << "]";
  }
  /// The members of the returned object come before the next ones of this.
  JsonObjectWriter add_object(std::string_view name) {
    begin(name);
    return JsonObjectWriter{*stream_, depth_ + 1};
  }
  void end() {
    begin_line(true, depth_);
    *stream_ << "}";
  }

 private:
  void begin(std::string_view name) {
    begin_line(std::exchange(is_empty_, false), depth_ + 1);
    *stream_ << Json(name) << ": ";
  }
  void begin_line(bool is_first, int depth) {
    *stream_ << (is_first ? "\n" : ",\n") << std::string(2 * static_cast<std::size_t>(depth), ' ');
  }
  void write(const Json& value, int depth) {
    // A title in another encoding must not cost the results of a run. Texts have no line ends of their own.
    const std::string text = value.dump(2, ' ', false, Json::error_handler_t::replace),
                      margin(2 * static_cast<std::size_t>(depth), ' ');
    std::string_view rest = text;
    for (std::size_t line; (line = rest.find('\n') + 1) > 0; rest.remove_prefix(line))
      *stream_ << rest.substr(0, line) << margin;
    *stream_ << rest;
  }

  std::ostream* stream_;
  int depth_;
  bool is_empty_ = true;
};

}  // namespace moat
