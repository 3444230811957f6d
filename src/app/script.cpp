#include "app/script.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <list>
#include <optional>

#include "analyses/case_run.hpp"
#include "app/progress_bar.hpp"
#include "app/results.hpp"
#include "base/check.hpp"
#include "base/error.hpp"
#include "base/parse_quantity.hpp"
#include "motions/read_motion.hpp"
#include "output/model_scene.hpp"
#include "output/results_folder.hpp"
#include "output/summary.hpp"

namespace moat {
namespace {

constexpr int exit_error = 1, exit_usage = 2, exit_no_convergence = 3;

// An exception that leaves main() ends here, and its message is all the user should see.
[[noreturn]] void report_and_exit() {
  std::cout.flush();
  try {
    if (const std::exception_ptr current = std::current_exception()) std::rethrow_exception(current);
    std::fputs("moat: terminated without an exception\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "moat: error: %s\n", error.what());
  } catch (...) {
    std::fputs("moat: error: an exception that is not a std::exception\n", stderr);
  }
  std::fflush(stdout);
  std::_Exit(exit_error);
}

}  // namespace

// CLI11 parses a whole line at once, but a script asks for one value after the other. Each is looked up by a parser
// that knows this one option and ignores the rest; at the end a parser that knows all options checks the line.
struct Script::CommandLine {
  CommandLine(int argc, char** argv, std::string title) : app{std::move(title)} {
    if (argc > 0) {
      program = std::filesystem::path{argv[0]}.stem().string();
      app.name(argv[0]);
    }
    for (int i = 1; i < argc; ++i) arguments.emplace_back(argv[i]);
    for (const std::string& argument : arguments) help_wanted = help_wanted || argument == "-h" || argument == "--help";
    app.get_formatter()->column_width(34);
    app.footer(
        "Write quantities with their unit: \"12 cm\", 0.4g, \"2.5 ms\".\n"
        "Exit code: 0 done, 1 bad input, 2 wrong usage, 3 a step did not converge.");
  }

  // Throws InputError for a name that no command line can hold, or that is taken.
  void require_new(const std::string& name) const {
    const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
    if (name.empty() || name.front() == '-' || !std::ranges::all_of(name, allowed))
      throw InputError{"Script: \"" + name + "\" cannot be the name of an option. Use letters, digits, - and _."};
    if (app.get_option_no_throw("--" + name) != nullptr)
      throw InputError{
          "--" + name + ": there is an option of this name. Name each once; help, record and record-unit, " +
          "out, force, step, tolerance, integrator, end, frame-interval, check and quiet are those of Script itself."};
  }

  void add_flag(const std::string& name, bool& value, const std::string& help) {
    require_new(name);
    app.add_flag("--" + name, value, help);
  }

  // The text given for an option, if any.
  std::optional<std::string> look_up(const std::string& name, const std::string& preset, const std::string& help,
                                     const std::string& type) {
    require_new(name);
    values.emplace_back();
    CLI::Option* option = app.add_option("--" + name, values.back(), help)->type_name(type);
    if (!preset.empty()) option->default_str(preset);
    CLI::App alone;
    alone.set_help_flag();
    alone.allow_extras();
    std::string value;
    const CLI::Option* found = alone.add_option("--" + name, value);
    try {
      // CLI11 takes arguments from the back.
      alone.parse(std::vector<std::string>{arguments.rbegin(), arguments.rend()});
    } catch (const CLI::ParseError&) {
      return std::nullopt;  // run() parses the whole line again and tells what is wrong
    }
    if (found->count() == 0 || help_wanted) return std::nullopt;
    return value;
  }

  CLI::App app;
  std::string program = "script";
  std::vector<std::string> arguments;
  std::list<std::string> values;  // CLI11 keeps references to them
  bool help_wanted = false;
};

Script::Script(int argc, char** argv, std::string title)
    : command_line_{std::make_unique<CommandLine>(argc, argv, std::move(title))} {
  std::set_terminate(report_and_exit);
}

Script::~Script() = default;

template <class Q>
Q Script::quantity(const std::string& name, Q preset, const std::string& help) {
  const std::string unit = unit_symbol<Q>();
  const std::string preset_text = to_text(preset.si()) + (unit == "1" ? "" : " " + unit);
  const auto text = command_line_->look_up(name, preset_text, help, unit == "1" ? "NUMBER" : "[" + unit + "]");
  return text ? parse<Q>(*text, "--" + name) : preset;
}

Length Script::length(const std::string& name, Length preset, const std::string& help) {
  return quantity(name, preset, help);
}
Time Script::time(const std::string& name, Time preset, const std::string& help) {
  return quantity(name, preset, help);
}
Mass Script::mass(const std::string& name, Mass preset, const std::string& help) {
  return quantity(name, preset, help);
}
Force Script::force(const std::string& name, Force preset, const std::string& help) {
  return quantity(name, preset, help);
}
Speed Script::speed(const std::string& name, Speed preset, const std::string& help) {
  return quantity(name, preset, help);
}
Acceleration Script::acceleration(const std::string& name, Acceleration preset, const std::string& help) {
  return quantity(name, preset, help);
}
Stiffness Script::stiffness(const std::string& name, Stiffness preset, const std::string& help) {
  return quantity(name, preset, help);
}
HertzStiffness Script::hertz_stiffness(const std::string& name, HertzStiffness preset, const std::string& help) {
  return quantity(name, preset, help);
}
double Script::number(const std::string& name, double preset, const std::string& help) {
  return quantity(name, Dimensionless{preset}, help);
}
int Script::integer(const std::string& name, int preset, const std::string& help) {
  const auto text = command_line_->look_up(name, std::to_string(preset), help, "INTEGER");
  if (!text) return preset;
  int value = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc{} || end != text->data() + text->size())
    throw InputError{"--" + name + ": \"" + *text + "\" is not a whole number."};
  return value;
}
std::string Script::text(const std::string& name, const std::string& preset, const std::string& help) {
  return command_line_->look_up(name, preset, help, "TEXT").value_or(preset);
}

GroundMotion Script::motion(const GroundMotion& preset) {
  const auto file = command_line_->look_up(
      "record", "", "accelerogram: PEER AT2, or two columns of time in s and acceleration", "FILE");
  const auto unit = command_line_->look_up("record-unit", "", "unit of a two-column record: g, cm/s^2 ...", "UNIT");
  if (!file) {
    if (unit) throw InputError{"--record-unit: give it together with --record FILE."};
    return preset;
  }
  if (!unit) {
    try {
      return read_motion(*file);
    } catch (const InputError& error) {
      throw InputError{std::string{error.what()} + " Here: --record-unit g"};
    }
  }
  return read_motion(*file, parse<Acceleration>("1 " + *unit, "--record-unit"));
}

int Script::run(Model& model, const GroundMotion& motion) {
  CommandLine& line = *command_line_;
  const std::filesystem::path default_folder = std::filesystem::path{"results"} / line.program;
  const std::string wanted = text("out", default_folder.string(), "results folder; an existing one gets a new number");
  bool force = false, quiet = false, check = false;
  line.add_flag("force", force, "overwrite an existing results folder");
  const Time step = time("step", 0 * units::s, "fixed time step; 0 s adapts it");
  const double tolerance = number("tolerance", TransientOptions{}.tolerance, "error per step of an adapted step");
  const std::string integrator = text("integrator", "newmark", integrator_names() + "; the last for small models");
  const Time end = time("end", motion.duration() * units::s, "end of the analysis");
  const Time frame_interval = time("frame-interval", 50 * units::ms, "between VTK frames; 0 s writes none");
  line.add_flag("check", check, "error bars also where the second run they need costs more than about 20 ms");
  line.add_flag("quiet", quiet, "print errors only");
  // Asked for anywhere, also where an option would take it for its value.
  if (line.help_wanted) {
    std::cout << line.app.help();
    return 0;
  }
  try {
    line.app.parse(std::vector<std::string>{line.arguments.rbegin(), line.arguments.rend()});
  } catch (const CLI::ParseError& error) {
    line.app.exit(error);
    return exit_usage;
  }

  // Before the results folder is made.
  Check{"Script", ""}.not_negative("--frame-interval", frame_interval);
  CaseRun run{model,
              motion,
              {.title = line.app.get_description(),
               .transient = {.integrator = integrator_named(integrator, "--integrator"),
                             .step = step,
                             .tolerance = tolerance,
                             .end = end},
               .error_bars = check ? ErrorBarMode::always : ErrorBarMode::automatic}};
  const std::filesystem::path folder =
      make_results_folder(wanted, force ? WhenFolderExists::overwrite : WhenFolderExists::use_new_number);
  std::optional<FrameRecorder> frames;
  if (frame_interval.si() != 0.0) run.attach(frames.emplace(model, folder, frame_interval.si()));
  std::optional<ProgressObserver> progress, progress_of_check;
  if (!quiet) {
    std::cout << line.app.get_description() << "\n" << motion.description() << "\n" << std::flush;
    run.attach(progress.emplace(run.transient().end_time()));
    // Without --check the second run is over at once.
    if (check) run.attach_to_companion(progress_of_check.emplace(run.transient().end_time(), "check"));
  }

  std::string failure;
  int exit_code = 0;
  try {
    run.run();
  } catch (const ConvergenceError& error) {
    failure = error.what();
    exit_code = exit_no_convergence;
  } catch (const Error& error) {
    failure = error.what();
    exit_code = exit_error;
  }
  CaseResult result = run.result();
  // Whoever opens the files later must not take them for those of a whole run.
  if (!failure.empty())
    result.warnings.insert(result.warnings.begin(), "The analysis stopped at " +
                                                        to_text(run.transient().model().state().time) + " s of " +
                                                        to_text(run.transient().end_time()) + " s: " + failure);
  write_results(result, folder);
  if (!quiet)
    std::cout << terminal_summary(result) << "Results: " << folder.string()
              << "/  (report.html, frames.pvd for ParaView)\n";
  for (std::size_t i = failure.empty() ? 0 : 1; i < result.warnings.size(); ++i)
    std::cerr << "moat: warning: " << result.warnings[i] << "\n";
  if (!failure.empty()) std::cerr << "moat: error: " << failure << "\n";
  return exit_code;
}

}  // namespace moat
