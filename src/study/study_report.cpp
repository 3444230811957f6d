#include "study/study_report.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/text/number_format.hpp"
#include "output/files/file_io.hpp"
#include "report/html.hpp"
#include "report/sections.hpp"
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
  static const std::map<std::string, std::string> words{
      {".html", "Time of all cases"},
      {".csv", ",state,reason,steps [1],energy_error [1],seconds [s]"},
      {".svg", svg_prolog}};
  std::error_code none;
  const fs::file_status status = fs::symlink_status(path, none);
  const auto known = words.find(path.extension().string());
  if (!fs::exists(status) || known == words.end()) return !fs::exists(status) || fs::is_directory(status);
  if (!fs::is_regular_file(status)) return false;
  std::ifstream lines{path};
  for (std::string line; std::getline(lines, line);)
    if (line.find(known->second) != std::string::npos) return true;
  return false;
}

/// The folder of the pictures, in which every one has a name of its own.
class PictureFolder {
 public:
  explicit PictureFolder(fs::path folder) : folder_{std::move(folder)} {}

  void write(const std::string& title, const std::string& svg) {
    const std::string name = file_name_of(title);
    std::string free = name;
    for (int i = 2; !is_own(folder_ / (free + ".svg")) || !names_.insert(free).second; ++i)
      free = name + "_" + std::to_string(i);
    std::error_code ignored;  // writing the file says more
    fs::create_directories(folder_, ignored);
    write_file(folder_ / (free + ".svg"), std::string{svg_prolog} + "\n" + svg);
  }
  /// The report before the answers of the script had this picture.
  void remove(const std::string& title) {
    std::error_code ignored;
    const fs::path picture = folder_ / (file_name_of(title) + ".svg");
    if (is_own(picture)) fs::remove(picture, ignored);
  }

 private:
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
  std::string html = "<table>\n" + number_row("Cases", std::to_string(result.cases().count()));
  for (const CaseState state : {CaseState::done, CaseState::failed, CaseState::not_converged, CaseState::open})
    html += number_row("of these " + std::string{name_of(state)}, std::to_string(result.count(state)));
  double seconds = 0.0;
  for (const CaseOutcome& outcome : result.outcomes()) seconds += outcome.seconds;
  html += number_row("Time of all cases", to_significant(seconds, 4) + " s");
  for (const StudyAxis& axis : result.axes())
    html += text_row("Axis " + axis.name + (axis.unit.empty() ? "" : " [" + axis.unit + "]"),
                     std::to_string(axis.values.size()) + " values");
  return html + "</table>\n";
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
  std::string html =
      "<h2>" + escaped(study.name) + "</h2>\n" + case_section(study.result) + paragraphs(study.answers, shown);
  const std::string prefix = study.name + " ";
  for (const StudyPicture& picture : study.pictures) {
    if (shown.contains(picture.title)) {
      folder.remove(prefix + picture.title);
      continue;
    }
    html += html::wide_picture(picture.svg);
    folder.write(prefix + picture.title, picture.svg);
  }
  for (const HeatMap& map : heat_maps(study.result)) {
    const std::string svg = svg_text(map);
    html += html::wide_picture(svg);
    folder.write(prefix + map.title + " map", svg);
  }
  const std::vector<Chart> charts = axis_charts(study.result);
  if (!charts.empty()) html += html::chart_grid(charts, 500, 320);
  for (const Chart& chart : charts)
    folder.write(prefix + chart.title + " over " + without_unit(chart.x_label), svg_text({chart}, 700, 420));
  return html + failure_section(study.result);
}

}  // namespace

void require_own(const fs::path& path) {
  if (!is_own(path))
    throw InputError{path.string() +
                     " was not written by a study of moat, and is not replaced. Give another folder by --out, or move "
                     "it away."};
}

void write_study_report(const StudyReport& report, const fs::path& folder) {
  for (const char* name : {"report.html", "pictures"}) require_own(folder / name);
  std::string page;
  // Sentences and titles that are not shown once more.
  std::set<std::string> shown{report.answers.begin(), report.answers.end()};
  PictureFolder pictures{folder / "pictures"};
  if (!report.answers.empty() || !report.pictures.empty()) page += "<h2>Answers</h2>\n";
  page += paragraphs(report.answers);
  for (const StudyPicture& picture : report.pictures) {
    page += html::wide_picture(picture.svg);
    shown.insert(picture.title);
    pictures.write(picture.title, picture.svg);
  }
  for (const NamedStudy& study : report.studies) page += study_section(study, shown, pictures);
  if (!report.records.empty()) page += "<h2>Files of records</h2>\n" + paragraphs(report.records);
  page += html::provenance_section(report.provenance);
  write_file(folder / "report.html", html::page(report.title, page));
}

}  // namespace moat
