#include "measuring/record.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "documentation_section.hpp"
#include "output/files/file_io.hpp"
#include "output/files/provenance.hpp"

namespace moat::performance {
namespace {

using Json = nlohmann::ordered_json;

// Its first digits, with "-dirty" behind them where files had been changed.
std::string commit() {
  constexpr std::size_t digits = 40, shown = 7;
  std::string text = provenance_of_library().git_commit;
  if (text.size() > digits) return text.substr(0, shown) + text.substr(digits);
  return text.empty() ? "unknown" : text.substr(0, shown);
}

Json json_of(const Figure& figure) {
  Json json{{"name", figure.name},
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

}  // namespace

std::string machine() {
  std::string processor = "unknown processor";
  std::ifstream info{"/proc/cpuinfo"};
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) processor = line.substr(line.find(':') + 2);
  return processor + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, GCC " __VERSION__ ", " +
         MOAT_COMPILE_FLAGS;
}

bool Figure::held() const {
  if (!target) return true;
  return target->at_most ? value.median <= target->bound : value.median >= target->bound;
}

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string cell(const Figure& figure) {
  return short_text(figure.value.median) + (figure.held() ? "" : " **missed**");
}

std::string text(const Target& target) {
  return (target.at_most ? "at most " : "at least ") + short_text(target.bound);
}

void Table::put(const std::string& row, const std::string& column, const std::string& text) {
  auto found = std::find_if(rows_.begin(), rows_.end(), [&](const auto& cells) { return cells[0] == row; });
  if (found == rows_.end()) {
    rows_.emplace_back(header_.size()).front() = row;
    found = rows_.end() - 1;
  }
  const auto place = std::find(header_.begin(), header_.end(), column) - header_.begin();
  found->at(static_cast<std::size_t>(place)) = text;
}

std::string Table::markdown() const {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
  };
  std::string text = line(header_) + line(std::vector<std::string>(header_.size(), "---"));
  for (const auto& cells : rows_) text += line(cells);
  return text;
}

void Record::section(const std::string& name) {
  sections_.push_back({name, {}, {}, {}});
  std::printf("\n%s\n", name.c_str());
}

const Figure& Record::add(Figure figure) {
  std::string line = figure.name + "  " + short_text(figure.value.median) + " " + figure.unit;
  if (figure.value.count > 1)
    line += "  (" + short_text(figure.value.low) + " to " + short_text(figure.value.high) +
            ", n = " + std::to_string(figure.value.count) + ")";
  if (figure.target) line += "  target " + text(*figure.target) + ": " + (figure.held() ? "held" : "MISSED");
  if (!figure.detail.empty()) line += "  [" + figure.detail + "]";
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
  sections_.back().figures.push_back(std::move(figure));
  return sections_.back().figures.back();
}

void Record::note(const std::string& sentence) {
  std::printf("%s\n", sentence.c_str());
  sections_.back().notes.push_back(sentence);
}

void Record::table(const Table& table) { sections_.back().tables.push_back(table.markdown()); }

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
  Json json{{"machine", machine()},
            {"commit", commit()},
            {"targets", targets()},
            {"missed", missed()},
            {"sections", Json::array()}};
  for (const Section& section : sections_) {
    Json figures = Json::array();
    for (const Figure& figure : section.figures) figures.push_back(json_of(figure));
    json["sections"].push_back({{"name", section.name}, {"figures", figures}, {"notes", section.notes}});
  }
  std::filesystem::create_directories(folder);
  write_file(folder / "performance.json", json.dump(2) + "\n");
}

void Record::write_documentation(const std::filesystem::path& document) const {
  for (const Section& section : sections_) {
    std::string text;
    for (const std::string& table : section.tables) text += table + "\n";
    for (const std::string& note : section.notes) text += note + "\n\n";
    text += "Measured on " + machine() + "; commit " + commit() + ".\n";
    replace_section(document, section.name, text);
  }
}

}  // namespace moat::performance
