#include "app/progress_bar.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "base/text/number_format.hpp"
#include "base/text/terminal.hpp"

namespace moat {
namespace {

std::string in_time_units(double seconds) {
  constexpr double minute = 60.0, hour = 3600.0;
  if (seconds < 2.0 * minute) return to_fixed(seconds, 0) + " s";
  return seconds < 2.0 * hour ? to_fixed(seconds / minute, 0) + " min" : to_fixed(seconds / hour, 1) + " h";
}

}  // namespace

ProgressBar::ProgressBar(const std::string& title, std::string unit, double quiet_time)
    : title_{title.empty() ? "" : printable(title) + ": "},
      unit_{std::move(unit)},
      quiet_time_{quiet_time},
      terminal_{isatty(STDERR_FILENO) != 0} {}

void ProgressBar::operator()(double done, double all, const std::string& note) {
  // Times of steps are sums: 100 % may be short of it by round-off.
  const int percent = static_cast<int>(100.0 * std::clamp(done / all, 0.0, 1.0) + 1e-7);
  const int shown_every = terminal_ ? 1 : 10;
  if (percent / shown_every <= shown_percent_ / shown_every) return;
  shown_percent_ = percent;
  if (!terminal_) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (passed.count() < quiet_time_) return;
    std::fprintf(stderr, "moat: %s%3d %% of %.15g %s\n", title_.c_str(), percent / 10 * 10, all,
                 printable(unit_ + note).c_str());
  } else if (percent == 100) {
    clear();
  } else {
    constexpr int percent_per_character = 2;
    std::string bar(100 / percent_per_character, '.');
    std::fill_n(bar.begin(), percent / percent_per_character, '#');
    std::fprintf(stderr, "\r\033[K%s[%s] %3d %% of %.15g %s", title_.c_str(), bar.c_str(), percent, all,
                 printable(unit_ + note).c_str());
  }
}

void ProgressBar::operator()(const StudyProgress& progress) {
  const double rate = progress.seconds > 0.0 ? static_cast<double>(progress.computed) / progress.seconds : 0.0;
  std::string note;
  if (rate > 0.0)
    note = ", " + to_significant(rate, 3) + "/s, " +
           in_time_units(static_cast<double>(progress.all - progress.done) / rate) + " left, " +
           to_significant(progress.impacts, 15) + " impacts, " + std::to_string(progress.failed) + " failed";
  (*this)(static_cast<double>(progress.done), static_cast<double>(progress.all), note);
}

void ProgressBar::clear() {
  if (terminal_) std::fprintf(stderr, "\r\033[K");
}

}  // namespace moat
