#include "motions/spectra/target_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "motions/response_spectrum.hpp"

namespace moat {

Acceleration TargetSpectrum::acceleration(Time period) const {
  const std::string from = to_text(shortest.si()) + " s", to = to_text(longest.si()) + " s";
  Check{"TargetSpectrum", name}.that(period >= shortest && period <= longest, "period", period.si(), "s",
                                     std::isfinite(longest.si()) ? "from " + from + " to " + to : ">= " + from,
                                     period > longest ? advice : "");
  return Acceleration{value(period.si())};
}

SpectrumTable::operator TargetSpectrum() const {
  const Check check{"SpectrumTable", name};
  check_damping_ratio(check, damping_ratio);
  check.that(periods.size() >= 2 && periods.size() == accelerations.size(),
             "it has " + std::to_string(periods.size()) + " periods and " + std::to_string(accelerations.size()) +
                 " accelerations.",
             "Give at least two periods, and an acceleration for each.");
  std::vector<double> t, a;
  for (std::size_t i = 0; i < periods.size(); ++i) {
    const double period = periods[i].si();
    check.that(std::isfinite(period) && (t.empty() ? period >= 0.0 : period > t.back()), "period", period, "s",
               t.empty() ? ">= 0 s" : "> " + to_text(t.back()) + " s, the one before", "Sort the table by periods.");
    check.positive("acceleration at " + to_text(period) + " s", accelerations[i]);
    t.push_back(period);
    a.push_back(accelerations[i].si());
  }
  const double last = t.back();
  if (long_period) {
    constexpr double end_of_asce_7_tables = 10.0;  // s
    check.positive("long_period", *long_period);
    check.that(last >= end_of_asce_7_tables, "last period", last, "s", ">= 10 s where long_period is given",
               "Leave out long_period, or give the whole table.");
  }
  const double tail = long_period ? std::max(last, long_period->si()) : last;
  const std::string beyond =
      "; beyond " + to_text(last) + " s by ASCE/SEI 7-22 11.4.5.1, recalled, not read in the code";
  return {.name = name,
          .source = source + (long_period ? beyond : ""),
          .damping_ratio = damping_ratio,
          .shortest = periods.front(),
          .longest = long_period ? Time{std::numeric_limits<double>::infinity()} : periods.back(),
          .corners = periods,
          .value =
              [t, a, last, tail](double period) {
                if (period >= last) return a.back() * last / period * std::min(1.0, tail / period);
                const auto i = static_cast<std::size_t>(std::ranges::upper_bound(t, period) - t.begin());
                return std::lerp(a[i - 1], a[i], (period - t[i - 1]) / (t[i] - t[i - 1]));
              },
          .advice = "The table ends there."};
}

}  // namespace moat
