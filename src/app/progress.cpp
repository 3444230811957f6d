#include "app/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace moat {

ProgressDisplay::ProgressDisplay(double end, std::string label)
    : end_{end}, label_{label.empty() ? "" : label + " "}, terminal_{isatty(STDERR_FILENO) != 0} {}

void ProgressDisplay::start(const StepView&) { last_shown_ = std::chrono::steady_clock::now(); }

void ProgressDisplay::step(const StepView& view) {
  const double time = view.model.state().time;
  if (!terminal_) {
    const int tenths = static_cast<int>(10.0 * time / end_ + 1e-9);
    for (; shown_tenths_ < tenths; ++shown_tenths_)
      std::fprintf(stderr, "moat: %s%3d %% of %.4g s\n", label_.c_str(), 10 * (shown_tenths_ + 1), end_);
    return;
  }
  // Reading the clock at every step would cost as much as a tenth of the step.
  if (steps_until_look_-- > 0) return;
  steps_until_look_ = 100;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_shown_ < std::chrono::milliseconds{100}) return;
  last_shown_ = now;
  show(time);
}

void ProgressDisplay::finish(const StepView&) {
  if (terminal_) std::fprintf(stderr, "\r\033[K");
}

void ProgressDisplay::show(double time) {
  constexpr int width = 40;
  const double share = std::clamp(time / end_, 0.0, 1.0);
  const auto done = static_cast<std::size_t>(share * width);
  const std::string bar = std::string(done, '#') + std::string(width - done, '.');
  std::fprintf(stderr, "\r%s[%s] %3.0f %%  %.2f of %.4g s", label_.c_str(), bar.c_str(), 100.0 * share, time, end_);
}

}  // namespace moat
