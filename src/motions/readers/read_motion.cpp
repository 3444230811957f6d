#include "motions/readers/read_motion.hpp"

#include <algorithm>
#include <new>
#include <string>

#include "base/text/text_file.hpp"

namespace moat {

GroundMotion read_motion(const std::filesystem::path& path, const TextColumns& text) try {
  const std::vector<RecordChannel> channels = read_channels(path, text);
  check_text(channels, text);
  if (channels.size() == 1) return motion_of(channels[0]);
  const auto is_horizontal = [](const RecordChannel& channel) { return !channel.vertical; };
  if (std::ranges::count_if(channels, is_horizontal) == 1)
    return motion_of(*std::ranges::find_if(channels, is_horizontal));
  std::string names;
  for (const RecordChannel& channel : channels) names += (names.empty() ? "" : ", ") + channel.component;
  refuse_file(path,
              "it holds " + std::to_string(channels.size()) + " channels, " + names +
                  ", and one is wanted. Take them together with read_record(file) or --record FILE of a model in plan, "
                  "or one of them: motion_of(read_channels(file)[0]).");
} catch (const std::bad_alloc&) {
  refuse_file(path, "the memory is too small for this record. Cut the record, or end other programs.");
}

GroundMotion read_motion(const std::filesystem::path& path, std::optional<Acceleration> unit) {
  return read_motion(path, TextColumns{.unit = unit});
}

}  // namespace moat
