#include "study/study_report.hpp"

#include "base/number_format.hpp"
#include "output/file_io.hpp"
#include "report/html.hpp"
#include "report/input_sections.hpp"
#include "report/page.hpp"
#include "study/study_charts.hpp"

namespace moat {
namespace {

using html::escaped;
using html::number_row;
using html::text_row;

constexpr std::size_t most_failures = 100;

std::string case_section(const StudyResult& result) {
  std::string html = "<table>\n" + number_row("Cases", std::to_string(result.cases().count()));
  for (const CaseState state : {CaseState::done, CaseState::failed, CaseState::not_converged})
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
    html += text_row(failures[i].description, failures[i].message);
  html += "</table>\n";
  if (failures.size() > most_failures)
    html += "<p>... and " + std::to_string(failures.size() - most_failures) + " more, in the CSV file.</p>\n";
  return html;
}

}  // namespace

void write_study_report(const StudyReport& report, const std::filesystem::path& folder) {
  std::string page;
  if (!report.answers.empty() || !report.pictures.empty()) page += "<h2>Answers</h2>\n";
  for (const std::string& answer : report.answers) page += "<p>" + escaped(answer) + "</p>\n";
  int number = 0;
  for (const StudyPicture& picture : report.pictures) {
    page += picture.svg;
    write_file(folder / ("answer_" + std::to_string(++number) + ".svg"),
               "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + picture.svg);
  }
  for (const NamedStudy& study : report.studies) {
    page += "<h2>" + escaped(study.name) + "</h2>\n" + case_section(study.result) + failure_section(study.result);
    for (const HeatMap& map : heat_maps(study.result)) page += svg_text(map);
    const std::vector<Chart> charts = axis_charts(study.result);
    if (!charts.empty()) page += svg_text(charts, 1000, 320, 2);
  }
  page += html::provenance_section(report.provenance);
  write_file(folder / "report.html", html::page(report.title, page));
}

}  // namespace moat
