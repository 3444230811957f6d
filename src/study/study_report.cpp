#include "study/study_report.hpp"

#include <algorithm>
#include <exception>
#include <fstream>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "base/text/number_format.hpp"
#include "output/files/csv_writer.hpp"
#include "output/files/engineering_unit.hpp"
#include "output/files/file_io.hpp"
#include "report/charts/chart_columns.hpp"
#include "report/html.hpp"
#include "report/sections.hpp"
#include "study/clearance_chart.hpp"
#include "study/floor_spectra_of_records.hpp"
#include "study/study_charts.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using html::escaped;
using html::number_row;
using html::text_row;

constexpr std::size_t most_failures = 100;
constexpr const char* svg_prolog = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";

/// Whether nothing is there, or a file or folder that a study of moat wrote.
bool is_own(const fs::path& path) {
  static const std::multimap<std::string, std::string> words{
      {".html", "Time of all cases"},
      {".html", "<section class=\"sheet\">"},
      {".csv", ",state,reason,steps [1],energy_error [1],seconds [s]"},
      {".svg", svg_prolog}};
  std::error_code none;
  const fs::file_status status = fs::symlink_status(path, none);
  const auto [first, last] = words.equal_range(path.extension().string());
  if (!fs::exists(status) || first == last) return !fs::exists(status) || fs::is_directory(status);
  if (!fs::is_regular_file(status)) return false;
  std::ifstream lines{path};
  for (std::string line; std::getline(lines, line);)
    if (std::any_of(first, last, [&](const auto& known) { return line.find(known.second) != std::string::npos; }))
      return true;
  return false;
}

std::string line_of(const fs::path& path, int number) {
  std::ifstream file{path};
  std::string line;
  for (int i = 0; i < number; ++i) std::getline(file, line);
  return line;
}

/// Whether nothing is there, or a file whose first line begins so.
bool has_heading(const fs::path& path, std::string_view heading) {
  std::error_code none;
  const fs::file_status status = fs::symlink_status(path, none);
  if (!fs::is_regular_file(status)) return !fs::exists(status);
  return line_of(path, 1).starts_with(heading);
}

/// The second line of a picture names the first line of the table beside it by its hash: a table of another is none of
/// its own.
std::string mark_of(std::string_view heading) { return "<!-- table " + sha256_of(heading) + " -->"; }

/// The folder of the pictures, in which every one has a name of its own.
class PictureFolder {
 public:
  explicit PictureFolder(fs::path folder) : folder_{std::move(folder)} {}

  void write(const std::string& title, const std::string& svg, const Table& numbers = {}) {
    const std::string name = file_name_of(title), heading = csv_heading(numbers);
    std::string free = name;
    const auto is_free = [&] {
      return is_own(path(free, ".svg")) && (has_own_table(free) || has_heading(path(free, ".csv"), heading)) &&
             names_.insert(free).second;
    };
    for (int i = 2; !is_free(); ++i) free = name + "_" + std::to_string(i);
    std::error_code ignored;  // writing the file says more
    fs::create_directories(folder_, ignored);
    if (has_own_table(free)) fs::remove(path(free, ".csv"), ignored);
    write_file(path(free, ".svg"),
               std::string{svg_prolog} + "\n" + (numbers.rows() > 0 ? mark_of(heading) + "\n" : "") + svg);
    if (numbers.rows() > 0) write_csv(numbers, path(free, ".csv"));
  }
  /// The report before the answers of the script had this picture.
  void remove(const std::string& title) {
    std::error_code ignored;
    const std::string name = file_name_of(title);
    if (!is_own(path(name, ".svg"))) return;
    if (has_own_table(name)) fs::remove(path(name, ".csv"), ignored);
    fs::remove(path(name, ".svg"), ignored);
  }

 private:
  [[nodiscard]] fs::path path(const std::string& name, const char* extension) const {
    return folder_ / (name + extension);
  }
  /// Whether the table beside a picture was written with it.
  [[nodiscard]] bool has_own_table(const std::string& name) const {
    std::error_code none;
    return fs::is_regular_file(fs::symlink_status(path(name, ".csv"), none)) &&
           line_of(path(name, ".svg"), 2) == mark_of(line_of(path(name, ".csv"), 1));
  }

  fs::path folder_;
  std::set<std::string> names_;
};

std::string without_unit(const std::string& label) { return label.substr(0, label.find(" [")); }

std::string paragraphs(const std::vector<std::string>& sentences, const std::set<std::string>& shown = {}) {
  std::string html;
  for (const std::string& sentence : sentences)
    if (!shown.contains(sentence)) html += "<p>" + escaped(sentence) + "</p>\n";
  return html;
}

std::string case_section(const StudyResult& result) {
  std::string html =
      "<details><summary>Cases</summary>\n<table>\n" + number_row("Cases", std::to_string(result.cases().count()));
  for (const CaseState state : {CaseState::done, CaseState::failed, CaseState::not_converged, CaseState::open})
    html += number_row("of these " + std::string{name_of(state)}, std::to_string(result.count(state)));
  double seconds = 0.0;
  for (std::size_t number = 0; number < result.cases().count(); ++number) seconds += result.seconds(number);
  html += number_row("Time of all cases", to_significant(seconds, 4) + " s");
  for (const StudyAxis& axis : result.axes())
    html += text_row("Axis " + axis.name + (axis.unit.empty() ? "" : " [" + axis.unit + "]"),
                     std::to_string(axis.values.size()) + " values");
  return html + "</table></details>\n";
}

std::string failure_section(const StudyResult& result) {
  const std::vector<StudyError::Failure> failures = failures_of(result);
  if (failures.empty()) return "";
  std::string html =
      "<h3>Cases without results</h3>\n<p>A case that did not converge is neither a pass nor a failure of the "
      "structure.</p>\n<table>\n";
  for (std::size_t i = 0; i < std::min(failures.size(), most_failures); ++i)
    html +=
        text_row("Case " + std::to_string(failures[i].number) + ", " + failures[i].description, failures[i].message);
  html += "</table>\n";
  if (failures.size() > most_failures)
    html += "<p>... and " + std::to_string(failures.size() - most_failures) + " more, in the CSV file.</p>\n";
  return html;
}

std::string study_section(const NamedStudy& study, const std::set<std::string>& shown, PictureFolder& folder) {
  const std::size_t cases = study.result.cases().count(), done = study.result.count(CaseState::done);
  std::string html = "<h2>" + escaped(study.name) + "</h2>\n<p class=\"subtitle\">" + std::to_string(cases) + " cases" +
                     (done == cases ? "" : ", of which " + std::to_string(cases - done) + " have no result") +
                     "</p>\n" + paragraphs(study.answers, shown);
  const std::string prefix = study.name + " ";
  if (!study.profiles.empty()) html += html::chart_grid(study.profiles, 500, 380);
  for (const Chart& chart : study.profiles)
    folder.write(prefix + chart.title, svg_text({chart}, 700, 520), table_of(chart));
  for (const StudyPicture& picture : study.pictures) {
    if (shown.contains(picture.title)) {
      folder.remove(prefix + picture.title);
      continue;
    }
    html += html::wide_picture(picture.svg);
    folder.write(prefix + picture.title, picture.svg, picture.numbers);
  }
  const std::vector<Chart> spectra = floor_spectra_over_records(study.statistics);
  if (!spectra.empty()) html += html::chart_grid(spectra, 500, 320);
  for (const Chart& chart : spectra) folder.write(prefix + chart.title, svg_text({chart}, 700, 420), table_of(chart));
  if (const std::optional<Chart> chart = clearance_chart(study.result)) {
    const std::string svg = svg_text({*chart});
    html += html::wide_picture(svg);
    folder.write(prefix + chart->title, svg, table_of(*chart));
  }
  for (const HeatMap& map : heat_maps(study.result)) {
    const std::string svg = svg_text(map);
    html += html::wide_picture(svg);
    folder.write(prefix + map.title + " map", svg);
  }
  const std::vector<Chart> charts = axis_charts(study.result);
  if (!charts.empty()) html += html::chart_grid(charts, 500, 320);
  for (const Chart& chart : charts)
    folder.write(prefix + chart.title + " over " + without_unit(chart.x_label), svg_text({chart}, 700, 420),
                 table_of(chart));
  return html + failure_section(study.result) + case_section(study.result);
}

std::string table_section(const StudyTable& shown) {
  require_equal_lengths(shown.table);
  std::string html = "<h3>" + escaped(shown.title) + "</h3>\n<div class=\"wide\"><table class=\"sortable\">\n<tr>";
  for (const Column& column : shown.table.columns)
    html += "<th>" +
            escaped(column.labels.empty() && column.unit != "1" && !column.unit.empty()
                        ? axis_label(column.quantity, column.unit) + (column.where.empty() ? "" : ", " + column.where)
                        : in_words(column.quantity)) +
            "</th>";
  html += "</tr>\n";
  for (std::size_t row = 0; row < shown.table.rows(); ++row) {
    html += "<tr>";
    for (const Column& column : shown.table.columns)
      html += column.labels.empty()
                  ? "<td class=\"number\">" +
                        to_significant(engineering_unit(column.unit).per_si * column.values[row], 4) + "</td>"
                  : html::cell(column.labels[row]);
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

}  // namespace

void require_own(const fs::path& path) {
  if (!is_own(path))
    throw InputError{path.string() +
                     " was not written by a study of moat, and is not replaced. Give another folder by --out, or move "
                     "it away."};
}

void require_own_table(const fs::path& path, std::string_view heading) {
  if (!has_heading(path, heading))
    throw InputError{path.string() +
                     " is not this table, and is not replaced. Give another folder by --out, or move it "
                     "away."};
}

void write_own_csv(const Table& table, const fs::path& path) {
  require_own_table(path, csv_heading(table));
  write_csv(table, path);
}

void write_all(std::span<const std::function<void()>> files) {
  std::exception_ptr first;
  for (const std::function<void()>& write : files) {
    try {
      write();
    } catch (...) {
      if (!first) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
}

void write_study_report(const StudyReport& report, const fs::path& folder) {
  for (const char* name : {"report.html", "pictures"}) require_own(folder / name);
  std::string page;
  // Sentences and titles that are not shown once more.
  std::set<std::string> shown{report.answers.begin(), report.answers.end()};
  PictureFolder pictures{folder / "pictures"};
  if (!report.answers.empty() || !report.pictures.empty() || !report.tables.empty()) page += "<h2>Answers</h2>\n";
  page += paragraphs(report.answers);
  for (const NamedStudy& study : report.studies)
    if (const std::string section = statistics_section(study.result, study.statistics); !section.empty())
      page += "<h2>" + escaped(capitalised(study.name)) + " over its records</h2>\n" + section;
  for (const StudyTable& each : report.tables) page += table_section(each);
  for (const StudyPicture& picture : report.pictures) {
    page += html::wide_picture(picture.svg);
    shown.insert(picture.title);
    pictures.write(picture.title, picture.svg, picture.numbers);
  }
  for (const NamedStudy& study : report.studies) page += study_section(study, shown, pictures);
  if (!report.records.empty()) page += "<h2>Files of records</h2>\n" + paragraphs(report.records);
  page += html::provenance_section(report.provenance);
  write_file(folder / "report.html", html::page(report.title, page));
  std::vector<std::function<void()>> tables;
  for (const StudyTable& each : report.tables)
    tables.emplace_back([&] { write_own_csv(each.table, folder / (file_name_of(each.title) + ".csv")); });
  write_all(tables);
}

}  // namespace moat
