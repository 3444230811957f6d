// OpenSees, if it is installed.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/analysis_state.hpp"
#include "motions/ground_motion.hpp"
#include "peers/building.hpp"
#include "peers/ladders.hpp"

namespace moat::peers {

/// One of the settings in history.tcl.
struct OpenSeesSetting {
  std::string name;         ///< "textbook"
  std::string description;  ///< "Newmark, Newton, test on displacements"
  /// Whether friction pendulums become singleFPBearing: its normal force is W + F d/R. Else they become
  /// flatSliderBearing beside a spring, which is the law of moat.
  bool single_bearing = false;
};

/// The value of a parameter of a law. Throws InputError where it has none of this name.
double value_of(const std::vector<Parameter>& parameters, std::string_view name);

/// Writes Tcl that builds the same model on a line: nodes with masses and committed displacement, velocity and
/// acceleration, springs, dampers, bilinear bearings, friction pendulums with Coulomb friction, Bouc-Wen springs, and
/// gaps with `LinearElastic`, `HertzDamp` or `BilinearImpact`. Node i of the model has tag i + 1, the ground tag 0.
/// Returns the tags of the gaps, or of the first storey where there are none. Throws InputError for a law that OpenSees
/// does not have.
std::vector<int> write_opensees_model(const AnalysisState& state, const OpenSeesSetting& setting, std::ostream& tcl);
/// Writes Tcl that builds the same model in plan, at rest: a rigid diaphragm has the tag of its first node plus 1, and
/// points of it are tied to it. Linear springs and dashpots, and bearings that yield on a circle. Throws InputError for
/// other laws.
void write_opensees_plan(const Model& model, std::ostream& tcl);

/// Returns all settings.
const std::vector<OpenSeesSetting>& opensees_settings();

struct OpenSeesRun {
  bool solved = false;          ///< all steps
  double cpu_seconds = 0.0;     ///< of the steps alone, by its own process
  std::vector<double> peaks{};  ///< the values that Compared names
};

/// An interpreter of OpenSees with Tcl, and a folder for its files.
class OpenSees {
 public:
  /// The program that the environment variable OPENSEES names, else `OpenSees` on the path; nothing if there is none.
  /// Throws InputError where OPENSEES names no program.
  static std::optional<OpenSees> find(const std::filesystem::path& folder);

  /// Steps of `step` s from this state of the case's model to the end of the motion or of the case, whichever comes
  /// first. Throws Error where OpenSees prints no result.
  [[nodiscard]] OpenSeesRun run(const AnalysisState& start, const Case& of, double step,
                                const OpenSeesSetting& setting) const;
  /// The line in which the program names its version.
  [[nodiscard]] std::string version() const;

 private:
  OpenSees(std::string program, std::filesystem::path folder);

  std::string program_;
  std::filesystem::path folder_;
};

/// A history of steps of `step` s, with moat's accelerations at the start. One that OpenSees does not solve has no
/// peaks, and so the largest error.
History opensees_history(const OpenSees& opensees, const Case& of, const OpenSeesSetting& setting, double step);

/// Steps from the interval of the motion to a twentieth of it, or with `finer` to an 80th. OpenSees and the case must
/// outlive the ladder.
Ladder opensees_ladder(const std::string& name, const OpenSees& opensees, const Case& of,
                       const OpenSeesSetting& setting, bool finer = false);

}  // namespace moat::peers
