#include "performance/record.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "documentation_section.hpp"
#include "output/file_io.hpp"
#include "performance/machine.hpp"

namespace moat::performance {
namespace {

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

std::string spread_text(const Spread& value) {
  return short_text(value.low) + " to " + short_text(value.high) + ", n = " + std::to_string(value.count);
}

std::string target_text(const Target& target) {
  return (target.at_most ? "at most " : "at least ") + short_text(target.bound);
}

nlohmann::ordered_json json_of(const Figure& figure) {
  nlohmann::ordered_json json{{"name", figure.name},
                              {"value", figure.value.median},
                              {"unit", figure.unit},
                              {"quartile_1", figure.value.low},
                              {"quartile_3", figure.value.high},
                              {"count", figure.value.count}};
  if (!figure.detail.empty()) json["detail"] = figure.detail;
  if (figure.target)
    json["target"] = {{figure.target->at_most ? "at_most" : "at_least", figure.target->bound}, {"held", figure.held()}};
  return json;
}

nlohmann::ordered_json json_of(const Chart& chart) {
  auto series = nlohmann::ordered_json::array();
  for (const Series& one : chart.series) series.push_back({{"name", one.name}, {"x", one.x}, {"y", one.y}});
  return {{"title", chart.title}, {"x", chart.x_label}, {"y", chart.y_label}, {"series", series}};
}

}  // namespace

bool Figure::held() const {
  if (!target) return true;
  return target->at_most ? value.median <= target->bound : value.median >= target->bound;
}

void Record::section(const std::string& name, const std::string& title) {
  sections_.push_back({name, title, {}, {}, {}});
  std::printf("\n%s\n", title.c_str());
}

void Record::add(Figure figure) {
  std::string line = figure.name + "  " + with_unit(short_text(figure.value.median), figure.unit);
  if (figure.value.count > 1) line += "  (" + spread_text(figure.value) + ")";
  if (figure.target) line += "  target " + target_text(*figure.target) + ": " + (figure.held() ? "held" : "MISSED");
  if (!figure.detail.empty()) line += "  [" + figure.detail + "]";
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
  sections_.back().figures.push_back(std::move(figure));
}

void Record::note(const std::string& sentence) {
  std::printf("%s\n", sentence.c_str());
  std::fflush(stdout);
  sections_.back().notes.push_back(sentence);
}

void Record::chart(const std::string& file_name, const std::string& svg) {
  sections_.back().drawings.push_back({file_name, svg, {}});
}

void Record::chart(const std::string& file_name, const std::vector<Chart>& charts, int width, int height, int columns) {
  sections_.back().drawings.push_back({file_name, svg_text(charts, width, height, columns), charts});
}

int Record::targets() const {
  int count = 0;
  for (const Section& section : sections_)
    for (const Figure& figure : section.figures) count += figure.target ? 1 : 0;
  return count;
}

int Record::missed() const {
  int count = 0;
  for (const Section& section : sections_)
    for (const Figure& figure : section.figures) count += figure.held() ? 0 : 1;
  return count;
}

void Record::write(const std::filesystem::path& folder) const {
  nlohmann::ordered_json json{{"machine", machine()},
                              {"targets", targets()},
                              {"held", targets() - missed()},
                              {"missed", missed()},
                              {"sections", nlohmann::ordered_json::array()}};
  std::filesystem::create_directories(folder);
  for (const Section& section : sections_) {
    auto figures = nlohmann::ordered_json::array(), charts = nlohmann::ordered_json::array();
    for (const Figure& figure : section.figures) figures.push_back(json_of(figure));
    for (const Drawing& drawing : section.drawings) {
      auto panels = nlohmann::ordered_json::array();
      for (const Chart& chart : drawing.charts) panels.push_back(json_of(chart));
      charts.push_back({{"file", drawing.file_name}, {"panels", panels}});
      write_file(folder / drawing.file_name, drawing.svg);
    }
    json["sections"].push_back({{"name", section.name},
                                {"title", section.title},
                                {"figures", figures},
                                {"notes", section.notes},
                                {"charts", charts}});
  }
  write_file(folder / "performance.json", json.dump(2) + "\n");
}

std::string Record::markdown(const Section& section) {
  std::string text = "| " + section.title + " | median | quartiles | target |\n|---|---|---|---|\n";
  for (const Figure& figure : section.figures)
    text += "| " + figure.name + (figure.detail.empty() ? "" : " (" + figure.detail + ")") + " | " +
            with_unit(short_text(figure.value.median), figure.unit) + " | " +
            (figure.value.count > 1 ? spread_text(figure.value) : "") + " | " +
            (figure.target ? target_text(*figure.target) + (figure.held() ? ": held" : ": **missed**") : "") + " |\n";
  for (const std::string& note : section.notes) text += "\n" + note + "\n";
  for (const Drawing& drawing : section.drawings)
    text += "\n![" + section.title + "](images/" + drawing.file_name + ")\n";
  return text;
}

void Record::write_documentation(const std::filesystem::path& document) const {
  replace_section(document, "machine", machine() + "\n");
  for (const Section& section : sections_) {
    replace_section(document, section.name, markdown(section));
    for (const Drawing& drawing : section.drawings)
      write_file(document.parent_path() / "images" / drawing.file_name, drawing.svg);
  }
}

}  // namespace moat::performance
