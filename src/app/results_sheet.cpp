#include "app/results_sheet.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "app/study_json.hpp"
#include "base/error.hpp"
#include "base/text/number_format.hpp"
#include "base/units.hpp"
#include "output/files/peak_table.hpp"
#include "output/files/results_folder.hpp"
#include "study/study_text.hpp"

namespace moat {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

double number_or_nan(const Json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string text_or_nothing(const Json& value) { return value.is_string() ? value.get<std::string>() : ""; }

Peak peak_in(const Json& json) {
  return {.quantity = json.at("quantity"),
          .where = json.at("where"),
          .value = json.at("value"),
          .unit = json.at("unit"),
          .time = json.at("time"),
          .error = number_or_nan(json.at("error")),
          .side = text_or_nothing(json.at("side"))};
}

GapClearance clearance_in(const Json& json) {
  return {.where = json.at("where"),
          .clearance = json.at("clearance"),
          .left = json.at("clearance_left"),
          .time = json.at("time"),
          .error = number_or_nan(json.at("error"))};
}

CaseResult essence_of(const Json& summary) {
  CaseResult result;
  result.title = summary.at("title");
  result.provenance.command_line = text_or_nothing(summary.at("provenance").at("command_line"));
  result.provenance.date = text_or_nothing(summary.at("provenance").at("date"));
  result.provenance.moat_version = summary.at("moat_version");
  const Json& motion = summary.at("motion");
  result.motion.name = motion.at("name");
  result.motion.peak_acceleration = motion.at("peak_acceleration");
  result.motion.peak_velocity = motion.at("peak_velocity");
  result.motion.duration = motion.at("duration");
  const std::set<std::string> constant = summary.value("constant_quantities", std::set<std::string>{});
  for (const Json& each : summary.at("peaks")) {
    const Peak peak = peak_in(each);
    if (constant.contains(peak.quantity)) continue;
    const auto same =
        std::ranges::find_if(result.peaks, [&](const Peak& known) { return known.quantity == peak.quantity; });
    if (same == result.peaks.end())
      result.peaks.push_back(peak);
    else if (peak.magnitude() > same->magnitude())
      *same = peak;
  }
  for (const Json& each : summary.at("clearances")) {
    const GapClearance gap = clearance_in(each);
    if (result.clearances.empty())
      result.clearances.push_back(gap);
    else if (gap.left < result.clearances.front().left)
      result.clearances.front() = gap;
  }
  result.warnings = summary.at("warnings").get<std::vector<std::string>>();
  return result;
}

Json read_json(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) throw FileError{file.string() + ": cannot be read."};
  return Json::parse(std::string{std::istreambuf_iterator<char>{stream}, {}});
}

std::string motion_line(const MotionFacts& motion) {
  return "motion    " + motion.name + ", PGA " + to_significant(motion.peak_acceleration / standard_gravity, 4) +
         " g, PGV " + to_significant(100.0 * motion.peak_velocity, 4) + " cm/s, " + to_significant(motion.duration, 4) +
         " s\n";
}

std::string text_of_run(const CaseResult& run, std::size_t impacts) {
  std::string text = run.title + "\n" + motion_line(run.motion);
  if (!run.provenance.command_line.empty()) text += "computed  by " + run.provenance.command_line + "\n";
  text += "          on " + run.provenance.date + " with moat " + run.provenance.moat_version + "\n\n";
  text += "largest of every quantity\n" + peak_table(run);
  if (!run.clearances.empty()) text += "\nsmallest " + clearance_table(run);
  text += "\n" + std::to_string(impacts) + (impacts == 1 ? " impact\n" : " impacts\n");
  for (const std::string& warning : run.warnings) text += "warning: " + warning + "\n";
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

}  // namespace

ResultsSheet read_results(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw FileError{folder.string() +
                    ": there is no such folder. A script names the folder of its results at its end."};
  ResultsSheet sheet{.folder = folder, .page = folder / results_file::report};
  if (!fs::exists(sheet.page)) sheet.page.clear();
  if (const fs::path summary = folder / results_file::summary; fs::exists(summary)) {
    try {
      const Json json = read_json(summary);
      sheet.run = essence_of(json);
      sheet.impacts = json.at("impacts");
    } catch (const Json::exception& problem) {
      throw FileError{summary.string() + ": this is not the summary of a run (" + problem.what() +
                      "). Run the script again."};
    }
  }
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder})
    if (entry.path().extension() == ".db") files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files) sheet.studies.emplace_back(file.filename().string(), read_study(file));
  std::ifstream marker{folder / results_file::unfinished};
  const std::string unfinished =
      "these results are unfinished: " + std::string{std::istreambuf_iterator<char>{marker}, {}};
  if (sheet.run && marker.is_open()) sheet.run->warnings.insert(sheet.run->warnings.begin(), unfinished);
  if (!sheet.run && sheet.studies.empty())
    throw FileError{folder.string() + ": " +
                    (marker.is_open() ? unfinished
                                      : "there are no results here, neither summary.json nor a study. A script names "
                                        "the folder of its results at its end.")};
  return sheet;
}

std::string text_of(const ResultsSheet& sheet) {
  std::string text;
  if (sheet.run) text += text_of_run(*sheet.run, sheet.impacts);
  for (const auto& [name, study] : sheet.studies) text += name + "\n" + description_of(study);
  if (!sheet.page.empty()) text += "\nThe whole report: " + sheet.page.string() + "\n";
  return text;
}

std::string json_of(const ResultsSheet& sheet) {
  Json json{{"folder", sheet.folder.string()}};
  json["report"] = sheet.page.empty() ? Json{} : Json(sheet.page.string());
  if (sheet.run) {
    const CaseResult& run = *sheet.run;
    json["title"] = run.title;
    json["motion"] = {{"name", run.motion.name},
                      {"peak_acceleration", run.motion.peak_acceleration},
                      {"peak_velocity", run.motion.peak_velocity},
                      {"duration", run.motion.duration}};
    json["largest_peaks"] = Json::array();
    for (const Peak& peak : run.peaks)
      json["largest_peaks"].push_back(Json{{"quantity", peak.quantity},
                                           {"where", peak.where},
                                           {"value", peak.value},
                                           {"unit", peak.unit},
                                           {"time", peak.time},
                                           {"error", peak.error}});
    json["smallest_clearance"] = nullptr;
    for (const GapClearance& gap : run.clearances)
      json["smallest_clearance"] = {{"where", gap.where},
                                    {"clearance", gap.clearance},
                                    {"clearance_left", gap.left},
                                    {"unit", "m"},
                                    {"time", gap.time}};
    json["impacts"] = sheet.impacts;
    json["warnings"] = run.warnings;
  }
  json["studies"] = Json::array();
  for (const auto& [name, study] : sheet.studies) json["studies"].push_back(json_of(name, study));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace moat
