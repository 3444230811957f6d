#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/text/text_file.hpp"
#include "base/units.hpp"
#include "motions/spectra/target_spectrum.hpp"

namespace moat {
namespace {

void add_point(SpectrumTable& table, double period, double acceleration_in_g) {
  table.periods.emplace_back(period);
  table.accelerations.push_back(acceleration_in_g * units::g);
}

void read_csv(SpectrumTable& table, const TextFile& file) {
  LineReader lines{file};
  bool headed = false;
  for (std::string_view line; lines.next(line);) {
    line = trimmed(line);
    if (line.empty() || line.starts_with('#')) continue;
    if (!headed) {
      if (line != "period_s,sa_g")
        lines.refuse("expected the heading period_s,sa_g but found " + quoted(line) +
                     ". Give periods in s and "
                     "accelerations in g, separated by commas.");
      headed = true;
      continue;
    }
    const std::size_t comma = line.find(',');
    const ScannedNumber period = parse_number(trimmed(line.substr(0, comma)));
    const ScannedNumber value =
        parse_number(comma == std::string_view::npos ? std::string_view{} : trimmed(line.substr(comma + 1)));
    if (period.problem || value.problem)
      lines.refuse("expected a period in s and an acceleration in g, separated by a comma, but found " + quoted(line) +
                   ".");
    add_point(table, period.value, value.value);
  }
}

// The answer of the service of the USGS for ASCE 7-22.
void read_json(SpectrumTable& table, const TextFile& file, const TargetFile& options) {
  if (!options.level)
    refuse_file(file.path, "it holds the design and the MCE_R spectrum. Say which: .level = SpectrumLevel::mce_r.");
  try {
    const nlohmann::json data = nlohmann::json::parse(file.text).at("response").at("data");
    const nlohmann::json& spectrum =
        data.at(*options.level == SpectrumLevel::design ? "multiPeriodDesignSpectrum" : "multiPeriodMCErSpectrum");
    const auto periods = spectrum.at("periods").get<std::vector<double>>(),
               ordinates = spectrum.at("ordinates").get<std::vector<double>>();
    if (periods.size() != ordinates.size()) refuse_file(file.path, "periods and ordinates are not equally many.");
    for (std::size_t i = 0; i < periods.size(); ++i) add_point(table, periods[i], ordinates[i]);
    if (!table.long_period && data.contains("tl") && data["tl"].is_number())
      table.long_period = Time{data["tl"].get<double>()};
  } catch (const nlohmann::json::exception& problem) {
    refuse_file(file.path, "it is no answer of the service asce7-22 of the USGS with multi-period spectra (" +
                               std::string{problem.what()} + ").");
  }
}

}  // namespace

TargetSpectrum read_target_spectrum(const std::filesystem::path& path, const TargetFile& options) {
  const TextFile file = read_text_file(path);
  SpectrumTable table;
  table.name = path.stem().string();
  if (options.level) table.name += *options.level == SpectrumLevel::design ? ", design" : ", MCE_R";
  table.damping_ratio = options.damping_ratio;
  table.long_period = options.long_period;
  const bool is_json = without_leading_blanks(trimmed(file.text)).starts_with('{');
  table.source = "file " + path.filename().string() + (is_json ? ", service asce7-22 of the USGS" : "");
  is_json ? read_json(table, file, options) : read_csv(table, file);
  return table;
}

}  // namespace moat
