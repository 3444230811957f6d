#include "launcher/job.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include "launcher/stop.hpp"

namespace moat::launcher {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
std::atomic<pid_t> job{0};
std::atomic<int> first_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a handler of signals may use nothing else");

void hand_on(int signal) {
  const int before = first_signal.exchange(signal);
  if (before != 0) first_signal = before;
  if (job > 0) ::kill(job, before == 0 ? SIGUSR1 : SIGTERM);
}

[[noreturn]] void become_job(std::vector<char*> words, pid_t parent) {
  ::setpgid(0, 0);  // so that Ctrl-C in the terminal reaches the launcher alone
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) std::_Exit(exit_failed);
  for (const int signal : signals) std::signal(signal, SIG_DFL);
  // A group in the background may not read from the terminal.
  if (const int nothing = ::open("/dev/null", O_RDONLY); nothing > 0) ::dup2(nothing, STDIN_FILENO);
  ::execvp(words.front(), words.data());
  constexpr int cannot_start = 127;
  std::_Exit(cannot_start);
}

}  // namespace

int run_job(const Command& command) {
  Command text = command;
  std::vector<char*> words;
  for (std::string& word : text) words.push_back(word.data());
  words.push_back(nullptr);
  first_signal = 0;
  // A signal before the job exists waits.
  sigset_t mine, before;
  sigemptyset(&mine);
  for (const int signal : signals) sigaddset(&mine, signal);
  sigprocmask(SIG_BLOCK, &mine, &before);
  for (const int signal : signals) {
    struct sigaction action {};
    action.sa_handler = hand_on;
    sigaction(signal, &action, nullptr);
  }
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) throw Stop{exit_failed, command.front() + " cannot be started: " + std::strerror(errno)};
  if (child == 0) {
    sigprocmask(SIG_SETMASK, &before, nullptr);
    become_job(words, parent);
  }
  job = child;
  sigprocmask(SIG_SETMASK, &before, nullptr);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  job = 0;
  for (const int signal : signals) std::signal(signal, SIG_DFL);
  constexpr int of_a_signal = 128, cannot_start = 127;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : of_a_signal + WTERMSIG(status);
  if (code == cannot_start) throw Stop{exit_failed, command.front() + " cannot be started. Is it installed?"};
  return first_signal != 0 && code != 0 ? of_a_signal + first_signal : code;
}

}  // namespace moat::launcher
