// Files that are known, and are no histories of acceleration in a unit that they state.
#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>

#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

constexpr const char* no_motion = "a response spectrum, not a motion. Take the file of accelerations";
constexpr const char* digitised = "an uncorrected, digitised record. Take the file .V2 of the same station";
constexpr const char* raw_counts = "raw counts of the recorder. Take the file V1 or V2 of the same station";

/// A kind of file: words that one of its first lines has, in capitals, and the end of the message.
struct OtherRecord {
  const char *words, *name, *advice;
};
constexpr std::array other_records{
    OtherRecord{"OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I", "USC", digitised},
    OtherRecord{"RESPONSE AND FOURIER AMPLITUDE SPECTRA", "CSMIP V3", no_motion},
    OtherRecord{"RESPONSE SPECTRA", "SMC", no_motion},
    OtherRecord{"FOURIER AMPLITUDE SPECTR", "SMC", no_motion},
    OtherRecord{"RAW ACCELERATION COUNTS", "COSMOS V0", raw_counts},
    OtherRecord{"VELOCITY TIME SERIES IN UNITS", "PEER VT2", "velocity. Take the file of accelerations, .AT2"},
    OtherRecord{"DISPLACEMENT TIME SERIES IN UNITS", "PEER DT2", "displacement. Take the file of accelerations, .AT2"},
    OtherRecord{"PSEUDO SPECTRAL ACCELERATION", "PEER PSA", no_motion},
    OtherRecord{"PSEUDO-SPECTRAL ACCELERATION", "PEER PSA", no_motion},
    OtherRecord{"CORRECTED VELOCITY", "SMC", "velocity. Take the file of accelerations"},
    OtherRecord{"CORRECTED DISPLACEMENT", "SMC", "displacement. Take the file of accelerations"},
    OtherRecord{"UNCORRECTED ACCELEROGRAM DATA", "CSMIP V1", digitised}};

}  // namespace

void refuse_other_records(const TextFile& file) {
  constexpr std::size_t lines_of_title = 4;
  LineReader lines{file};
  std::string first, title;
  for (std::string_view line; lines.line_number() < lines_of_title && lines.next(line);) {
    if (line.starts_with('#') || line.starts_with('%')) return;  // The remarks of plain text may mention anything.
    title += upper_case(line.substr(0, 200)) + "\n";
  }
  first = title.substr(0, title.find('\n'));
  for (const auto& [words, name, advice] : other_records) {
    // A corrected record says below its first line that it was made from an uncorrected one.
    const std::string& text = std::string_view{name} == "CSMIP V1" || std::string_view{name} == "USC" ? first : title;
    if (text.find(words) != std::string::npos)
      throw NotARecord{file.path.string() + ": this is a file " + name + ": " + advice + "."};
  }
}

void refuse_binary_records(const std::filesystem::path& path) {
  std::array<char, 4096> beginning{};
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure)) return;
  std::ifstream file{path, std::ios::binary};
  file.read(beginning.data(), beginning.size());
  const std::string_view bytes{beginning.data(), static_cast<std::size_t>(file.gcount())};
  if (bytes.find('\0') == std::string_view::npos) return;
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0 || c == ' '; };
  const bool is_miniseed = bytes.size() >= 48 && std::all_of(bytes.begin(), bytes.begin() + 6, is_digit) &&
                           std::string_view{"DRQM"}.find(bytes[6]) != std::string_view::npos && bytes[7] == ' ';
  // The version of the header, 6, as whole number in either order of bytes.
  constexpr std::size_t sac_header = 632, sac_version = 304;
  const bool is_sac = bytes.size() >= sac_header && (bytes.substr(sac_version, 4) == std::string_view{"\6\0\0\0", 4} ||
                                                     bytes.substr(sac_version, 4) == std::string_view{"\0\0\0\6", 4});
  const char* kind = is_miniseed                       ? "miniSEED"
                     : is_sac                          ? "SAC"
                     : bytes.starts_with("\x89HDF")    ? "HDF5"
                     : bytes.starts_with("MATLAB 5.0") ? "MATLAB"
                                                       : nullptr;
  if (kind != nullptr)
    throw NotARecord{path.string() + ": this file is binary (" + kind +
                     "). Convert it to text, for example with ObsPy, read(file).write(...), once the response of the "
                     "instrument is removed."};
}

}  // namespace moat
