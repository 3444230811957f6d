// Ctrl-C and termination, as a question.
#pragma once

#include <array>
#include <csignal>

namespace moat {

/// While it lives, SIGINT, SIGTERM and SIGUSR1 (which mpirun hands to its ranks) do not end the program but are
/// remembered, so that it can end in order. A second signal of the same kind ends it at once. A signal that the program
/// was started to ignore (nohup) stays ignored.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The number of the signal that came; 0: none.
  [[nodiscard]] static int received();
  /// "SIGINT", "SIGTERM" or "SIGUSR1".
  [[nodiscard]] static const char* name();
  /// The exit code that a shell gives for it: 130, 143 or 138.
  [[nodiscard]] static int exit_code();

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGUSR1};
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace moat
