// OpenSees, if it is installed.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "model/analysis_state.hpp"
#include "motions/ground_motion.hpp"
#include "peers/building.hpp"
#include "peers/ladders.hpp"

namespace moat::peers {

/// Writes Tcl that builds the same model: nodes with masses and committed displacement, velocity and acceleration,
/// springs, dampers, bilinear bearings, and gaps with `LinearElastic` or `HertzDamp`. Node i of the model has tag
/// i + 1, the ground tag 0. Returns the tags of the gaps. Throws InputError for a law that OpenSees does not have.
std::vector<int> write_opensees_model(const AnalysisState& state, std::ostream& tcl);

/// One of the settings in history.tcl.
struct OpenSeesSetting {
  std::string name;         ///< "textbook"
  std::string description;  ///< "Newmark, Newton, test on displacements"
};

/// Returns all settings.
const std::vector<OpenSeesSetting>& opensees_settings();

struct OpenSeesRun {
  bool solved = false;          ///< all steps
  double cpu_seconds = 0.0;     ///< of the steps alone, by its own process
  std::vector<double> peaks{};  ///< base and top displacement, base and top acceleration, impact force
};

/// An interpreter of OpenSees with Tcl, and a folder for its files.
class OpenSees {
 public:
  /// The program that the environment variable OPENSEES names, else `OpenSees` on the path; nothing if there is none.
  /// Throws InputError where OPENSEES names no program.
  static std::optional<OpenSees> find(const std::filesystem::path& folder);

  /// Steps of `step` s from this state to the end of the motion or `end` s, whichever comes first. Peaks are those of
  /// nodes `base` and `top`. Throws Error where OpenSees prints no result.
  [[nodiscard]] OpenSeesRun run(const AnalysisState& start, const GroundMotion& motion, double step, double end,
                                const OpenSeesSetting& setting, NodeId base, NodeId top) const;

 private:
  OpenSees(std::string program, std::filesystem::path folder);

  std::string program_;
  std::filesystem::path folder_;
};

/// A history of steps of `step` s, with moat's accelerations at the start. One that OpenSees does not solve has no
/// peaks, and so the largest error.
History opensees_history(const OpenSees& opensees, const Case& of, const OpenSeesSetting& setting, double step);

/// Steps from the interval of the motion to a twentieth of it. OpenSees and the case must outlive the ladder.
Ladder opensees_ladder(const std::string& name, const OpenSees& opensees, const Case& of,
                       const OpenSeesSetting& setting);

}  // namespace moat::peers
