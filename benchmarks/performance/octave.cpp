#include "performance/octave.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "base/error.hpp"
#include "performance/command_output.hpp"

namespace moat::performance {
namespace {

// A folder of our own that is gone at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "moat_octave_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw FileError{pattern + ": this folder cannot be made."};
    path = pattern;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }

  std::filesystem::path path;
};

}  // namespace

bool octave_is_installed() { return std::system("command -v octave-cli >/dev/null 2>&1") == 0; }

std::optional<OctaveRun> octave_run(const GroundMotion& motion, const OctaveSetting& setting,
                                    const std::filesystem::path& messages) {
  const TemporaryFolder folder;
  const std::filesystem::path samples = folder.path / "motion.txt";
  std::ofstream file{samples};
  file << std::setprecision(17) << motion.time_step() << '\n';
  for (const double sample : motion.samples()) file << sample << '\n';
  if (!file.flush()) throw FileError{samples.string() + ": cannot be written."};

  if (messages.has_parent_path()) std::filesystem::create_directories(messages.parent_path());
  std::ostringstream command;
  command << "octave-cli --quiet --no-init-file --path '" MOAT_OCTAVE_SCRIPTS "' --eval \"five_storeys('"
          << samples.string() << "', '" << setting.solver << "', " << setting.relative_tolerance << ", "
          << setting.intervals_per_step << ")\" 2>>'" << messages.string() << "'";
  std::istringstream output{output_of(command.str())};
  OctaveRun run;
  output >> run.seconds;
  for (double& peak : run.peaks) output >> peak;
  if (!output) return std::nullopt;
  return run;
}

}  // namespace moat::performance
