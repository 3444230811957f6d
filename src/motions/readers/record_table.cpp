#include "motions/readers/record_table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/check.hpp"
#include "base/text/text_file.hpp"
#include "motions/readers/channel_parts.hpp"
#include "motions/readers/record_folder.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

constexpr const char *table_name = "records.csv",
                     *table_columns = "file,channel,record,component,azimuth,unit,step,sign";

std::mutex notes_mutex;
std::vector<std::string> all_notes;
/// Rows of the table by file and channel.
std::map<std::pair<std::string, std::size_t>, std::string> all_rows;

std::vector<std::string> fields_of_row(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t comma = 0; comma != std::string_view::npos; line.remove_prefix(std::min(comma + 1, line.size()))) {
    comma = line.find(',');
    fields.emplace_back(trimmed(line.substr(0, comma)));
  }
  return fields;
}

std::string without_commas(std::string text) {
  std::ranges::replace(text, ',', ' ');
  return text;
}

/// The row that reads the channel again as it was understood.
std::string row_of(const SortedChannel& sorted) {
  const RecordChannel& channel = sorted.channel;
  const bool is_out = sorted.fate.starts_with("left out");
  std::string component = is_out ? "out" : channel.vertical ? "vertical" : sorted.component;
  if (component.empty() && !channel.azimuth) component = sorted.fate.substr(0, sorted.fate.find(' '));
  double peak = 0.0;
  for (const double sample : channel.samples) peak = std::max(peak, std::abs(sample));
  constexpr const char* levels[] = {"raw", "uncorrected", "corrected"};
  return fs::path{channel.file.path}.filename().string() + "," + std::to_string(channel.number) + "," +
         without_commas(sorted.record) + "," + component + "," + (channel.azimuth ? to_text(*channel.azimuth) : "") +
         "," + channel.unit + "," + (channel.step > 0.0 ? to_text(channel.step) : "") + ",," + channel.format + "," +
         levels[static_cast<std::size_t>(channel.level)] + "," + without_commas(sorted.fate) + "," + to_text(peak) +
         "," + (channel.start ? std::to_string(*channel.start) : "");
}

}  // namespace

SortedFiles::SortedFiles(const fs::path& folder, const RecordOptions& options) : where_{folder} {
  const bool is_elsewhere = options.table.is_absolute() || fs::exists(options.table);
  const fs::path table = is_elsewhere ? options.table : folder / (options.table.empty() ? table_name : options.table);
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
  const TextFile text = read_text_file(table);
  LineReader lines{text};
  std::vector<std::string> columns;
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).empty()) continue;
    const std::vector<std::string> fields = fields_of_row(line);
    const std::string row =
        "line " + std::to_string(lines.line_number()) + " of its table, " + moat::quoted(line) + ", ";
    const auto field = [&](std::string_view column) -> std::string {
      const auto at = static_cast<std::size_t>(std::ranges::find(columns, column) - columns.begin());
      return at < fields.size() ? fields[at] : "";
    };
    if (columns.empty()) {
      columns = fields;
      if (std::ranges::find(columns, "file") == columns.end()) refuse(row + "does not name its columns.");
      continue;
    }
    if (fields.size() != columns.size()) refuse(row + "is not of this form.");
    const auto number = [&](const char* column) -> std::optional<double> {
      const std::string value = field(column);
      if (value.empty()) return std::nullopt;
      const ScannedNumber scanned = parse_number(value);
      if (scanned.problem) refuse(row + "has no number as " + column + ".");
      return scanned.value;
    };
    const std::string file = field("file"), unit = field("unit");
    RecordRow entry{.line = lines.line_number(),
                    .record = field("record"),
                    .component = field("component"),
                    .azimuth = number("azimuth"),
                    .unit = acceleration_unit(unit),
                    .step = number("step"),
                    .sign = number("sign")};
    const double channel = number("channel").value_or(0.0);
    if (!(channel >= 0.0 && channel < 1e6)) refuse(row + "has a channel below 0 or above 1e6.");
    entry.channel = static_cast<std::size_t>(channel);
    static const std::set<std::string> components{"", "x", "y", "z", "first", "second", "vertical", "out"};
    if (!components.contains(entry.component)) refuse(row + "names no component.");
    if (entry.azimuth && !(*entry.azimuth >= 0.0 && *entry.azimuth <= 360.0))
      refuse(row + "has an azimuth outside 0 to 360 deg.");
    if (entry.step && !(*entry.step > 0.0)) refuse(row + "has a step that is not > 0 s.");
    if (entry.sign && std::abs(*entry.sign) != 1.0) refuse(row + "has a sign that is neither 1 nor -1.");
    if (const std::string_view of_si = " m/s^2"; !entry.unit && unit.ends_with(of_si))
      entry.unit = parse_number(std::string_view{unit}.substr(0, unit.size() - of_si.size())).value;
    if (!unit.empty() && !(entry.unit > 0.0)) refuse(row + "has a unit that is not known.");
    if (!names.contains(file)) refuse(row + "names a file that is not there.");
    std::vector<RecordRow>& rows = rows_[file];
    for (const RecordRow& other : rows)
      if (other.channel == entry.channel || other.channel == 0 || entry.channel == 0)
        refuse(row + "names a file for the second time.");
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
    for (RecordChannel& channel : channels) {
      SortedChannel sorted{.channel = std::move(channel)};
      apply_table(sorted);
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
    const bool is_text = channel.format == "text";
    if (row.unit && !is_text && std::abs(*row.unit - acceleration_unit(channel.unit).value()) > 1e-9 * *row.unit)
      refuse("line " + std::to_string(row.line) + " of its table has another unit than the file, " + channel.unit +
             ".");
    if (row.step && !is_text && std::abs(*row.step - channel.step) > 1e-5 * channel.step)
      refuse("line " + std::to_string(row.line) + " of its table has another step than the file, " +
             to_text(channel.step) + " s.");
    if (row.azimuth) channel.azimuth = std::fmod(*row.azimuth, 360.0);
    if (row.azimuth || !sorted.component.empty()) {
      channel.component = sorted.component.empty() ? to_text(*row.azimuth) : row.component;
      channel.source = table_.filename().string();
      channel.vertical = sorted.component == "z";
    }
    if (row.sign)
      for (double& sample : channel.samples) sample *= *row.sign;
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
