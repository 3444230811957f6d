#include "output/files/csv_writer.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <string_view>

#include "base/text/utf8_text.hpp"
#include "output/files/file_io.hpp"
#include "output/recorders/impact_columns.hpp"

namespace moat {
namespace {

// Whether a spreadsheet takes a text for a formula: "=...", and "-2+cmd|..." but not "-x".
bool is_formula(std::string_view text) {
  if (text.empty()) return false;
  if (std::string_view{"=@\t\r"}.find(text.front()) != std::string_view::npos) return true;
  return (text.front() == '+' || text.front() == '-') && text.find_first_of("(|!=") != std::string_view::npos;
}

// Spreadsheets take a text behind an apostrophe for no formula.
void append_text(std::string& out, std::string_view text) {
  if (is_formula(text)) return append_text(out, "'" + std::string{text});
  if (!is_utf8(text)) return append_text(out, as_utf8(text));
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

void append_number(std::string& out, double value) {
  std::array<char, 32> text;  // the longest shortest form of a double has 24 characters
  out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

// In the place of the last comma.
void end_line(std::string& out) {
  if (out.ends_with(',')) out.pop_back();
  out += '\n';
}

}  // namespace

std::string csv_heading(const Table& table) {
  std::string out;
  for (const Column& column : table.columns) {
    append_text(out, column.labels.empty() ? column_name(column) : column.quantity);
    out += ',';
  }
  if (!out.empty()) out.pop_back();
  return out;
}

void write_csv(const Table& table, const std::filesystem::path& path) {
  require_equal_lengths(table);
  write_file(path, [&](std::ostream& file) {
    file << csv_heading(table) << '\n';
    write_csv_rows(table, 0, file);
  });
}

void write_csv_rows(const Table& table, std::size_t first, std::ostream& file) {
  std::string out;
  for (std::size_t row = first; row < table.rows(); ++row) {
    for (const Column& column : table.columns) {
      if (column.labels.empty())
        append_number(out, column.values[row]);
      else
        append_text(out, column.labels[row]);
      out += ',';
    }
    end_line(out);
    constexpr std::size_t most = 1 << 20;  // of a long table, which may leave no memory for a second one as text
    if (out.size() < most) continue;
    file << out;
    out.clear();
  }
  file << out;
}

void write_csv(const std::vector<Impact>& impacts, const std::filesystem::path& path) {
  std::string out = "where";
  const std::vector<ImpactColumn> columns = columns_of(impacts);
  const bool in_plan = are_in_plan(impacts);
  for (const ImpactName& name : impact_names_in_plan)
    if (in_plan) out.append(",").append(name.name);
  for (const ImpactColumn& column : columns)
    out.append(",").append(column.name).append(" [").append(column.unit).append("]");
  out += '\n';
  for (const Impact& impact : impacts) {
    append_text(out, impact.where);
    for (const ImpactName& name : impact_names_in_plan) {
      if (!in_plan) break;
      out += ',';
      append_text(out, impact.*name.value);
    }
    for (const ImpactColumn& column : columns) {
      out += ',';
      append_number(out, impact.*column.value);
    }
    out += '\n';
  }
  write_file(path, out);
}

void write_peaks_csv(const CaseResult& result, const std::filesystem::path& path) {
  std::map<std::string_view, std::string> buildings_at;  // by the place
  for (const BuildingParts& building : result.buildings) {
    if (building.name.empty()) continue;
    for (const std::string& place : building.places) {
      std::string& names = buildings_at[place];
      names += (names.empty() ? "" : " and ") + building.name;
    }
  }
  write_file(path, [&](std::ostream& file) {
    file << "building,place,quantity,unit,value,error,time [s],side\n";
    for (const Peak& peak : result.peaks) {
      std::string row;
      for (const std::string& text : {buildings_at[peak.where], peak.where, peak.quantity, peak.unit}) {
        append_text(row, text);
        row += ',';
      }
      for (const double number : {peak.value, peak.error, peak.time}) {
        if (!std::isnan(number)) append_number(row, number);
        row += ',';
      }
      append_text(row, peak.side);
      file << row << '\n';
    }
  });
}

void write_participating_masses_csv(const CaseResult& result, const std::filesystem::path& path) {
  std::string out = "building,mode,period [s],x [%],y [%],rotation [%],sum x [%],sum y [%],sum rotation [%]\n";
  bool any = false;
  for (const BuildingParts& building : result.buildings) {
    double x = 0.0, y = 0.0, rotation = 0.0;
    int number = 0;
    for (const ParticipatingMass& mode : building.modes) {
      any = true;
      append_text(out, building.name);
      out += ',' + std::to_string(++number);
      x += mode.x;
      y += mode.y;
      rotation += mode.rotation;
      for (const double value : {mode.period, 100.0 * mode.x, 100.0 * mode.y, 100.0 * mode.rotation, 100.0 * x,
                                 100.0 * y, 100.0 * rotation}) {
        out += ',';
        append_number(out, value);
      }
      out += '\n';
    }
  }
  if (any) write_file(path, out);
}

void write_bearing_checks_csv(const CaseResult& result, const std::filesystem::path& path) {
  std::string out = "check,bearing,type,unit,demand,capacity,ratio,time [s],source\n";
  for (const auto& [bearing, type, demand] : result.bearing_checks) {
    for (const std::string_view text : {demand.check, std::string_view{bearing}, std::string_view{type}, demand.unit}) {
      append_text(out, text);
      out += ',';
    }
    for (const double number : {demand.demand, demand.capacity, demand.ratio(), demand.time}) {
      append_number(out, number);
      out += ',';
    }
    append_text(out, demand.source);
    out += '\n';
  }
  if (!result.bearing_checks.empty()) write_file(path, out);
}

void write_floor_spectra_csv(const CaseResult& result, const std::filesystem::path& path) {
  std::string out =
      "floor,place,direction,damping [1],period [s],pseudo_acceleration [m/s^2],absolute_acceleration [m/s^2]\n";
  for (const auto& [floor, corner, direction, spectrum] : result.floor_spectra)
    for (std::size_t i = 0; i < spectrum.period.size(); ++i) {
      for (const std::string& text : {floor, corner.empty() ? "centre" : corner, direction.empty() ? "x" : direction}) {
        append_text(out, text);
        out += ',';
      }
      for (const double number : {spectrum.damping_ratio, spectrum.period[i], spectrum.pseudo_acceleration[i]}) {
        append_number(out, number);
        out += ',';
      }
      if (!spectrum.absolute_acceleration.empty()) append_number(out, spectrum.absolute_acceleration[i]);
      out += '\n';
    }
  if (!result.floor_spectra.empty()) write_file(path, out);
}

}  // namespace moat
