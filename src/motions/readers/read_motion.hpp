// A ground motion from a file of any known format.
#pragma once

#include <filesystem>
#include <optional>

#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"
#include "motions/readers/record_channel.hpp"

namespace moat {

/// Reads the channel of a file, or of several channels the only horizontal one (read_channels() lists the formats). A
/// record that says that it is vertical gets a note, and cases that it shakes a warning.
///
/// Throws as read_channels() and check_text(), and FileError for a file with several horizontal channels: read_record()
/// takes them.
GroundMotion read_motion(const std::filesystem::path& path, const TextColumns& text);

/// unit: of plain text, which needs it; files of other formats state theirs.
///
///     const GroundMotion motion = read_motion("record.csv", 1 * g);
GroundMotion read_motion(const std::filesystem::path& path, std::optional<Acceleration> unit = {});

}  // namespace moat
