#include "app/script/script.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "analyses/integrators/integrators.hpp"
#include "app/command_line.hpp"
#include "app/law_assumptions.hpp"
#include "app/progress_bar.hpp"
#include "app/results.hpp"
#include "app/script/checkpoint_file.hpp"
#include "app/script/frames_of_script.hpp"
#include "app/script/kept_run.hpp"
#include "app/script/run_options.hpp"
#include "app/script/script_parts.hpp"
#include "app/script/stop_signals.hpp"
#include "base/check.hpp"
#include "base/error.hpp"
#include "base/text/terminal.hpp"
#include "design/sheet_page.hpp"
#include "motions/readers/record.hpp"
#include "motions/readers/record_folder.hpp"
#include "output/files/results_folder.hpp"

namespace moat {
namespace {

// Keeps the command line of the script that runs, for an error before all of its options are known.
const CommandLine* line_of_script = nullptr;

// An exception that leaves main() ends here. The user sees only its message, or the help that was asked for.
[[noreturn]] void report_and_exit() {
  std::cout.flush();
  try {
    if (const std::exception_ptr current = std::current_exception()) std::rethrow_exception(current);
    std::cerr << "moat: terminated without an exception\n";
  } catch (const std::bad_alloc& error) {  // without memory for printable text
    std::cerr << "moat: error: " << reason_of(error) << "\n";
  } catch (const std::exception& error) {
    if (line_of_script != nullptr && line_of_script->help_wanted()) {
      print_text(std::cout, line_of_script->help() +
                                "\nThe script adds further options once this is right: " + error.what() + "\n");
      std::cout.flush();
      std::_Exit(0);
    }
    print_text(std::cerr, std::string{"moat: error: "} + error.what() + "\n");
  } catch (...) {
    std::cerr << "moat: error: an exception that is not a std::exception\n";
  }
  std::fflush(stdout);
  std::_Exit(exit_error);
}

}  // namespace

bool report_exceptions_that_leave_main() {
  std::set_terminate(report_and_exit);
  return true;
}

Script::Script(int argc, char** argv, std::string title)
    : parts_{std::make_unique<Parts>(argc, argv, std::move(title))} {
  report_exceptions_that_leave_main();
  line_of_script = &parts_->line;
  parts_->ranks = ranks_of_this_job();
  // Until every rank has reached the study, the default action of a signal would end the job without order.
  if (parts_->ranks != nullptr) parts_->signals_of_ranks.emplace();
  // All ranks run the script, and one speaks.
  if (!parts_->speaks() && std::freopen("/dev/null", "w", stdout) == nullptr) std::fclose(stdout);
  if (parts_->line.json_wanted()) parts_->json.emplace();
}

Script::~Script() {
  line_of_script = nullptr;
  if (parts_->checked || parts_->line.arguments().empty() || std::uncaught_exceptions() > 0) return;
  // Neither run() nor study() nor check_options() read the line.
  try {
    check_options();
  } catch (...) {
    report_and_exit();
  }
}

void Script::check_options() {
  if (parts_->checked) return;
  parts_->checked = true;
  CommandLine& line = parts_->line;
  if (line.help_wanted()) {
    print_text(std::cout, line.help());
    std::exit(0);
  }
  if (!line.parse()) std::exit(exit_usage);
  parts_->origin.options = line.values();
}

void Script::design_sheet(const DesignSheet& sheet) { parts_->sheets.push_back(sheet); }

void Script::attach(StepObserver& observer) { parts_->observers.push_back(&observer); }

// Result and end of a run.
struct Script::Outcome {
  CaseResult result{};
  std::string failure{};  // empty if it reached its end
  int exit_code = 0;

  // warning: for readers of the files, who must not take them for those of a whole run.
  void fail(const std::string& reason, int code, const std::string& warning) {
    failure += (failure.empty() ? "" : " ") + reason;
    if (exit_code == 0) exit_code = code;
    result.warnings.insert(result.warnings.begin(), warning);
  }
};

int Script::run(const Model& model, const GroundMotion& motion, std::initializer_list<StepObserver*> observers) {
  return run(model, motion, TransientOptions{}, observers);
}

int Script::run(const Model& model, const GroundMotion& motion, const TransientOptions& given,
                std::initializer_list<StepObserver*> observers) {
  if (std::ranges::find(observers, nullptr) != observers.end())
    throw InputError{"Script::run: an observer is null. Give the addresses of observers, such as {&drift}."};
  parts_->observers.insert(parts_->observers.end(), observers);
  RunOptions options;
  options.transient = given;
  if (const auto exit_code = read_options(motion, options)) return *exit_code;
  if (!parts_->speaks()) return 0;  // a single run needs one rank
  const StopSignals signals;
  std::optional<CaseRun> run;
  run.emplace(model, motion,
              CaseOptions{.title = parts_->line.title(),
                          .transient = options.transient,
                          .error_bars = options.check ? ErrorBarMode::always : ErrorBarMode::automatic,
                          .contact_sensitivity = options.contact_sensitivity()});
  for (StepObserver* observer : parts_->observers) run->attach(*observer);
  // Before the run: files may change while it computes.
  const StudyIdentity identity = identity_of_script(parts_->line, parts_->origin, RunOptions::without_influence);
  if (options.resume)
    run->go_on_from(read_checkpoint(folder_with_checkpoint(options.folder) / results_file::checkpoint, identity));
  ResultsFolder folder{options.folder,
                       options.resume  ? WhenFolderExists::go_on
                       : options.force ? WhenFolderExists::overwrite
                                       : WhenFolderExists::use_new_number,
                       parts_->origin.command_line};
  KeptRun kept{*run, folder.path(), options.checkpoint.si(), identity};
  std::optional<FramesOfScript> frames;
  if (options.frame_interval.si() != 0.0)
    run->attach(frames.emplace(model, folder.path(), options.frame_interval.si()));
  Outcome outcome = compute(run, kept, options);
  for (const auto& list : {law_assumptions(outcome.result.model), record_folder_notes()})
    outcome.result.assumptions.insert(outcome.result.assumptions.end(), list.begin(), list.end());
  // Small results are written before a bar could be seen.
  constexpr double many_numbers = 2e6;
  const Table& histories = outcome.result.histories;
  const bool takes_time =
      static_cast<double>(histories.columns.size()) * static_cast<double>(histories.rows()) > many_numbers;
  // A run that failed has its reason already.
  if (frames && !frames->failure().empty() && outcome.failure.empty())
    outcome.fail(frames->failure(), exit_error, "The frames are incomplete: " + frames->failure());
  try {
    // Before the files, for which disk and memory may be too small.
    if (!options.quiet) print_text(std::cout, terminal_summary(outcome.result));
    write_results(outcome.result, folder.path(),
                  takes_time && !options.quiet ? WritingProgress{ProgressBar{"writing", "parts"}} : WritingProgress{});
    if (!parts_->sheets.empty()) write_design_sheets(parts_->sheets, folder.path() / results_file::design_sheet);
    if (!record_folder_notes().empty()) write_record_table(folder.path() / results_file::records);
  } catch (const std::exception& error) {
    const std::string reason = reason_of(error);
    outcome.fail(reason, exit_error, "Files of these results are missing: " + reason);
    outcome.failure += " " + keep_results(outcome.result, folder.path());
  }
  const std::filesystem::path wanted = folder.final_path();
  try {
    if (outcome.exit_code == 0 || outcome.exit_code == exit_no_convergence) kept.end();
    if (!outcome.failure.empty()) folder.finish_incomplete();
    folder.finish();
  } catch (const FileError& error) {
    outcome.fail(error.what(), exit_error, error.what());
  }
  const std::filesystem::path results = folder.path();  // beside the old ones where these could not be replaced
  if (parts_->json && std::filesystem::exists(results / results_file::summary))
    parts_->json->write(summary_with_folder(results));
  const int exit_code = print(outcome, options, results);
  if (results != wanted)
    print_text(std::cerr, "moat: The old results in " + wanted.string() + " stay; those of this run are in " +
                              results.string() + ".\n");
  print_text(std::cerr, kept.message(parts_->line.arguments(), results));
  return exit_code;
}

Script::Outcome Script::compute(std::optional<CaseRun>& computed, KeptRun& kept, const RunOptions& options) {
  CaseRun& run = *computed;
  std::optional<ProgressObserver> progress, progress_of_check, progress_of_contacts;
  if (!options.quiet) {
    for (const std::string& note : record_folder_notes()) print_text(std::cout, note + "\n");
    print_text(std::cout, parts_->line.title() + "\n" + run.transient().motion().description() + "\n");
    run.attach(progress.emplace(run.transient().end_time()));
    // Without --check the second run is over at once.
    if (options.check) run.attach_to_companion(progress_of_check.emplace(run.transient().end_time(), "check"));
    if (options.sensitivity)
      run.attach_to_changed_contacts(progress_of_contacts.emplace(run.transient().end_time(), "sensitivity"));
  }
  Outcome outcome;
  run.stop_when([&] { return kept.stops(); });
  try {
    run.run();
    if (run.stopped()) {
      outcome.failure = std::string{StopSignals::name()} + ". To compute the whole: " + parts_->origin.command_line;
      outcome.exit_code = StopSignals::exit_code();
    }
  } catch (const Error& error) {
    outcome.failure = error.what();
    const bool ended_early = dynamic_cast<const ConvergenceError*>(&error) != nullptr ||
                             dynamic_cast<const RockingError*>(&error) != nullptr;
    outcome.exit_code = ended_early ? exit_no_convergence : exit_error;
  } catch (const std::bad_alloc& error) {
    outcome.failure = reason_of(error);
    outcome.exit_code = exit_error;
  }
  const std::string reached =
      to_text(run.transient().state().time()) + " s of " + to_text(run.transient().end_time()) + " s: ";
  outcome.result = take_result(computed);
  malloc_trim(0);  // writing the files needs the memory of the run, which the C library would keep
  outcome.result.provenance = parts_->origin;
  // Readers of the files must not take them for those of a whole run.
  if (!outcome.failure.empty())
    outcome.result.warnings.insert(outcome.result.warnings.begin(),
                                   "The analysis stopped at " + reached + outcome.failure);
  return outcome;
}

int Script::print(const Outcome& outcome, const RunOptions& options, const std::filesystem::path& folder) {
  using std::filesystem::exists;
  const char* files = exists(folder / results_file::frames)   ? "  (report.html, frames.pvd for ParaView)\n"
                      : exists(folder / results_file::report) ? "  (report.html)\n"
                                                              : "\n";
  if (!options.quiet) print_text(std::cout, "Results: " + folder.string() + "/" + files);
  const auto& warnings = outcome.result.warnings;
  for (std::size_t i = outcome.failure.empty() ? 0 : 1; i < warnings.size(); ++i)
    print_text(std::cerr, "moat: warning: " + warnings[i] + "\n");
  if (!outcome.failure.empty()) print_text(std::cerr, "moat: error: " + outcome.failure + "\n");
  if (outcome.exit_code == 0 && !std::cout) {
    print_text(std::cerr,
               "moat: error: standard output cannot be written; the results are in " + folder.string() + "\n");
    return exit_error;
  }
  return outcome.exit_code;
}

}  // namespace moat
