// A ground motion from a file of either known format.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// A file whose format does not say the unit of its accelerations.
class MissingUnit : public InputError {
 public:
  using InputError::InputError;
};

/// Reads a PEER AT2 file (see read_peer_at2) or two columns of time and acceleration (see read_two_columns).
///
/// The content decides: a PEER header makes it AT2. Without one, a file whose name ends in .AT2 is still taken as AT2
/// unless it begins with two numbers, because columns without a header are in circulation under that name.
///
/// unit: of the acceleration column; needed for two columns, otherwise MissingUnit. An AT2 file states its unit itself;
/// giving another one than g there is an InputError too.
GroundMotion read_motion(const std::filesystem::path& path, std::optional<Acceleration> unit = {});

/// The formats that read_motion reads, for help texts.
std::string motion_formats();

}  // namespace moat
