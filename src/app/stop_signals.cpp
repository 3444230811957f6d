#include "app/stop_signals.hpp"

#include <array>
#include <atomic>
#include <csignal>

namespace moat {
namespace {

constexpr std::array signals{SIGINT, SIGTERM};
std::atomic<int> last_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a handler of signals may use nothing else");
std::array<struct sigaction, signals.size()> before;

}  // namespace

StopSignals::StopSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i) {
    struct sigaction action {};
    action.sa_handler = [](int signal) { last_signal = signal; };
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigaction(signals[i], nullptr, &before[i]);
    if (before[i].sa_handler != SIG_IGN) sigaction(signals[i], &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before[i], nullptr);
}

int StopSignals::received() { return last_signal; }

const char* StopSignals::name() { return last_signal == SIGTERM ? "SIGTERM" : "SIGINT"; }

int StopSignals::exit_code() {
  constexpr int of_a_shell = 128;
  return of_a_shell + last_signal;
}

}  // namespace moat
