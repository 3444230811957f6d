// Parameter studies: the same question for every combination of some parameters.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analyses/time_history/transient.hpp"
#include "model/model.hpp"
#include "model/with_contacts.hpp"
#include "motions/ground_motion.hpp"
#include "motions/plan_motion.hpp"
#include "output/recorders/floor_spectra.hpp"
#include "study/cases.hpp"
#include "study/engine.hpp"
#include "study/file/store.hpp"
#include "study/outcome.hpp"
#include "study/ranks/ranks.hpp"
#include "study/result.hpp"

namespace moat {

/// The model and the motion of one case.
struct StudyModel {
  Model model;          ///< The structure of this case.
  GroundMotion motion;  ///< The motion of this case.
};

/// An axis of records, called by their names, which must differ; a study that goes on compares the hashes of their
/// files, and of motions made in the program those of their samples.
StudyAxis record_axis(std::string name, const std::vector<GroundMotion>& motions);
/// An axis of pairs of records under the same rules; a pair is called "NWH090 + NWH360".
StudyAxis record_axis(std::string name, const std::vector<PlanMotion>& pairs);

/// The change of all contacts that a case of a study asks for by the axes "contact_stiffness_factor",
/// "restitution_change", "clearance_factor" and "soil_factor", all without unit; a parameter without axis stays.
///
///     study.model = with_contacts(study.model, contact_change(each));   // last in the function that makes the model
ContactChange contact_change(const StudyCase& each);

/// Options of run_study().
struct StudyOptions {
  /// >= 0. Threads that compute cases; 0: one per core. Results do not depend on it.
  int threads = 0;
  /// How the time history of a StudyModel is computed.
  TransientOptions transient{};
  /// Whether every StudyModel runs a second time with finer steps (analyses/case/error_bars.hpp), which costs two to
  /// three times as much again. Every peak then has its error, as a result of its own ("displacement_error" of "base"),
  /// and every case the result "unsettled": 1 if it is, 0 if not. Both are NaN where the second run failed.
  bool error_bars = false;
  /// Whether the results of every StudyModel have its energies ("energy_input" ...), and its outcome the error of the
  /// energy balance. They cost about a third of an analysis.
  bool energies = false;
  /// Floor spectra of every StudyModel, as results "floor_sa" (pseudo-acceleration, m/s^2), and where they are wanted
  /// "floor_sa_absolute", at "floor 5, 5 %, 0.3 s", in plan at "floor 5, x, 5 %, 0.3 s" and "floor 5, corner 2, x, 5 %,
  /// 0.3 s". Empty: none. 100 periods of two floors cost about half of a small model's analysis.
  std::optional<FloorSpectraOptions> floor_spectra{};
  /// Called after every case, by one thread at a time.
  std::function<void(const StudyProgress&)> progress{};
  /// Asked before every case; true ends the study after those in flight, with StudyStopped.
  std::function<bool()> stop{};
  /// Where cases are kept, and taken from if they are there already; must have been opened for the same cases.
  StudyStore* store = nullptr;
  /// Only the cases from the first up to and without the last; the others stay open. Empty: all.
  std::optional<std::pair<std::size_t, std::size_t>> part{};
  /// The ranks of the job (ranks_of_this_job()); every rank calls run_study with the same cases and gets the same
  /// result. Rank 0 has the store, progress, stop and `threads`, 0: one; the others compute one case at a time. Null:
  /// this process alone.
  Ranks* ranks = nullptr;
  /// Whether cases that fail or do not converge are a state in the result, in place of a StudyError.
  bool keep_failures = false;
};

/// Computes `compute` for every case, on all cores.
///
///     const StudyResult result = run_study(
///         {{.name = "gap", .unit = "cm", .values = linearly_spaced(10, 50, 41)},
///          StudyAxis::of_names("record", {"KBU000", "JEN022"})},
///         [&](const StudyCase& each) {
///           StudyModel study{Model{}, motions[each.position("record")]};
///           const auto building = add(study.model, ShearBuilding{...});
///           add(study.model, Moat{.around = building.base, .clearance = each.value("gap") * cm, ...});
///           return study;
///         });
///
/// The function is called from several threads at once: it may only read shared data. The order of the table is that of
/// the cases. No number depends on the number of threads.
///
/// Throws StudyError after the last case if any case threw, StudyStopped if options.stop asked for the end, InputError
/// for an option outside its range, and FileError where the store cannot be written.
StudyResult run_study(const StudyCases& cases, const std::function<StudyRecord(const StudyCase&)>& compute,
                      const StudyOptions& options = {});

/// Computes the models of a study in the same way. The results are the magnitudes of all peaks, as PeakRecorder names
/// them, and the `total_isolator_force` of every building on isolators (IsolatorForces). Models with gaps also have the
/// `clearance_left` of every gap (negative: indented by so much), and the number of `impacts`. `collapsed` is 1 where a
/// storey or an isolator was deformed by more than 3 m or a collapse ended the analysis, else 0. With
/// StudyOptions::error_bars there are also the errors of peaks and clearances:
///
///     result.values("impact_force", "moat");           // N
///     result.values("impact_force_error", "moat");     // N, the first holds to +- this
///     result.values("clearance_left", "moat right");   // m
///     result.values("unsettled", "");                  // 0 or 1
///
/// No histories are kept.
StudyResult run_study(const StudyCases& cases, const std::function<StudyModel(const StudyCase&)>& make,
                      const StudyOptions& options = {});

/// The results of one case of a study: magnitudes of the peaks of one model under one motion, clearances left, the
/// number of impacts, and `collapsed`. With error_bars also "..._error" of peaks and clearances, and "unsettled"
/// (StudyOptions).
StudyRecord peaks_of(const Model& model, const GroundMotion& motion, const TransientOptions& options = {},
                     bool error_bars = false);

}  // namespace moat
