// Components of recorded motions as the files of the networks hold them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/files_read.hpp"
#include "base/quantity.hpp"
#include "motions/ground_motion.hpp"

namespace moat {

/// How far a record has been processed; of two that are otherwise alike the higher one is used.
enum class RecordLevel { raw, uncorrected, corrected };

/// One component in a file of any network.
struct RecordChannel {
  std::string format{};               ///< "K-NET"
  FileRead file{};                    ///< Where it was read.
  std::size_t number = 1, count = 1;  ///< Place in the file, from 1, and how many the file has.
  /// The name of the file without its ending; behind it the component, if the file has several or its ending says it.
  std::string name{};
  std::string network{}, station{}, location{}, event{};  ///< Empty where the file does not say them.
  std::string component{};          ///< As the file says it: "N-S", "S16W", "360", "Up"; or empty.
  std::string source{};             ///< "its header" or "its name": where the component is said.
  std::optional<double> azimuth{};  ///< From north clockwise, >= 0 and < 360 degrees.
  bool vertical = false;            ///< Whether it is the vertical component.
  std::string unit{};               ///< In which the file holds the samples: "gal".
  double step = 0.0;                ///< s
  std::optional<double> start{};    ///< Time of the first sample, s since 1970 in UTC.
  std::vector<double> samples{};    ///< m/s^2; of a vertical component positive upwards.
  /// Whether the network has corrected it.
  RecordLevel level = RecordLevel::corrected;
  std::vector<std::string> notes{};     ///< Lines of the header.
  std::vector<std::string> warnings{};  ///< Doubts about the file.
  double stated_peak = 0.0;             ///< m/s^2, without sign; 0 where the header states none.
  double peak_digit = 0.0;              ///< One unit of the last digit of the stated peak, m/s^2.
  std::string columns{};                ///< TextColumns::columns by which plain text was read.
};

/// A file that is recognised as something else than a history of acceleration, or not recognised at all.
class NotARecord : public FileError {
 public:
  using FileError::FileError;
};

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

/// Facts that files of plain text do not say themselves.
struct TextColumns {
  /// > 0.
  std::optional<Acceleration> unit{};
  /// > 0; else from the column of times, or from words of the file such as "dt = 0.02 s" or "sampling rate 100 Hz".
  std::optional<Time> step{};
  /// "time,x", "x,y", "x,y,z", "time,x,y,z" ..., with "-" for a column that is not used, or "series": the rows continue
  /// each other. x and y are 90 degrees apart, y counter-clockwise of x; z points upwards. Empty: "time,x" for two
  /// columns of which the first is an even time, "series" for one and for 5 to 12; others must be named.
  std::string columns{};
};

/// All channels in a file. The content decides about the format: K-NET and KiK-net, AFAD, DYNA (ESM, ITACA, TADAS),
/// CWA, GeoNet, COSMOS, RENADIC, BHRC, SMC, CSMIP, UNAM, PEER AT2, else plain text (motions/readers/layouts).
///
/// Without a word about the component in the file, its name decides: a word behind -, _, . or a blank (-UP, .UD, _HNE),
/// an azimuth of three digits, or UP behind a digit or capital. Samples are as in the file, but for the mean of K-NET
/// and KiK-net, which is subtracted, and components that point down, which are turned up. A header's peak that differs
/// from that of the samples by more than 1e-3 and half a unit of its last digit, and a mean above 2 % of the peak, are
/// warnings.
///
/// Throws FileError naming file, line and mistake; NotARecord for other kinds of files; MissingUnit for plain text
/// without unit.
std::vector<RecordChannel> read_channels(const std::filesystem::path& file, const TextColumns& text = {});

/// Throws InputError where a unit, step or columns were given for a file that states others itself.
void check_text(const std::vector<RecordChannel>& channels, const TextColumns& text);

/// The motion of a channel, with its header and warnings as notes, and one that says if it is vertical.
GroundMotion motion_of(const RecordChannel& channel);

/// In the note of a vertical record.
inline constexpr const char* vertical_record = " is a vertical record: ";

/// The formats that read_channels() reads, for help texts.
std::string motion_formats();

/// m/s^2; by its name as networks write it: g, mg, gal, cm/s2, cm/sec/sec, mm/s^2, in/s2, ft/s2, g/10, m/s2 ... in
/// capitals or not; nothing for others.
std::optional<double> acceleration_unit(std::string_view name);

}  // namespace moat
