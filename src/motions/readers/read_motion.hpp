// A ground motion from a file of any known format.
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
  /// `problem` names the file; `advice` says how a script gives the unit.
  MissingUnit(const std::string& problem, const std::string& advice)
      : InputError{problem + " " + advice}, problem_{problem} {}
  /// The message without its advice, for programs whose users give the unit in another way.
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  std::string problem_;
};

/// Reads a file in the format of PEER (parse_peer_at2), COSMOS (parse_cosmos) or ESM (parse_esm), or two columns of
/// time and acceleration (parse_two_columns).
///
/// The content decides: the header of a format makes it that format. Without one, a file whose name ends in .AT2 is
/// still taken as AT2 unless it begins with two numbers, because columns without a header are in circulation under that
/// name.
///
/// A record that says that it is vertical gets a note, and cases that it shakes a warning.
///
/// unit: of the acceleration column; needed for two columns, otherwise MissingUnit. The other formats state their unit
/// themselves; giving another one there is an InputError. Throws FileError as the reader of the format does.
GroundMotion read_motion(const std::filesystem::path& path, std::optional<Acceleration> unit = {});

/// In the note of a vertical record.
inline constexpr const char* vertical_record = " is a vertical record: ";

/// The formats that read_motion reads, for help texts.
std::string motion_formats();

}  // namespace moat
