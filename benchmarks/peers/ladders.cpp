#include "peers/ladders.hpp"

#include <algorithm>
#include <optional>

#include "measuring/error_curve.hpp"
#include "measuring/measure.hpp"

namespace moat::peers {
namespace {

using namespace performance;

// The settings of a ladder between which the error is read off.
struct Found {
  const Setting *looser, *tighter;
  ReadOff read;
};

std::optional<Found> tried(const Ladder& ladder, const Peaks& reference, double error, std::vector<double>& errors) {
  std::vector<CurvePoint> points;
  for (std::size_t i = 0; i < ladder.settings.size(); ++i) {
    const History history = ladder.settings[i].run();
    errors.push_back(largest_error(history.peaks, reference));
    points.push_back({i, errors.back(), history.seconds});
    // Two that are three times as exact show that the tighter ones are so too.
    if (i > 0 && std::max(errors[i - 1], errors[i]) < error / 3.0) break;
  }
  const auto read = read_off(points, error);
  if (!read) return std::nullopt;
  return Found{&ladder.settings[read->looser], &ladder.settings[read->tighter], *read};
}

std::string description(const Found& found) {
  return found.read.always_better ? found.looser->name + ", the cheapest and never as bad as this"
                                  : found.looser->name + " ... " + found.tighter->name;
}

}  // namespace

bool cheaper(const Cost& a, const Cost& b) {
  if (a.seconds.empty() || b.seconds.empty()) return !a.seconds.empty();
  return spread_of(a.seconds).median < spread_of(b.seconds).median;
}

std::vector<Cost> costs(const std::vector<Ladder>& ladders, const Peaks& reference, double error, int rounds) {
  std::vector<Cost> all;
  std::vector<std::optional<Found>> found;
  for (const Ladder& ladder : ladders) {
    std::vector<double> errors;
    found.push_back(tried(ladder, reference, error, errors));
    all.push_back({ladder.name, found.back() ? description(*found.back()) : "", {}, std::move(errors)});
  }
  for (int round = -1; round < rounds; ++round)
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!found[i]) continue;
      const double looser = found[i]->looser->run().seconds, tighter = found[i]->tighter->run().seconds;
      if (round >= 0) all[i].seconds.push_back(found[i]->read.time(looser, tighter));
    }
  std::vector<Cost> one_of_each_name;
  for (const Cost& cost : all) {
    if (one_of_each_name.empty() || one_of_each_name.back().name != cost.name)
      one_of_each_name.push_back(cost);
    else if (cheaper(cost, one_of_each_name.back()))
      one_of_each_name.back() = cost;
  }
  return one_of_each_name;
}

}  // namespace moat::peers
