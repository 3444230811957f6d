#include "peers/opensees.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <span>
#include <sstream>

#include "base/error.hpp"
#include "measuring/command_output.hpp"

namespace moat::peers {

using performance::shell_quoted;

namespace {

std::ofstream opened(const std::filesystem::path& path) {
  std::ofstream file{path};
  if (!file) throw FileError{path.string() + ": cannot be written."};
  return file;
}

void finish(std::ofstream& file, const std::filesystem::path& path) {
  if (!file.flush()) throw FileError{path.string() + ": cannot be written."};
}

}  // namespace

OpenSees::OpenSees(std::string program, std::filesystem::path folder)
    : program_{std::move(program)}, folder_{std::move(folder)} {
  std::filesystem::create_directories(folder_);
}

std::optional<OpenSees> OpenSees::find(const std::filesystem::path& folder) {
  const char* named = std::getenv("OPENSEES");
  const std::string program = named != nullptr ? named : "OpenSees";
  const bool found = std::system(("command -v " + shell_quoted(program) + " >/dev/null 2>&1").c_str()) == 0;
  if (!found && named != nullptr)
    throw InputError{"OPENSEES = " + program + " is not a program. Give the path of OpenSees' Tcl interpreter."};
  if (!found) return std::nullopt;
  return OpenSees{program, folder};
}

OpenSeesRun OpenSees::run(const AnalysisState& start, const Case& of, double step,
                          const OpenSeesSetting& setting) const {
  const std::filesystem::path model_file = folder_ / "model.tcl", messages = folder_ / "opensees_messages.txt";
  std::ofstream tcl = opened(model_file);
  std::vector<int> tags;
  if (of.model.is_plan())
    write_opensees_plan(of.model, tcl);
  else
    tags = write_opensees_model(start, setting, tcl);
  finish(tcl, model_file);
  const GroundMotion& motion = of.motion;
  std::string motions;
  for (const std::span<const double> component : {motion.samples(), motion.samples_y()}) {
    if (component.empty()) continue;
    const std::filesystem::path file = folder_ / ("motion_" + std::to_string(motions.empty() ? 1 : 2) + ".txt");
    std::ofstream samples = opened(file);
    samples << std::setprecision(17);
    for (const double sample : component) samples << sample << '\n';
    finish(samples, file);
    motions += "{" + file.string() + "} ";
  }

  constexpr std::array compared{"impacts", "isolation", "plan", "rebounds"};
  std::ostringstream command, elements;
  for (const int tag : tags) elements << tag << ' ';
  const long count = std::lround(std::min(of.end, motion.duration()) / step);
  command << std::setprecision(17) << shell_quoted(program_) << ' ' << shell_quoted(MOAT_OPENSEES_HISTORY) << ' '
          << shell_quoted(model_file.string()) << ' ' << shell_quoted(motions) << ' ' << motion.time_step() << ' '
          << step << ' ' << count << ' ' << setting.name << ' ' << shell_quoted((folder_ / "peaks").string()) << ' '
          << compared.at(static_cast<std::size_t>(of.compared)) << ' ' << of.base.index + 1 << ' ' << of.top.index + 1
          << ' ' << shell_quoted(elements.str()) << " 2>" << shell_quoted(messages.string());
  performance::output_of(command.str());

  std::ifstream printed{messages};
  for (std::string line; std::getline(printed, line);) {
    std::istringstream words{line};
    std::string mark;
    int failed = 0;
    OpenSeesRun run;
    if (!(words >> mark >> failed >> run.cpu_seconds) || mark != "HISTORY") continue;
    run.solved = failed == 0;
    for (double peak; words >> peak;) run.peaks.push_back(std::abs(peak));
    return run;
  }
  throw Error{"OpenSees printed no result; see " + messages.string() + "."};
}

std::string OpenSees::version() const {
  std::istringstream banner{performance::output_of("echo exit | " + shell_quoted(program_) + " 2>&1")};
  for (std::string line; std::getline(banner, line);)
    if (const std::size_t begin = line.find("Version"); begin != std::string::npos) return line.substr(begin);
  throw Error{program_ + " does not name its version."};
}

const std::vector<OpenSeesSetting>& opensees_settings() {
  static const std::vector<OpenSeesSetting> list{
      {"textbook", "Newmark, Newton, test on displacements"},
      {"force_test", "Newmark with beta = 1/6, Newton, test on forces"},
      {"explicit", "NewmarkExplicit, factored once"},
  };
  return list;
}

History opensees_history(const OpenSees& opensees, const Case& of, const OpenSeesSetting& setting, double step) {
  const Transient at_start{of.model, of.motion, of.start(of.model)};
  const OpenSeesRun run = opensees.run(at_start.state(), of, step, setting);
  History history{{}, run.cpu_seconds};
  if (run.solved && run.peaks.size() == history.peaks.size()) std::ranges::copy(run.peaks, history.peaks.begin());
  return history;
}

Ladder opensees_ladder(const std::string& name, const OpenSees& opensees, const Case& of,
                       const OpenSeesSetting& setting, bool finer) {
  Ladder ladder{name, {}};
  std::vector<int> list{1, 2, 3, 4, 5, 8, 12, 20};
  if (finer) list.insert(list.end(), {32, 50, 80});
  for (const int divisions : list)
    ladder.settings.push_back(
        {setting.description + ", interval/" + std::to_string(divisions), [&opensees, &of, setting, divisions] {
           return opensees_history(opensees, of, setting, of.motion.time_step() / divisions);
         }});
  return ladder;
}

}  // namespace moat::peers
