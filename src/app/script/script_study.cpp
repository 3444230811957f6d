#include "app/script/script_study.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "analyses/questions/answer_charts.hpp"
#include "app/progress_bar.hpp"
#include "app/script/script_origin.hpp"
#include "app/script/script_parts.hpp"
#include "app/script/stop_signals.hpp"
#include "base/check.hpp"
#include "base/text/number_format.hpp"
#include "base/text/terminal.hpp"
#include "design/sheet_page.hpp"
#include "motions/readers/record.hpp"
#include "motions/readers/record_folder.hpp"
#include "output/files/building_parts.hpp"
#include "output/files/results_folder.hpp"
#include "study/floor_spectra_of_records.hpp"
#include "study/profiles.hpp"
#include "study/statistics.hpp"
#include "study/study_text.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

// A study over records has files of its name with these endings.
constexpr const char *statistics_ending = "_statistics.csv", *floor_spectra_ending = "_floor_spectra.csv";

[[noreturn]] void end_program(int exit_code) {
  std::cout.flush();
  std::exit(exit_code);
}

std::string part_name(const std::pair<std::size_t, std::size_t>& part) {
  return ".cases_" + std::to_string(part.first) + "_" + std::to_string(part.second);
}

std::string in_threads(int threads) {
  if (threads == 0) threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

// "210 cases in 14.2 s on 2 threads; largest memory 182 MB"
std::string cost_of(const StudyProgress& computed, const std::string& engine) {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  constexpr double kib_per_mb = 1e6 / 1024.0;  // Linux counts in KiB
  return std::to_string(computed.computed) + " cases in " + to_significant(computed.seconds, 3) + " s on " + engine +
         "; largest memory " + to_fixed(static_cast<double>(usage.ru_maxrss) / kib_per_mb, 0) + " MB\n";
}

int exit_code_of(std::size_t failed, std::size_t without_solution) {
  return without_solution > 0 ? exit_no_convergence : failed > 0 ? exit_error : 0;
}

}  // namespace

ScriptStudy::ScriptStudy(CommandLine& line, Ranks* ranks, const JsonOutput* json)
    : line_{&line}, ranks_{ranks}, json_{json}, options_{line} {}

StudyResult ScriptStudy::run(const StudyCases& cases, const std::function<StudyResult(const StudyOptions&)>& compute,
                             StudyOptions options, const std::string& name, const Provenance& origin,
                             const std::string& title) {
  check_name(name);
  choose_part(cases);
  report_.title = title;
  report_.provenance = origin;
  report_.records = record_folder_notes();
  const StopSignals signals;
  const fs::path file = options_.folder / (name + (options_.part ? part_name(*options_.part) : "") + ".db");
  const bool reports = speaks() && !options_.quiet;
  if (options_.threads > 0) options.threads = options_.threads;
  const StudySession now = session(origin, title, options.threads);
  options.ranks = ranks_;
  options.part = options_.part;
  options.keep_failures = true;
  options.stop = [] { return StopSignals::received() != 0; };
  std::optional<StudyStore> store;
  if (speaks()) {
    for (const std::string& mine : {std::string{"report.html"}, name + ".csv", std::string{"pictures"}})
      if (!options_.part) require_own(options_.folder / mine);
    store.emplace(file, cases, identity_of_script(*line_, origin, ScriptStudyOptions::without_influence), now,
                  options_.accept_changes ? StudyChanges::accept : StudyChanges::refuse);
    if (options_.retry) store->forget_failures();
    options.store = &*store;
  }
  ProgressBar bar{name};
  StudyProgress last;
  options.progress = [&, show = std::move(options.progress)](const StudyProgress& progress) {
    last = progress;
    if (reports && show) show(progress);
    if (reports && !show) bar(progress);
  };
  for (const std::string& note : report_.records)
    if (reports && report_.studies.empty()) print_text(std::cout, note + "\n");
  if (reports) print_text(std::cout, title + ": " + name + ", " + std::to_string(cases.count()) + " cases\n");
  const auto close = [&](const std::string& ending) {
    if (store) store->end_session(ending);
    store.reset();
    if (reports) bar.clear();
  };
  try {
    StudyResult result = compute(options);
    close("finished");
    if (reports && last.computed > 0) print_text(std::cout, cost_of(last, now.engine));
    if (reports && !options_.part) print_text(std::cout, case_lines(result));
    if (const std::string warning = failure_message(result); speaks() && !warning.empty())
      print_text(std::cerr, "moat: warning: " + name + ": " + warning + "\n");
    if (options_.part) {
      report_.studies.push_back({file.stem().string(), result});
      write_json();
      end_of_part(result, file, name);
    }
    keep(result, name);
    return result;
  } catch (const StudyStopped& stopped) {
    close(std::string{"stopped by "} + StopSignals::name());
    end_at_stop(stopped, file, name);
  } catch (...) {
    // main() may be left without unwinding; the file is closed all the same.
    store.reset();
    throw;
  }
}

// It becomes the names of files.
void ScriptStudy::check_name(const std::string& name) const {
  const Check check{"Script::study", name};
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_' || c == ' '; };
  check.that(!name.empty() && std::ranges::all_of(name, allowed), "this cannot be the name of a study.",
             "Use letters, digits, blanks, - and _.");
  check.that(std::ranges::find(report_.studies, name, &NamedStudy::name) == report_.studies.end(),
             "there is a study of this name.", "Give every study of a script a name of its own, as last argument.");
}

void ScriptStudy::choose_part(const StudyCases& cases) {
  if (!options_.part) return;
  auto& [first, last] = *options_.part;
  const std::size_t count = cases.count();
  Check{"--cases", ""}.that(first < last && first < count,
                            std::to_string(first) + ":" + std::to_string(last) + " is not allowed.",
                            "The cases are 0:" + std::to_string(count) + "; the last is not included.");
  last = std::min(last, count);
}

StudySession ScriptStudy::session(const Provenance& origin, const std::string& title, int threads) const {
  std::string engine = in_threads(threads);
  if (ranks_ != nullptr)
    engine = std::to_string(ranks_->count()) + " ranks" + (threads > 1 ? ", the first with " + engine : "");
  return {.title = title,
          .command_line = origin.command_line,
          .moat_version = origin.moat_version,
          .git_commit = origin.git_commit,
          .date = origin.date,
          .engine = engine};
}

void ScriptStudy::keep(const StudyResult& result, const std::string& name) {
  NamedStudy& study = report_.studies.emplace_back(NamedStudy{name, result});
  if (!speaks()) return;
  StudyAnswers answers = answers_of(result);
  study.answers = std::move(answers.sentences);
  study.pictures = std::move(answers.pictures);
  if (const std::string axis = axis_of_records(result); !axis.empty()) study.statistics = statistics_over(result, axis);
  const auto path = [&](const std::string& ending) { return options_.folder / (name + ending); };
  const auto write_cases = [&] {
    require_own(path(".csv"));
    write_csv(result, path(".csv"));
  };
  const auto write_statistics = [&] {
    if (!study.statistics.empty()) write_own_csv(table_of(study.statistics), path(statistics_ending));
  };
  const auto write_floor_spectra = [&] {
    if (const Table table = floor_spectra_table(study.statistics); table.rows() > 0)
      write_own_csv(table, path(floor_spectra_ending));
  };
  const auto write_records = [&] {
    if (report_.records.empty()) return;
    require_own_table(options_.folder / results_file::records, "file,channel,record,component");
    write_record_table(options_.folder / results_file::records);
  };
  const auto write_report = [&] { write_study_report(report_, options_.folder); };
  write_all(std::array<std::function<void()>, 5>{write_cases, write_statistics, write_floor_spectra, write_records,
                                                 write_report});
}

void ScriptStudy::end_of_part(const StudyResult& result, const fs::path& file, const std::string& name) const {
  if (speaks() && !options_.quiet)
    print_text(std::cout, "Cases " + std::to_string(options_.part->first) + " to " +
                              std::to_string(options_.part->second - 1) + " are in " + file.string() +
                              "\nPut parts together: moat study merge " + (options_.folder / (name + ".db")).string() +
                              " PART ...\n");
  end_program(exit_code_of(result.count(CaseState::failed), result.count(CaseState::not_converged)));
}

void ScriptStudy::end_at_stop(const StudyStopped& stopped, const fs::path& file, const std::string& name) {
  if (!speaks()) end_program(0);
  print_text(std::cerr, std::string{"moat: "} + StopSignals::name() + ". " + stopped.what() + " They are in " +
                            file.string() + "\n");
  if (!options_.part) {
    try {
      keep(stopped.result, name);
    } catch (const Error& error) {
      print_text(std::cerr, std::string{"moat: warning: "} + error.what() + "\n");
    }
    write_json();
  }
  print_text(std::cerr,
             "moat: to go on: " + command_to_go_on(line_->arguments(), ranks_ != nullptr ? ranks_->count() : 0) + "\n");
  end_program(StopSignals::exit_code());
}

void ScriptStudy::add_profiles(const Model& like) {
  CaseResult result;
  result.model = facts_of(like);
  result.buildings = parts_of_buildings(like);
  report_.studies.back().profiles = profiles_over_records(report_.studies.back().result, std::move(result));
}

void ScriptStudy::add_charts(const std::vector<Chart>& charts) {
  std::vector<Chart>& all = report_.studies.back().profiles;
  all.insert(all.end(), charts.begin(), charts.end());
}

void ScriptStudy::answer(const std::string& sentence) {
  report_.answers.push_back(sentence);
  print_text(std::cout, sentence + "\n");
}

void ScriptStudy::write_json() const {
  if (json_ != nullptr && speaks()) json_->write(json_of(report_, options_.folder));
}

int ScriptStudy::finish(const std::vector<DesignSheet>& sheets) {
  std::size_t failed = 0, without_solution = 0;
  std::string files = "report.html";
  for (const NamedStudy& study : report_.studies) {
    failed += study.result.count(CaseState::failed);
    without_solution += study.result.count(CaseState::not_converged);
    files += ", " + study.name + ".csv, " + study.name + ".db";
    if (!study.statistics.empty()) files += ", " + study.name + statistics_ending;
    if (std::ranges::find(study.statistics, "floor_sa", &RecordStatistics::quantity) != study.statistics.end())
      files += ", " + study.name + floor_spectra_ending;
  }
  if (!sheets.empty()) files += std::string{", "} + results_file::design_sheet;
  if (speaks()) {
    if (const fs::path file = options_.folder / results_file::design_sheet; !sheets.empty()) {
      require_own(file);
      write_design_sheets(sheets, file);
    }
    for (const DesignSheet& sheet : sheets)
      if (const auto rules = sheet.rules(); !rules.empty()) answer(rules.front()->verdict);
    write_study_report(report_, options_.folder);
  }
  write_json();
  if (!options_.quiet) print_text(std::cout, "Results: " + options_.folder.string() + "/  (" + files + ")\n");
  return exit_code_of(failed, without_solution);
}

}  // namespace moat
