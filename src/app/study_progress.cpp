#include "app/study_progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace moat {

StudyProgress::StudyProgress(std::string title)
    : title_{std::move(title)}, terminal_{isatty(STDERR_FILENO) != 0}, started_{std::chrono::steady_clock::now()} {}

void StudyProgress::operator()(std::size_t done, std::size_t all) {
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - started_).count();
  if (!terminal_) {
    const std::size_t tenths = 10 * done / all;
    if (tenths > shown_tenths_)
      std::fprintf(stderr, "moat: %s: %3zu %% of %zu cases, %.1f s\n", title_.c_str(), 10 * tenths, all, seconds);
    shown_tenths_ = tenths;
    return;
  }
  if (done < all && now - last_shown_ < std::chrono::milliseconds{100}) return;
  last_shown_ = now;
  constexpr std::size_t width = 40;
  const std::size_t share = width * done / all;
  const std::string bar = std::string(share, '#') + std::string(width - share, '.');
  std::fprintf(stderr, "\r\033[K[%s] %zu of %zu cases, %.1f s  %s%s", bar.c_str(), done, all, seconds, title_.c_str(),
               done == all ? "\n" : "");
}

}  // namespace moat
