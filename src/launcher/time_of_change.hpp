// When files changed.
#pragma once

#include <ctime>
#include <filesystem>

namespace moat::launcher {

/// Whether the contents or the name of a file changed after those of another, or the other does not exist.
///
/// Unlike the time of writing this time cannot be set back: a file that was copied, moved or unpacked with an old date
/// counts as new.
bool changed_after(const std::filesystem::path& file, const std::filesystem::path& other);

/// When the contents of a file were written; 0 where there is none.
timespec time_of_writing(const std::filesystem::path& file);
/// Whether a file or folder changed at this instant or later; always where it is 0.
bool changed_since(const std::filesystem::path& file, timespec instant);
/// Whether a file or folder changed at the instant at which `stamp` was written or later, or there is no stamp.
inline bool changed_since_written(const std::filesystem::path& file, const std::filesystem::path& stamp) {
  return changed_since(file, time_of_writing(stamp));
}

}  // namespace moat::launcher
