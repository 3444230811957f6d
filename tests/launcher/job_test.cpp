// A job that hands on signals, as mpirun does.

#include "launcher/commands.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "launcher/stop.hpp"
#include "run_program.hpp"

namespace moat::launcher {
namespace {

class Job : public moat::testing::InTemporaryFolder {
 protected:
  /// Runs a shell script as a job in a process of its own, sends it signals once the file `ready` exists, and returns
  /// its exit code.
  int exit_code(const std::string& script, const std::vector<int>& signals) {
    std::filesystem::current_path(folder);
    const pid_t launcher = ::fork();
    if (launcher == 0) {
      try {
        become_job({"sh", "-c", script});
      } catch (const Stop&) {
        std::_Exit(99);
      }
    }
    for (const int signal : signals) {
      while (!std::filesystem::exists(folder / "ready")) std::this_thread::sleep_for(std::chrono::milliseconds{2});
      std::filesystem::remove(folder / "ready");
      ::kill(launcher, signal);
    }
    int status = 0;
    ::waitpid(launcher, &status, 0);
    std::filesystem::current_path("/");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

constexpr const char* wait = "while true; do sleep 0.01; done";

TEST_F(Job, GivesTheExitCode) {
  EXPECT_EQ(exit_code("exit 0", {}), 0);
  EXPECT_EQ(exit_code("exit 3", {}), 3);
  EXPECT_EQ(exit_code("kill -KILL $$", {}), 137);
}

TEST_F(Job, EndsInOrderAtTheFirstSignal) {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}, std::pair{SIGHUP, 129}}) {
    const std::string script = std::string{"trap 'echo in order > end; exit 138' USR1; touch ready; "} + wait;
    EXPECT_EQ(exit_code(script, {signal}), code);
    EXPECT_EQ(moat::testing::text_of(folder / "end"), "in order\n");
    std::filesystem::remove(folder / "end");
  }
}

TEST_F(Job, EndsWithItsLauncher) {
  const std::string script = std::string{"trap 'touch ended; exit' TERM; touch ready; "} + wait;
  EXPECT_EQ(exit_code(script, {SIGKILL}), -1);
  while (!std::filesystem::exists(folder / "ended")) std::this_thread::sleep_for(std::chrono::milliseconds{2});
}

TEST_F(Job, HasReachedItsEndWhereItSaysSo) {
  EXPECT_EQ(exit_code(std::string{"trap 'exit 0' USR1; touch ready; "} + wait, {SIGINT}), 0);
}

TEST_F(Job, EndsAtOnceAtTheSecondSignal) {
  const std::string script = std::string{"trap 'touch ready' USR1; touch ready; "} + wait;
  EXPECT_EQ(exit_code(script, {SIGINT, SIGTERM}), 130);
}

}  // namespace
}  // namespace moat::launcher
