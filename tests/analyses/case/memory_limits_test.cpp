// Runs and studies that need more memory than there is are refused before they start.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <string>

#include "analyses/case/case_run.hpp"
#include "analyses/questions/study.hpp"
#include "analysis_testing.hpp"
#include "in_folder.hpp"
#include "structures/shear_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;

class MemoryLimits : public testing::InFolder {
 protected:
  /// The message of an InputError in a process that may take so many bytes more; "done" without one.
  std::string message_with(double bytes, const std::function<std::string()>& work) const {
    const std::filesystem::path file = folder / "message";
    const pid_t child = fork();
    if (child == 0) {
      std::ofstream message{file};
      double pages = 0.0;
      std::ifstream{"/proc/self/statm"} >> pages;
      const rlimit limit{static_cast<rlim_t>(pages * static_cast<double>(sysconf(_SC_PAGESIZE)) + bytes),
                         RLIM_INFINITY};
      if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(2);
      try {
        message << work() << std::flush;
      } catch (const InputError& error) {
        message << error.what() << std::flush;
      }
      _exit(0);
    }
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    return read_file(file);
  }
};

TEST_F(MemoryLimits, RefuseAModelThatIsTooLarge) {
  Model model;
  add(model, ShearBuilding{.storeys = 1000, .floor_mass = 500 * tonne, .storey_stiffness = 1 * GN / m});
  const std::string message = message_with(5e6, [&] {
    const CaseRun run{model, still_ground(1 * s, 5 * ms)};
    return "done";
  });
  EXPECT_NE(message.find("a run of 1000 degrees of freedom with its results needs about 7.5 MB, and "),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("Take a machine with more memory"), std::string::npos) << message;
}

TEST_F(MemoryLimits, RefuseAStudyOfTooManyCases) {
  const StudyCases cases{{.name = "a", .unit = "", .values = linearly_spaced(0.0, 1.0, 1000)},
                         {.name = "b", .unit = "", .values = linearly_spaced(0.0, 1.0, 1000)}};
  const std::function<StudyRecord(const StudyCase&)> nothing = [](const StudyCase&) { return StudyRecord{}; };
  const std::string message = message_with(5e8, [&] {
    (void)run_study(cases, nothing);
    return "done";
  });
  EXPECT_NE(message.find("1000000 cases need about 1 GB, and "), std::string::npos) << message;
  EXPECT_NE(message.find("Give the axes fewer values"), std::string::npos) << message;
}

}  // namespace
}  // namespace moat
