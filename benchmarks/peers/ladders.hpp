// The cost of an error of the peaks, for programs that take turns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "measuring/five_peaks.hpp"

namespace moat::peers {

/// One history: its five peaks and its CPU time, s.
struct History {
  performance::Peaks peaks{};
  double seconds = 0.0;
};

struct Setting {
  std::string name;
  std::function<History()> run;
};

/// Settings of one program that differ in one thing, from the loosest to the tightest.
struct Ladder {
  std::string name;
  std::vector<Setting> settings;
};

struct Cost {
  std::string name;              ///< of the ladder
  std::string settings;          ///< the two between which the error is read off
  std::vector<double> seconds;   ///< for this error, in every round; empty where no setting is so exact
  std::vector<double> errors{};  ///< of the settings that were tried
};

/// Whether the median of `a` is the smaller one; a cost without times is dear.
bool cheaper(const Cost& a, const Cost& b);

/// The costs of an error, relative to the reference. Every setting runs once, up to two that are three times as exact;
/// the settings between which the error is read off (error_curve.hpp) then run in turns, `rounds` >= 1 rounds after one
/// to warm up. Neighbouring ladders with one name count as one, the cheapest.
std::vector<Cost> costs(const std::vector<Ladder>& ladders, const performance::Peaks& reference, double error,
                        int rounds);

}  // namespace moat::peers
