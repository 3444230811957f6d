// When files changed.
#pragma once

#include <filesystem>

namespace moat::launcher {

/// Whether the contents or the name of a file changed after those of another, or the other does not exist.
///
/// Unlike the time of writing this time cannot be set back: a file that was copied, moved or unpacked with an old date
/// counts as new.
bool changed_after(const std::filesystem::path& file, const std::filesystem::path& other);

/// Whether a file or folder changed at the instant at which `stamp` was written or later, or there is no stamp.
bool changed_since_written(const std::filesystem::path& file, const std::filesystem::path& stamp);

}  // namespace moat::launcher
