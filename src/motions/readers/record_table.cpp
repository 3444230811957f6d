#include "motions/readers/record_table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "base/text/rows.hpp"
#include "base/text/utf8_text.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/record_folder.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

constexpr const char *table_name = "records.csv",
                     *table_columns = "file,channel,record,component,azimuth,unit,step,sign,columns";
/// The columns that the table has, and those behind them that write_record_table() adds.
const std::set<std::string> known_columns{"file", "channel", "record", "component", "azimuth", "unit", "step",
                                          "sign", "columns", "format", "level",     "reason",  "peak", "start"};

std::mutex notes_mutex;
std::vector<std::string> all_notes;
/// Rows of the table by file and channel.
std::map<std::pair<std::string, std::size_t>, std::string> all_rows;

/// Whether a spreadsheet would take it for a formula, or whether it begins as one that is marked as text.
bool needs_mark(std::string_view text) { return text.find_first_of("=+-@'") == 0; }

/// In quotes where the table would take it for something else, and behind an apostrophe where a spreadsheet would. A
/// newline in the name of a file would end the row.
std::string field_of(const std::string& given) {
  std::string text = as_utf8(given);
  for (char& c : text) {
    if (c == '"') c = '\'';
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  }
  if (needs_mark(text)) text.insert(0, "'");
  const bool is_plain = text.find(',') == std::string::npos && !text.starts_with('#') && !text.starts_with('%');
  return is_plain ? text : '"' + text + '"';
}

/// The row that reads the channel again as it was understood. The component and azimuth of a file that says them need
/// no word of the table.
std::string row_of(const SortedChannel& sorted) {
  const RecordChannel& channel = sorted.channel;
  const std::string component = sorted.fate.starts_with("left out") ? "out" : sorted.component;
  double peak = 0.0;
  for (const double sample : channel.samples) peak = std::max(peak, std::abs(sample));
  constexpr const char* levels[] = {"raw", "uncorrected", "corrected"};
  std::string row = field_of(fs::path{channel.file.path}.filename().string()) + "," + std::to_string(channel.number);
  for (const std::string& field :
       {field_of(sorted.record), component, sorted.azimuth ? to_exact(*sorted.azimuth) : "", field_of(channel.unit),
        sorted.step > 0.0 ? to_exact(sorted.step) : "", sorted.sign < 0.0 ? std::string{"-1"} : "",
        field_of(channel.columns), field_of(channel.format),
        std::string{channel.format.empty() ? "" : levels[static_cast<std::size_t>(channel.level)]},
        field_of(sorted.fate), to_text(peak), channel.start ? to_fixed(*channel.start, 6) : ""})
    row += "," + field;
  return row;
}

/// m/s^2, by a name or as "9.80665 m/s^2"; nothing for others.
std::optional<double> unit_of(std::string_view name) {
  constexpr std::string_view si = " m/s^2";
  const std::optional<double> named = acceleration_unit(name);
  if (named || !name.ends_with(si)) return named;
  const ScannedNumber number = parse_number(name.substr(0, name.size() - si.size()));
  return number.problem ? std::nullopt : std::optional{number.value};
}

}  // namespace

SortedFiles::SortedFiles(const fs::path& folder, const RecordOptions& options) : where_{folder} {
  const fs::path table = folder / (options.table.empty() ? table_name : options.table);
  std::error_code error, no_table;
  std::set<fs::path> files;
  std::set<std::string> names;
  for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error)) {
    const fs::path& file = entry->path();
    if (file.filename() == table_name || fs::equivalent(file, table, no_table)) continue;
    files.insert(file);
    names.insert(file.filename().string());
  }
  if (error) throw FileError{"records " + folder.string() + ": " + error.message() + ". Give a folder with records."};
  read_table(table, !options.table.empty(), names);
  for (const fs::path& file : files) read(file, options, true);
}

SortedFiles::SortedFiles(const std::vector<fs::path>& files, const RecordOptions& options)
    : where_{files.empty() ? fs::path{} : files[0].parent_path()} {
  std::set<std::string> names;
  for (const fs::path& file : files) names.insert(file.filename().string());
  if (!options.table.empty()) read_table(options.table, true, names);
  for (const fs::path& file : files) read(file, options, false);
  // Some of several files may be plain text.
  if (files.size() == 1)
    for (const SortedChannel& each : channels_) check_text({each.channel}, options.text);
}

void SortedFiles::refuse(const std::string& problem) const {
  throw FileError{"records " + where_.string() + ": " + problem + " Say it in the table " +
                  (table_.empty() ? where_ / table_name : table_).string() + ": first the line \"" + table_columns +
                  "\" or a part of it, then one for each file, such as \"a.AT2,1,Kobe,x,,,,\"; components are x, y, z, "
                  "first, second, vertical and out."};
}

void SortedFiles::note(const std::string& text) const {
  const std::lock_guard lock{notes_mutex};
  const std::string line = "records " + where_.string() + ": " + text;
  if (std::ranges::find(all_notes, line) == all_notes.end()) all_notes.push_back(line);
}

void SortedFiles::note(SortedChannel& channel, const std::string& fate) const {
  channel.fate = fate;
  {
    const std::lock_guard lock{notes_mutex};
    all_rows[{channel.channel.file.path, channel.channel.number}] = row_of(channel);
  }
  const std::string name = fs::path{channel.channel.file.path}.filename().string();
  const std::size_t number = channel.channel.number;
  const std::string where = channel.channel.count == 1 ? name : name + ", channel " + std::to_string(number) + ",";
  note(where + " is " + fate + (fate.ends_with('.') ? "" : "."));
  for (const std::string& warning : channel.channel.warnings)
    note(name + ", channel " + std::to_string(number) + ": " + warning + ".");
}

void SortedFiles::read_table(const fs::path& table, bool is_needed, const std::set<std::string>& names) {
  table_ = table;
  if (!is_needed && !fs::exists(table)) return;
  Rows lines{read_text_file(table), ','};
  const Row heading = lines.take_heading();
  const std::vector<std::string>& columns = heading.fields;
  const auto refuse_row = [&](const Row& row, const std::string& problem) {
    refuse("line " + std::to_string(row.line_number) + " of its table, " + moat::quoted(row.text) + ", " + problem);
  };
  const auto place_of = [&](std::string_view column) {
    return static_cast<std::size_t>(std::ranges::find(columns, column) - columns.begin());
  };
  if (place_of("file") == columns.size()) refuse_row(heading, "does not name its columns.");
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (!known_columns.contains(columns[i]) || place_of(columns[i]) != i)
      refuse_row(heading, "has a column " + moat::quoted(columns[i]) + " that is not known, or there twice.");
  for (const Row& row : lines.list) {
    if (row.fields.size() != columns.size()) refuse_row(row, "is not of this form.");
    const auto field = [&](std::string_view column) -> std::string {
      const std::size_t at = place_of(column);
      const std::string text = at < columns.size() ? row.fields[at] : "";
      return text.starts_with('\'') && needs_mark(text.substr(1)) ? text.substr(1) : text;
    };
    const auto number = [&](std::string_view column) {
      return field(column).empty() ? std::nullopt : std::optional{lines.number(row, place_of(column))};
    };
    const std::string file = field("file"), unit = field("unit");
    RecordRow entry{.line = row.line_number,
                    .record = field("record"),
                    .component = field("component"),
                    .columns = field("columns"),
                    .azimuth = number("azimuth"),
                    .unit = unit_of(unit),
                    .step = number("step"),
                    .sign = number("sign")};
    const double channel = number("channel").value_or(0.0);
    if (!(channel >= 0.0 && channel < 1e6 && channel == std::floor(channel)))
      refuse_row(row, "has a channel that is no whole number from 0 to 1e6.");
    entry.channel = static_cast<std::size_t>(channel);
    static const std::set<std::string> components{"", "x", "y", "z", "first", "second", "vertical", "out"};
    if (!components.contains(entry.component)) refuse_row(row, "names no component.");
    if (entry.azimuth && !(*entry.azimuth >= 0.0 && *entry.azimuth <= 360.0))
      refuse_row(row, "has an azimuth outside 0 to 360 deg.");
    if (entry.step && !(*entry.step > 0.0)) refuse_row(row, "has a step that is not > 0 s.");
    if (entry.sign && std::abs(*entry.sign) != 1.0) refuse_row(row, "has a sign that is neither 1 nor -1.");
    if (!unit.empty() && !(entry.unit > 0.0)) refuse_row(row, "has a unit that is not known.");
    if (!names.contains(file)) refuse_row(row, "names a file that is not there.");
    std::vector<RecordRow>& rows = rows_[file];
    for (const RecordRow& other : rows)
      if (other.channel == entry.channel || other.channel == 0 || entry.channel == 0)
        refuse_row(row, "names a file for the second time.");
    rows.push_back(std::move(entry));
  }
}

void SortedFiles::read(const fs::path& file, const RecordOptions& options, bool may_leave_out) {
  const auto leave_out = [&](const std::string& reason) {
    SortedChannel out{.channel = {.file = {fs::absolute(file).string(), {}}, .name = file.stem().string()}};
    note(out, "left out: " + reason);
  };
  const auto found = rows_.find(file.filename().string());
  TextColumns text = options.text;
  if (found != rows_.end()) {
    const RecordRow& row = found->second.front();
    if (std::ranges::all_of(found->second, [](const RecordRow& each) { return each.component == "out"; }))
      return leave_out(table_.filename().string() + " says \"out\"");
    if (row.unit) text.unit = Acceleration{*row.unit};
    if (row.step) text.step = Time{*row.step};
    if (!row.columns.empty()) text.columns = row.columns;
  }
  if (may_leave_out && !fs::is_regular_file(file)) return leave_out("it is no file");
  try {
    std::vector<RecordChannel> channels;
    std::vector<FileRead> files;
    {
      // A file that is left out is none of a study's records.
      const FilesOfThisThread reading;
      channels = read_channels(file, text);
      files = reading.files();
    }
    std::ranges::for_each(files, note_file_read);
    if (found != rows_.end())
      for (const RecordRow& row : found->second)
        if (row.channel > channels.size())
          refuse("line " + std::to_string(row.line) + " of its table names channel " + std::to_string(row.channel) +
                 " of " + file.filename().string() + ", which has " + std::to_string(channels.size()) + ".");
    for (RecordChannel& channel : channels) {
      SortedChannel sorted{.channel = std::move(channel)};
      apply_table(sorted);
      // Words of --record-columns are those of the table.
      if (sorted.component.empty() && sorted.channel.source == "--record-columns")
        sorted.component = sorted.channel.component;
      sorted.step = sorted.channel.step;
      sorted.azimuth = sorted.channel.azimuth;
      if (sorted.component == "out")
        note(sorted, "left out: " + table_.filename().string() + " says \"out\"");
      else
        channels_.push_back(std::move(sorted));
    }
  } catch (const NotARecord& error) {
    if (!may_leave_out || found != rows_.end()) throw;
    const std::string reason = error.what();
    leave_out(reason.substr(std::min(file.string().size() + 2, reason.size())));
  } catch (const MissingUnit&) {
    if (!may_leave_out || found != rows_.end()) throw;
    leave_out("plain text does not say its unit; give it in " + std::string{table_name} + ", or with --record-unit");
  }
}

void SortedFiles::apply_table(SortedChannel& sorted) {
  RecordChannel& channel = sorted.channel;
  const auto found = rows_.find(fs::path{channel.file.path}.filename().string());
  if (found == rows_.end()) return;
  for (const RecordRow& row : found->second) {
    if (row.channel != 0 && row.channel != channel.number) continue;
    sorted.record = row.record;
    sorted.component = row.component == "first"      ? "x"
                       : row.component == "second"   ? "y"
                       : row.component == "vertical" ? "z"
                                                     : row.component;
    const std::string line = "line " + std::to_string(row.line) + " of its table has another ";
    if (row.unit && std::abs(*row.unit - unit_of(channel.unit).value()) > 1e-9 * *row.unit)
      refuse(line + "unit than the file, " + channel.unit + ".");
    if (row.step && std::abs(*row.step - channel.step) > 1e-5 * channel.step)
      refuse(line + "step than the file, " + to_text(channel.step) + " s.");
    if (!row.columns.empty() && row.columns != channel.columns)
      refuse(line + "meaning of columns than the file; only plain text has one, and all of its rows the same.");
    // A word of the file stays where the table says the same.
    const bool is_turned = row.azimuth && std::fmod(*row.azimuth, 360.0) != channel.azimuth;
    if (row.azimuth) channel.azimuth = std::fmod(*row.azimuth, 360.0);
    if (is_turned || !sorted.component.empty()) {
      channel.component = sorted.component.empty() ? to_text(*row.azimuth) : row.component;
      channel.source = table_.filename().string();
      channel.vertical = sorted.component == "z";
    }
    sorted.sign = row.sign.value_or(1.0);
    for (double& sample : channel.samples) sample *= sorted.sign;
  }
}

std::vector<std::string> record_folder_notes() {
  const std::lock_guard lock{notes_mutex};
  return all_notes;
}

void write_record_table(const fs::path& file, const fs::path& folder) {
  std::ofstream stream{file};
  const std::lock_guard lock{notes_mutex};
  stream << table_columns << ",format,level,reason,peak,start\n";
  const fs::path wanted = folder.empty() ? fs::path{} : fs::weakly_canonical(folder);
  for (const auto& [key, row] : all_rows)
    if (folder.empty() || fs::weakly_canonical(key.first).parent_path() == wanted) stream << row << "\n";
  if (!stream.flush()) throw FileError{file.string() + ": the table cannot be written."};
}

}  // namespace moat
