#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/layouts/layouts.hpp"
#include "motions/readers/record_lines.hpp"

namespace moat {
namespace {

/// The members of "/V/N90E/N00E".
std::vector<std::string> members_of(std::string_view list) {
  std::vector<std::string> members;
  for (std::size_t slash = list.find('/'); slash != std::string_view::npos; slash = list.find('/')) {
    list.remove_prefix(slash + 1);
    if (const std::string_view member = trimmed(list.substr(0, list.find('/'))); !member.empty())
      members.emplace_back(member);
  }
  return members;
}

}  // namespace

bool is_unam(const TextFile& file) {
  LineReader lines{file};
  std::string_view line;
  while (lines.line_number() < 7)
    if (!lines.next(line)) return false;
  return line.find("ARCHIVO ESTANDAR DE ACELERACION") != std::string_view::npos;
}

std::vector<RecordChannel> read_unam(const TextFile& file) {
  RecordLines lines{file};
  std::vector<std::string> header;
  // Keys end before a comma or bracket, because these differ: "ACEL. MAX.(Gal), C1-C6", "ORIENTACION C1-C6 (rumbo)".
  const auto value = [&](std::string_view key) -> std::string {
    for (const std::string_view line : header)
      if (const std::size_t colon = line.find(':'); trimmed(line).starts_with(key) && colon != std::string_view::npos)
        return std::string{trimmed(line.substr(colon + 1))};
    return "";
  };
  std::string_view line;
  for (int rules = -1; rules < 2;) {
    line = trimmed(lines.line("the data behind DATOS DE ACELERACION"));
    header.emplace_back(line);
    if (line.find("DATOS DE ACELERACION") != std::string_view::npos)
      rules = std::max(rules, 0);
    else if (rules >= 0 && line.find("---------+") != std::string_view::npos)
      ++rules;
  }
  const std::vector<std::string> names = members_of(value("ORIENTACION C1-C6")),
                                 steps = members_of(value("INTERVALO DE MUESTREO")),
                                 counts = members_of(value("NUM. TOTAL DE MUESTRAS")),
                                 peaks = members_of(value("ACEL. MAX.(Gal)")),
                                 durations = members_of(value("DURACION DEL REGISTRO"));
  const std::string unit = value("UNIDADES DE LOS DATOS"), format_text = value("FORMATO DATOS");
  const std::optional<FortranFormat> format = fortran_format(format_text);
  if (names.empty() || steps.size() < names.size() || counts.size() < names.size())
    lines.refuse(
        "the header must list ORIENTACION C1-C6, INTERVALO DE MUESTREO and NUM. TOTAL DE MUESTRAS of each channel.");
  if (upper_case(unit.substr(0, unit.find_first_of(" .,;(/"))) != "GAL")
    lines.refuse("UNIDADES DE LOS DATOS is " + quoted(unit) + "; only Gal is read.");
  if (!format || format->per_line != names.size())
    lines.refuse("FORMATO DATOS " + quoted(format_text) + " is no format of " + std::to_string(names.size()) +
                 " columns.");
  std::vector<RecordChannel> channels;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    RecordChannel& channel = channels.emplace_back(
        RecordChannel{.format = "UNAM", .network = "UNAM", .unit = "gal", .level = RecordLevel::uncorrected});
    const std::string word = names[i].substr(0, names[i].find(';'));
    const ScannedNumber step = parse_number(steps[i]), count = parse_number(counts[i]);
    if (!set_component(channel, word)) lines.refuse("ORIENTACION " + quoted(names[i]) + " is none such as V or N90E.");
    if (step.problem || !(step.value > 0.0) || count.problem || !(count.value >= 2.0))
      lines.refuse("INTERVALO DE MUESTREO and NUM. TOTAL DE MUESTRAS must be numbers, > 0 s and >= 2.");
    if (step.value != channels[0].step && i > 0)
      lines.refuse("INTERVALO DE MUESTREO differs between columns of the same rows.");
    if (i < durations.size())
      if (const ScannedNumber duration = parse_number(durations[i]);
          !duration.problem && std::abs(duration.value / step.value - count.value) > 1.01)
        lines.refuse("NUM. TOTAL DE MUESTRAS, " + counts[i] + ", and INTERVALO DE MUESTREO, " + steps[i] +
                     " s, do not make DURACION DEL REGISTRO, " + durations[i] + " s; FACTOR DE DECIMACION is " +
                     value("FACTOR DE DECIMACION") + ".");
    channel.station = value("CLAVE DE LA ESTACION");
    channel.event = value("FECHA DEL SISMO") + " " + value("HORA EPICENTRO");
    if (word.size() < names[i].size())
      channel.warnings.push_back("of ORIENTACION " + quoted(names[i]) + " only " + quoted(word) + " is used");
    channel.notes = header;
    channel.step = step.value;
    if (i < peaks.size()) state_peak(channel, peaks[i], 0.01);
    channel.samples.resize(static_cast<std::size_t>(std::min(count.value, static_cast<double>(file.text.size()))));
    rows = std::max(rows, channel.samples.size());
  }
  std::vector<std::vector<double>> values(names.size());
  for (std::size_t row = 0; row < rows; ++row) {
    const std::vector<double> numbers = lines.numbers(names.size(), *format, "acceleration");
    for (std::size_t i = 0; i < names.size(); ++i)
      if (row < channels[i].samples.size()) values[i].push_back(numbers[i]);
  }
  if (lines.next_filled(line))
    lines.refuse("text follows the " + std::to_string(rows) + " rows of NUM. TOTAL DE MUESTRAS: " + quoted(line) +
                 ". The number is wrong, or files were joined.");
  for (std::size_t i = 0; i < names.size(); ++i) {
    channels[i].samples.clear();
    set_samples(channels[i], values[i]);
  }
  return channels;
}

}  // namespace moat
