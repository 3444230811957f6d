#include "app/script/stop_signals.hpp"

#include <atomic>
#include <csignal>

namespace moat {
namespace {

std::atomic<int> last_signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a handler of signals may use nothing else");

}  // namespace

StopSignals::StopSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i) {
    struct sigaction action {};
    action.sa_handler = [](int signal) { last_signal = signal; };
    if (signals[i] == SIGXFSZ || signals[i] == SIGPIPE) action.sa_handler = SIG_IGN;
    action.sa_flags = static_cast<int>(signals[i] == SIGHUP ? SA_RESTART : SA_RESETHAND | SA_RESTART);
    sigaction(signals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &action, nullptr);
  }
}

StopSignals::~StopSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
}

int StopSignals::received() { return last_signal; }

const char* StopSignals::name() {
  const int signal = last_signal;
  return signal == SIGTERM ? "SIGTERM" : signal == SIGUSR1 ? "SIGUSR1" : signal == SIGHUP ? "SIGHUP" : "SIGINT";
}

int StopSignals::exit_code() {
  constexpr int of_a_shell = 128;
  return of_a_shell + last_signal;
}

}  // namespace moat
