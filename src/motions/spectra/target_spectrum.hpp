// Elastic spectra that a code or a table prescribes.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/quantity.hpp"

namespace moat {

/// A prescribed spectrum of pseudo-accelerations. The spectra of code_spectra.hpp and tables become one.
struct TargetSpectrum {
  std::string name;             ///< Outputs call it so.
  std::string source;           ///< One line: clause, origin of the values, and the parts that nobody read there.
  double damping_ratio = 0.05;  ///< >= 0, < 1
  Time shortest{}, longest{};   ///< The range; the longest period may be infinite.
  std::vector<Time> corners{};  ///< Periods inside the range; the spectrum is smooth between them.
  std::function<double(double)> value{};  ///< m/s^2, of a period in s inside the range.
  std::string advice{};                   ///< Remedy where a longer period is asked for.

  /// Throws InputError, with the range, for a period outside it.
  [[nodiscard]] Acceleration acceleration(Time period) const;
};

/// A spectrum by points, straight between them.
struct SpectrumTable {
  std::string name;                          ///< Outputs call it so.
  std::vector<Time> periods;                 ///< >= 0 s, increasing; at least two.
  std::vector<Acceleration> accelerations;   ///< > 0, one per period.
  double damping_ratio = 0.05;               ///< >= 0, < 1
  std::string source = "table of the user";  ///< One line.
  /// T_L of ASCE 7-22, for tables that reach 10 s: behind the last point S_a falls with 1/T up to T_L, then with 1/T^2;
  /// with 1/T^2 alone where the table reaches T_L (recalled, not read in the code). Without it longer periods
  /// are refused.
  std::optional<Time> long_period{};

  /// Throws InputError for bad points.
  operator TargetSpectrum() const;
};

/// Which ground motion a spectrum of ASCE 7 stands for.
enum class SpectrumLevel { design, mce_r };

/// How read_target_spectrum() takes a file.
struct TargetFile {
  /// JSON files hold both levels: this one is read. It becomes a part of the name of a CSV file's spectrum.
  std::optional<SpectrumLevel> level{};
  double damping_ratio = 0.05;        ///< At which the spectrum holds, >= 0, < 1.
  std::optional<Time> long_period{};  ///< As in SpectrumTable; JSON files state it.
};

/// Reads a multi-period spectrum: a CSV file with the heading `period_s,sa_g` (lines that begin with # are remarks), or
/// the answer of the service asce7-22 of the USGS, saved as JSON. Throws FileError for a file that is neither, with the
/// line, and InputError as SpectrumTable does.
[[nodiscard]] TargetSpectrum read_target_spectrum(const std::filesystem::path& path, const TargetFile& options = {});

}  // namespace moat
