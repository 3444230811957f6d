#include "app/progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace moat {

ProgressBar::ProgressBar(const std::string& title, std::string unit)
    : title_{title.empty() ? "" : title + ": "}, unit_{std::move(unit)}, terminal_{isatty(STDERR_FILENO) != 0} {}

void ProgressBar::operator()(double done, double all) {
  // Times of steps are sums: 100 % may be short of it by round-off.
  const int percent = static_cast<int>(100.0 * std::clamp(done / all, 0.0, 1.0) + 1e-7);
  const int shown_every = terminal_ ? 1 : 10;
  if (percent / shown_every <= shown_percent_ / shown_every) return;
  shown_percent_ = percent;
  if (!terminal_) {
    std::fprintf(stderr, "moat: %s%3d %% of %.4g %s\n", title_.c_str(), percent / 10 * 10, all, unit_.c_str());
  } else if (percent == 100) {
    clear();
  } else {
    constexpr int percent_per_character = 2;
    std::string bar(100 / percent_per_character, '.');
    std::fill_n(bar.begin(), percent / percent_per_character, '#');
    std::fprintf(stderr, "\r\033[K%s[%s] %3d %% of %.4g %s", title_.c_str(), bar.c_str(), percent, all, unit_.c_str());
  }
}

void ProgressBar::clear() {
  if (terminal_) std::fprintf(stderr, "\r\033[K");
}

}  // namespace moat
