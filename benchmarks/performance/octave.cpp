#include "performance/octave.hpp"

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "measuring/command_output.hpp"

namespace moat::performance {

std::optional<OctaveRun> octave_run(const GroundMotion& motion, const std::filesystem::path& folder) {
  if (std::system("command -v octave-cli >/dev/null 2>&1") != 0) return std::nullopt;
  const std::filesystem::path samples = folder / "octave_motion.txt";
  std::filesystem::create_directories(folder);
  std::ofstream file{samples};
  file << std::setprecision(17) << motion.time_step() << '\n';
  for (const double sample : motion.samples()) file << sample << '\n';
  if (!file.flush()) throw FileError{samples.string() + ": cannot be written."};
  file.close();
  std::istringstream output{output_of("octave-cli --quiet --no-init-file --path '" MOAT_OCTAVE_SCRIPTS
                                      "' --eval \"five_storeys('" +
                                      samples.string() + "')\" 2>'" + (folder / "octave_messages.txt").string() + "'")};
  OctaveRun run;
  output >> run.seconds;
  for (double& peak : run.peaks) output >> peak;
  if (!output) throw Error{"GNU Octave printed no peaks; see octave_messages.txt in " + folder.string() + "."};
  return run;
}

}  // namespace moat::performance
