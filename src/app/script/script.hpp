// The command line of an input script.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>

#include "analyses/questions/study.hpp"
#include "analyses/questions/suite.hpp"
#include "analyses/time_history/transient_options.hpp"
#include "base/quantity.hpp"
#include "model/model.hpp"
#include "motions/ground_motion.hpp"
#include "motions/plan_motion.hpp"
#include "output/charts/chart.hpp"
#include "output/charts/heat_map.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

class CaseRun;
class KeptRun;
class ResultsFolder;
class ScriptStudy;
struct DesignSheet;

/// From now on an exception that leaves main() is printed as one message to standard error, and ends the program with
/// exit code 1. Returns true. Every Script does it.
bool report_exceptions_that_leave_main();

#ifdef MOAT_IS_SCRIPT
// The launcher and moat_add_script() compile scripts with MOAT_IS_SCRIPT: here also before the Script exists.
inline const bool exceptions_are_reported = report_exceptions_that_leave_main();
#endif

/// Turns a main() into a program with options, help, progress, results folder and exit codes.
///
///     int main(int argc, char** argv) {
///       Script script{argc, argv, "Five-storey isolated building inside a moat"};
///       const Length gap = script.length("gap", 10 * cm, "clearance on each side");   // --gap "12 cm"
///       const GroundMotion motion = script.motion(near_fault_pulse());                // --record FILE
///       Model model;
///       ...
///       return script.run(model, motion);
///     }
///
/// Every function that takes a name adds an option --name and returns its value at once: the default, or the text on
/// the command line, with its unit. run() checks all options, prints the text of --help, and refuses unknown options.
///
/// Errors: an exception that leaves main() is printed as one message to standard error and ends the program with exit
/// code 1; in a program of your own, once a Script exists. Exit codes: 0 done; 1 bad input or another error; 2 wrong
/// usage of the command line; 3 a step did not converge (the results up to that step are in the results folder). Codes
/// 130, 143, 138 and 129: stopped by SIGINT (Ctrl-C), SIGTERM, SIGUSR1 and SIGHUP (the results up to then are there;
/// with --force beside old ones, in a folder with a new number).
class Script {
 public:
  Script(int argc, char** argv, std::string title);  ///< The arguments of main(), and a title for reports.
  ~Script();
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;

  /// Throw InputError for text that is not a number with a unit of the right dimension. A name is made of letters,
  /// digits, - and _, and may be used once.
  Length length(const std::string& name, Length preset, const std::string& help);
  Time time(const std::string& name, Time preset, const std::string& help);     ///< --name "2 s"
  Mass mass(const std::string& name, Mass preset, const std::string& help);     ///< --name "500 t"
  Force force(const std::string& name, Force preset, const std::string& help);  ///< --name "1.9 MN"
  Speed speed(const std::string& name, Speed preset, const std::string& help);  ///< --name "0.8 m/s"
  Acceleration acceleration(const std::string& name, Acceleration preset, const std::string& help);  ///< --name 0.4g
  Stiffness stiffness(const std::string& name, Stiffness preset, const std::string& help);  ///< --name "1 GN/m"
  /// --name "2e9 N/m^1.5"
  HertzStiffness hertz_stiffness(const std::string& name, HertzStiffness preset, const std::string& help);
  double number(const std::string& name, double preset, const std::string& help);  ///< --name 0.65
  int integer(const std::string& name, int preset, const std::string& help);       ///< --name 5
  /// --name word; where there are choices, one of them.
  std::string text(const std::string& name, const std::string& preset, const std::string& help,
                   const std::vector<std::string>& choices = {});

  /// Adds --record FILE (read_channels() lists the formats; plain text needs --record-unit g, and may need
  /// --record-step and --record-columns) and --record-up FILE, the vertical component, and returns that motion, else
  /// the preset.
  GroundMotion motion(const GroundMotion& preset);

  /// Adds --record FILE, with both components in it (or a folder with the files of one record, read_record(), with
  /// --records-table FILE.csv), or with --record-2 FILE for the second one. Adds also --record-up FILE, and --incidence
  /// NUMBER, the angle in degrees from +x to the first component. Returns the motion of all components, else the
  /// preset.
  PlanMotion plan_motion(const PlanMotion& preset);

  /// Before run(): calls the observer too, at every step; it must outlive the run. The quantities of a QuantityRecorder
  /// appear in histories, peaks and report.
  void attach(StepObserver& observer);

  /// Computes the model under the motion, shows progress and peaks, writes the results folder, and returns the exit
  /// code. Adds --out, --force, --step, --tolerance, --integrator, --end, --frame-interval, --checkpoint, --resume,
  /// --check, --sensitivity, --no-sensitivity, --quiet, --json. With --resume a run that was killed or stopped goes on
  /// from its checkpoint, and its results are those of one that nothing stopped; an observer needs its archive() for
  /// it. With --json standard output holds summary.json alone, with the member "results_folder" in front, and all else
  /// goes to standard error. The observers are attached before. Throws InputError for one that is null.
  int run(const Model& model, const GroundMotion& motion, std::initializer_list<StepObserver*> observers = {});
  /// Runs with options of the analysis that the command line lacks; those that it has are its defaults:
  ///
  ///     return script.run(model, motion, {.integrator = GeneralizedAlpha{.spectral_radius = 0.9}});
  int run(const Model& model, const GroundMotion& motion, const TransientOptions& options,
          std::initializer_list<StepObserver*> observers = {});

  /// Computes a study on all cores, keeps it in the file NAME.db of the results folder, and writes NAME.csv and
  /// report.html beside it, also where it is stopped. A study that is there goes on: only cases that it lacks are
  /// computed. Adds --out, --threads, --case, --cases, --retry, --accept-changes, --quiet, --json at the first call,
  /// then checks all options, and answers --help by ending the program.
  ///
  ///     const StudyResult study = script.study({gap, record_axis("record", records)}, [&](const StudyCase& each) {
  ///       StudyModel one{Model{}, records[each.position("record")]};
  ///       ...
  ///       return one;
  ///     });
  ///     ...
  ///     return script.finish();
  ///
  /// Ctrl-C and SIGTERM let cases in flight end, and end the program; the command that goes on is printed. --case and
  /// --cases compute a part of the first study into a file of its own and end the program. Cases that fail or do not
  /// converge are states in the result and are printed; options.keep_failures, stop, store and part are not used.
  ///
  /// Throws InputError where the file holds a study with other axes, or made by another script, library, record or
  /// value of an option, and FileError where it cannot be written.
  StudyResult study(const StudyCases& cases, const std::function<StudyModel(const StudyCase&)>& make,
                    const StudyOptions& options = {}, const std::string& name = "study");
  /// Computes a study in the same way, of cases that compute their results themselves.
  StudyResult study(const StudyCases& cases, const std::function<StudyRecord(const StudyCase&)>& compute,
                    const StudyOptions& options = {}, const std::string& name = "study");

  /// Computes a suite as a study: records with bounds, eccentricities and directions. As of every study over records,
  /// the report has statistics and profiles over them, and NAME_statistics.csv has those of all results; of a
  /// ScaledSuite also factors and spectra. Of every bound the case with the largest deformation of an isolator is
  /// computed once more, for the loops of its isolators.
  ///
  ///     const StudyResult result = script.suite({pairs, {.bounds = bounds, .eccentricity = 0.05}},
  ///                                             [&](const SuiteCase& each) { ... return model; });
  StudyResult suite(const Suite& suite, const std::function<Model(const SuiteCase&)>& make,
                    const std::string& name = "suite");

  /// Puts a sentence, and prints it; or a picture, into the report of the studies. Pictures are written as SVG too.
  /// Call them after the first study; before it they throw InputError.
  void answer(const std::string& sentence);
  void show(const Chart& chart);  ///< A picture for the report.
  void show(const HeatMap& map);  ///< A map for the report.
  /// A table for the report; columns in SI units.
  void show(const std::string& title, const Table& table);

  /// Puts a sheet into design_sheet.html of the results folder, one behind the other, and its verdict among the answers
  /// of a study. Before run(), or before finish().
  void design_sheet(const DesignSheet& sheet);

  /// After the last study: writes report.html with all answers, prints where the results are. With --json standard
  /// output holds { "title", "results_folder", "studies": [ { "name", "file", "cases", "done", "not_converged",
  /// "failed", "open" }
  /// ], "answers": [ ... ] } alone. Returns the exit code: 0, 3 if cases did not converge, 1 if cases failed.
  int finish();

  /// For a script with neither run() nor study(), after its last option: prints --help, or refuses unknown options, by
  /// ending the program. Without it that happens at the end of main().
  void check_options();

 private:
  struct Parts;
  struct RunOptions;
  struct Outcome;
  // The exit code, if there is nothing to compute.
  std::optional<int> read_options(const GroundMotion& motion, RunOptions& options);
  Outcome compute(std::optional<CaseRun>& computed, KeptRun& kept, const RunOptions& options);
  static int print(const Outcome& outcome, const RunOptions& options, const std::filesystem::path& folder);
  ScriptStudy& study_parts();
  ScriptStudy& studies_done();
  template <class Q>
  Q quantity(const std::string& name, Q preset, const std::string& help);
  std::unique_ptr<Parts> parts_;
};

}  // namespace moat
