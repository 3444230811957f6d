// Ctrl-C and termination, as a question.
#pragma once

#include <array>
#include <csignal>

namespace moat {

/// While it lives, SIGINT, SIGTERM, SIGUSR1 (which mpirun hands to its ranks) and SIGHUP do not end the program but are
/// remembered, so that it can end in order. A second signal of the same kind ends it at once, but for SIGHUP: a
/// terminal that is closed sends several. A signal that the program was started to ignore (nohup) stays ignored.
/// SIGXFSZ and SIGPIPE are ignored, so that a write fails that would end the program.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The number of the signal that came; 0: none.
  [[nodiscard]] static int received();
  /// "SIGINT", "SIGTERM", "SIGUSR1" or "SIGHUP".
  [[nodiscard]] static const char* name();
  /// The exit code that a shell gives for it: 130, 143, 138 or 129.
  [[nodiscard]] static int exit_code();

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGUSR1, SIGHUP, SIGXFSZ, SIGPIPE};
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace moat
