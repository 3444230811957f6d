#include "app/script_study.hpp"

#include <dlfcn.h>

#include <charconv>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "app/progress_bar.hpp"
#include "app/script_parts.hpp"
#include "app/stop_signals.hpp"
#include "base/check.hpp"
#include "base/sha256.hpp"
#include "output/csv_writer.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

// Options on which no number depends.
const std::set<std::string> without_influence{"out", "threads", "retry", "case", "cases", "quiet", "json"};

std::size_t whole_number(std::string_view text, const std::string& option, const std::string& whole) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw InputError{option + ": \"" + whole + "\" is not allowed. Write --case 17, or --cases 0:100 for 0 to 99."};
  return value;
}

std::optional<std::pair<std::size_t, std::size_t>> part_of(const std::optional<std::string>& one,
                                                           const std::optional<std::string>& several) {
  if (one && several) throw InputError{"--case and --cases: give one of them."};
  if (one) {
    const std::size_t number = whole_number(*one, "--case", *one);
    return {{number, number + 1}};
  }
  if (!several) return std::nullopt;
  const std::size_t colon = several->find(':');
  if (colon == std::string::npos) whole_number("", "--cases", *several);
  const std::string_view text{*several};
  return {{whole_number(text.substr(0, colon), "--cases", *several),
           whole_number(text.substr(colon + 1), "--cases", *several)}};
}

/// Of the library that this program runs with.
std::string hash_of_library() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&sha256_of_file), &info) == 0 || info.dli_fname == nullptr) return "";
  return sha256_of_file(info.dli_fname).value_or("");
}

[[noreturn]] void end_program(int exit_code) {
  std::cout.flush();
  std::exit(exit_code);
}

std::string part_name(const std::pair<std::size_t, std::size_t>& part) {
  return ".cases_" + std::to_string(part.first) + "_" + std::to_string(part.second);
}

}  // namespace

ScriptStudy::ScriptStudy(CommandLine& line, Ranks* ranks, const JsonOutput* json)
    : line_{&line}, ranks_{ranks}, json_{json} {
  const fs::path preset = fs::path{"results"} / line.program();
  options_.folder = line.look_up("out", preset.string(), "results folder; a study that is there goes on", "FOLDER")
                        .value_or(preset.string());
  const auto threads = line.look_up("threads", "0", "that compute cases; 0: one per core", "INTEGER");
  const auto one = line.look_up("case", "", "compute this case alone, counted from 0, into a file of its own", "N");
  const auto several = line.look_up("cases", "", "compute the cases A to B - 1 alone, into a file of their own", "A:B");
  line.add_flag("retry", options_.retry, "compute cases that failed or did not converge once more");
  line.add_flag("quiet", options_.quiet, "print answers, warnings and errors only");
  line.add_json_flag();
  if (threads) options_.threads = static_cast<int>(whole_number(*threads, "--threads", *threads));
  options_.part = part_of(one, several);
}

StudyIdentity ScriptStudy::identity(const Provenance& origin) const {
  StudyIdentity identity{{"script", origin.script_sha256},
                         {"program", sha256_of_file("/proc/self/exe").value_or("")},
                         {"library", hash_of_library()}};
  for (const auto& [name, value] : line_->values())
    if (!without_influence.contains(name)) identity.emplace_back("option --" + name, value);
  return identity;
}

StudyResult ScriptStudy::run(const StudyCases& cases, const std::function<StudyResult(const StudyOptions&)>& compute,
                             StudyOptions options, const std::string& name, const Provenance& origin,
                             const std::string& title) {
  const StopSignals signals;
  const fs::path file = options_.folder / (name + (options_.part ? part_name(*options_.part) : "") + ".db");
  const bool tells = speaks() && !options_.quiet;
  if (options_.threads > 0) options.threads = options_.threads;
  options.ranks = ranks_;
  options.part = options_.part;
  options.keep_failures = true;
  options.stop = [] { return StopSignals::received() != 0; };
  std::optional<StudyStore> store;
  if (speaks()) {
    store.emplace(file, cases, identity(origin),
                  StudySession{.title = title,
                               .command_line = origin.command_line,
                               .moat_version = origin.moat_version,
                               .git_commit = origin.git_commit,
                               .date = origin.date,
                               .engine = engine(options)});
    if (options_.retry) store->forget_failures();
    options.store = &*store;
  }
  ProgressBar bar{name};
  if (!tells)
    options.progress = {};
  else if (!options.progress)
    options.progress = [&](const StudyProgress& now) { bar(now); };
  if (tells) std::cout << title << ": " << name << ", " << cases.count() << " cases\n" << std::flush;
  try {
    StudyResult result = compute(options);
    store.reset();
    if (tells) bar.clear();
    if (speaks()) print_failures(result, name);
    if (options_.part) {
      report_.studies.push_back({file.stem().string(), result});
      write_json(title);
      end_of_part(result, file, name);
    }
    if (speaks()) write_csv(result.case_table(), options_.folder / (name + ".csv"));
    report_.studies.push_back({name, result});
    return result;
  } catch (const StudyStopped& stopped) {
    store.reset();
    if (tells) bar.clear();
    if (speaks())
      std::cerr << "moat: " << StopSignals::name() << ". " << stopped.what() << " They are in " << file.string()
                << "\nmoat: to go on: " << origin.command_line << "\n";
    end_program(speaks() ? StopSignals::exit_code() : 0);
  }
}

std::string ScriptStudy::engine(const StudyOptions& options) const {
  const std::string threads = options.threads > 0 ? std::to_string(options.threads) + " threads" : "all cores";
  if (ranks_ == nullptr) return threads;
  return std::to_string(ranks_->count()) + " ranks" + (options.threads > 1 ? " of " + threads : "");
}

void ScriptStudy::end_of_part(const StudyResult& result, const fs::path& file, const std::string& name) const {
  if (speaks() && !options_.quiet)
    std::cout << "Cases " << options_.part->first << " to " << options_.part->second - 1 << " are in " << file.string()
              << "\nPut parts together: moat study merge " << (options_.folder / (name + ".db")).string()
              << " PART ...\n";
  end_program(result.count(CaseState::failed) > 0          ? exit_error
              : result.count(CaseState::not_converged) > 0 ? exit_no_convergence
                                                           : 0);
}

void ScriptStudy::print_failures(const StudyResult& result, const std::string& name) {
  const std::string failures = failure_message(result);
  if (!failures.empty()) std::cerr << "moat: warning: " << name << ": " << failures << "\n";
}

void ScriptStudy::answer(const std::string& sentence) {
  report_.answers.push_back(sentence);
  std::cout << sentence << "\n" << std::flush;
}

void ScriptStudy::write_json(const std::string& title) const {
  if (json_ == nullptr || !speaks()) return;
  using Json = nlohmann::ordered_json;
  Json json{{"title", title}, {"results_folder", options_.folder.string()}, {"studies", Json::array()}};
  for (const auto& [name, result] : report_.studies)
    json["studies"].push_back(Json{{"name", name},
                                   {"file", (options_.folder / (name + ".db")).string()},
                                   {"cases", result.cases().count()},
                                   {"done", result.count(CaseState::done)},
                                   {"not_converged", result.count(CaseState::not_converged)},
                                   {"failed", result.count(CaseState::failed)},
                                   {"open", result.count(CaseState::open)}});
  json["answers"] = report_.answers;
  json_->write(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

int ScriptStudy::finish(const Provenance& origin, const std::string& title) {
  report_.title = title;
  report_.provenance = origin;
  std::size_t failed = 0, without_solution = 0;
  std::string files = "report.html";
  for (const NamedStudy& study : report_.studies) {
    failed += study.result.count(CaseState::failed);
    without_solution += study.result.count(CaseState::not_converged);
    files += ", " + study.name + ".csv, " + study.name + ".db";
  }
  if (speaks()) write_study_report(report_, options_.folder);
  write_json(title);
  if (!options_.quiet) std::cout << "Results: " << options_.folder.string() << "/  (" << files << ")\n" << std::flush;
  if (without_solution > 0) return exit_no_convergence;
  return failed > 0 ? exit_error : 0;
}

}  // namespace moat
