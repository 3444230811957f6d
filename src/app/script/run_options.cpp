#include "app/script/run_options.hpp"

#include <algorithm>
#include <iostream>
#include <string>

#include "app/command_line.hpp"
#include "app/script/script_parts.hpp"
#include "base/check.hpp"
#include "base/text/terminal.hpp"

namespace moat {

std::optional<int> Script::read_options(const GroundMotion& motion, RunOptions& options) {
  CommandLine& line = parts_->line;
  const std::filesystem::path default_folder = std::filesystem::path{"results"} / line.program();
  options.folder = text("out", default_folder.string(), "results folder; an existing one gets a new number");
  line.add_flag("force", options.force, "replace the results in an existing folder");
  options.transient.step = time("step", options.transient.step, "fixed time step; 0 s adapts it");
  options.transient.tolerance = number("tolerance", options.transient.tolerance, "error per step of an adapted step");
  const std::string integrator =
      text("integrator", std::string{name_of(options.transient.integrator)},
           integrator_names() + "; exact steps are for small models, automatic takes them where it can");
  const Time end = options.transient.end.si() > 0.0 ? options.transient.end : motion.duration() * units::s;
  options.transient.end = time("end", end, "end of the analysis");
  // At most some 400 frames of a motion of any length.
  options.frame_interval = time("frame-interval", std::max(50 * units::ms, options.transient.end / 400.0),
                                "between VTK frames; 0 s writes none");
  options.checkpoint = time("checkpoint", 30 * units::s, "between checkpoints of the run; 0 s writes none");
  line.add_flag("resume", options.resume, "go on from the checkpoint of a run that was killed or stopped");
  line.add_flag("check", options.check, "error bars, by a second run, for runs of any size");
  line.add_flag("sensitivity", options.sensitivity, "how peaks move with contact parameters, for runs of any size");
  line.add_flag("no-sensitivity", options.no_sensitivity, "without the runs with other contact parameters");
  line.add_flag("quiet", options.quiet, "print warnings and errors only");
  line.add_json_flag();
  parts_->checked = true;
  if (line.help_wanted()) {
    print_text(std::cout, line.help());
    return 0;
  }
  if (!line.parse()) return exit_usage;
  // Before the results folder is made.
  if (integrator != name_of(options.transient.integrator))
    options.transient.integrator = integrator_named(integrator, "--integrator");
  const Check check{"Script", ""};
  check.not_negative("--frame-interval", options.frame_interval);
  check.not_negative("--checkpoint", options.checkpoint);
  constexpr double most_frames = 1e6;
  const double frames =
      options.frame_interval.si() > 0.0 ? options.transient.end.si() / options.frame_interval.si() : 0.0;
  check.that(frames <= most_frames, "number of frames (end / frame-interval)", frames, "1", "<= 1e6",
             "Give a longer --frame-interval, or 0 s for no frames.");
  check.that(!options.sensitivity || !options.no_sensitivity, "both --sensitivity and --no-sensitivity are given.",
             "Give one of them.");
  parts_->origin.options = line.values();
  return std::nullopt;
}

}  // namespace moat
