#include "measuring/measure.hpp"

#include <ctime>
#include <fstream>
#include <string>

#include "base/error.hpp"
#include "study/study_charts.hpp"

namespace moat::performance {

double seconds(Clock clock) {
  timespec now{};
  clock_gettime(clock == Clock::thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double peak_resident_bytes() {
  std::ifstream status{"/proc/self/status"};
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return 1024.0 * std::stod(line.substr(6));
  throw Error{"/proc/self/status has no line VmHWM."};
}

Spread spread_of(std::vector<double> values) {
  if (values.empty()) throw InputError{"spread_of: there is no value. Give at least one."};
  return {fractile(values, 0.5), fractile(values, 0.25), fractile(values, 0.75), static_cast<int>(values.size())};
}

Spread ratio_of(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) throw InputError{"ratio_of: the two have different numbers of rounds."};
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  return spread_of(std::move(ratios));
}

}  // namespace moat::performance
