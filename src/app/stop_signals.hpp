// Ctrl-C and termination, as a question.
#pragma once

namespace moat {

/// While it lives, SIGINT and SIGTERM do not end the program but are remembered, so that it can end in order. A second
/// signal of the same kind ends it at once. A signal that the program was started to ignore (nohup) stays ignored.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// The number of the signal that came; 0: none.
  [[nodiscard]] static int received();
  /// "SIGINT" or "SIGTERM".
  [[nodiscard]] static const char* name();
  /// The exit code that a shell gives for it: 130 or 143.
  [[nodiscard]] static int exit_code();
};

}  // namespace moat
