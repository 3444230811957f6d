// The program behind `moat report`: the results in a folder on one screen.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "app/command_line.hpp"
#include "app/study_json.hpp"
#include "base/error.hpp"
#include "base/text/number_format.hpp"
#include "base/text/terminal.hpp"
#include "base/units.hpp"
#include "output/files/peak_table.hpp"
#include "output/files/results_folder.hpp"
#include "study/file/store.hpp"
#include "study/study_text.hpp"

namespace moat {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

double number_or_nan(const Json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string text_or_nothing(const Json& value) { return value.is_string() ? value.get<std::string>() : ""; }

std::string content_of(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw FileError{file.string() + ": cannot be read."};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// The members of summary.json that describe a run in short: of every quantity the largest peak, and the smallest
/// clearance.
Json essence_of(const Json& summary) {
  Json run;
  for (const char* name : {"title", "moat_version", "motion", "impacts", "warnings"}) run[name] = summary.at(name);
  run["computed_by"] = text_or_nothing(summary.at("provenance").at("command_line"));
  run["date"] = text_or_nothing(summary.at("provenance").at("date"));
  Json peaks = Json::array(), smallest;
  const std::set<std::string> constant = summary.value("constant_quantities", std::set<std::string>{});
  const auto size = [](const Json& peak) { return std::abs(peak.at("value").get<double>()); };
  for (const Json& peak : summary.at("peaks")) {
    const auto same =
        std::ranges::find_if(peaks, [&](const Json& each) { return each.at("quantity") == peak.at("quantity"); });
    if (constant.contains(peak.at("quantity"))) continue;
    if (same == peaks.end())
      peaks.push_back(peak);
    else if (size(peak) > size(*same))
      *same = peak;
  }
  for (const Json& gap : summary.at("clearances"))
    if (smallest.is_null() || gap.at("clearance_left") < smallest.at("clearance_left")) smallest = gap;
  run["largest_peaks"] = std::move(peaks);
  run["smallest_clearance"] = std::move(smallest);
  return run;
}

std::string text_of_run(const Json& run) {
  CaseResult tables;
  for (const Json& peak : run.at("largest_peaks"))
    tables.peaks.push_back({.quantity = peak.at("quantity"),
                            .where = peak.at("where"),
                            .value = peak.at("value"),
                            .unit = peak.at("unit"),
                            .time = peak.at("time"),
                            .error = number_or_nan(peak.at("error")),
                            .side = text_or_nothing(peak.at("side"))});
  if (const Json& gap = run.at("smallest_clearance"); !gap.is_null())
    tables.clearances.push_back({.where = gap.at("where"),
                                 .clearance = gap.at("clearance"),
                                 .left = gap.at("clearance_left"),
                                 .time = gap.at("time"),
                                 .error = number_or_nan(gap.at("error"))});
  const Json& motion = run.at("motion");
  const auto number = [&](const char* name, double unit) {
    return to_significant(motion.at(name).get<double>() / unit, 4);
  };
  std::string text = run.at("title").get<std::string>() + "\nmotion    " + motion.at("name").get<std::string>() +
                     ", PGA " + number("peak_acceleration", standard_gravity) + " g, PGV " +
                     number("peak_velocity", 0.01) + " cm/s, " + number("duration", 1.0) + " s\n";
  if (const std::string command = run.at("computed_by"); !command.empty()) text += "computed  by " + command + "\n";
  text += "          on " + run.at("date").get<std::string>() + " with moat " +
          run.at("moat_version").get<std::string>() + "\n\nlargest of every quantity\n" + peak_table(tables);
  if (!tables.clearances.empty()) text += "\nsmallest " + clearance_table(tables);
  const auto impacts = run.at("impacts").get<std::size_t>();
  text += "\n" + std::to_string(impacts) + (impacts == 1 ? " impact\n" : " impacts\n");
  for (const std::string warning : run.at("warnings")) text += "warning: " + warning + "\n";
  return text;
}

Json json_of(const std::string& file, const StoredStudy& study) {
  Json json{{"file", file}, {"title", study.title}};
  json.update(counts_of(study.result));
  json["failures"] = Json::array();
  for (const StudyError::Failure& failure : failures_of(study.result))
    json["failures"].push_back(
        Json{{"case", failure.number}, {"description", failure.description}, {"reason", failure.message}});
  return json;
}

/// The results in a folder, in short: a run, or studies.
struct Report {
  fs::path page;  ///< report.html; empty if there is none
  std::string text;
  Json json;  ///< numbers in SI units
};

/// Throws FileError for a folder that does not exist, that holds no results, or whose summary.json is not one.
Report report_of(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw FileError{folder.string() +
                    ": there is no such folder. A script names the folder of its results at its end."};
  Report report{folder / results_file::report, "", {{"folder", folder.string()}, {"report", nullptr}}};
  if (!fs::exists(report.page)) report.page.clear();
  if (!report.page.empty()) report.json["report"] = report.page.string();
  std::string unfinished;
  if (const fs::path marker = folder / results_file::unfinished; fs::exists(marker))
    unfinished = "these results are unfinished: " + content_of(marker);
  const fs::path summary = folder / results_file::summary;
  if (fs::exists(summary)) {
    try {
      Json run = essence_of(Json::parse(content_of(summary)));
      if (!unfinished.empty()) run["warnings"].insert(run["warnings"].begin(), unfinished);
      report.text += text_of_run(run);
      report.json.update(run);
    } catch (const Json::exception& problem) {
      throw FileError{summary.string() + ": this is not the summary of a run (" + problem.what() +
                      "). Run the script again."};
    }
  }
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder})
    if (entry.path().extension() == ".db") files.insert(entry.path());
  if (files.empty() && !fs::exists(summary))
    throw FileError{folder.string() + ": " +
                    (!unfinished.empty() ? unfinished
                                         : "there are no results here, neither summary.json nor a study. A script "
                                           "names the folder of its results at its end.")};
  report.json["studies"] = Json::array();
  for (const fs::path& file : files) {
    const StoredStudy study = read_study(file);
    report.text += file.filename().string() + "\n" + description_of(study);
    report.json["studies"].push_back(json_of(file.filename().string(), study));
  }
  if (!report.page.empty()) report.text += "\nThe whole report: " + report.page.string() + "\n";
  return report;
}

// Does not return where the page is opened.
int open_page(const fs::path& page) {
  const std::string path = fs::absolute(page).string();
  ::execlp("xdg-open", "xdg-open", path.c_str(), nullptr);
  throw FileError{"there is no program xdg-open. Open " + path + " in a browser."};
}

}  // namespace
}  // namespace moat

int main(int argc, char** argv) {
  using namespace moat;
  CLI::App app{"Shows the results in a folder on one screen", "moat report"};
  std::string folder;
  bool json = false, open = false;
  app.add_option("DIR", folder, "a folder of results, such as results/01_moat_wall")->required();
  app.add_flag("--json", json, "print JSON, all numbers in SI units");
  app.add_flag("--open", open, "open report.html too, with xdg-open");
  return run_command(app, "moat report", argc, argv, [&] {
    const Report report = report_of(folder);
    print_text(std::cout, json ? report.json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n" : report.text);
    if (open && report.page.empty()) throw FileError{folder + ": there is no report.html to open."};
    return open ? open_page(report.page) : 0;
  });
}
