#include "base/text/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace moat {
namespace {

// How many letters must be put in, taken out, exchanged, or swapped with the next (Damerau, Levenshtein).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1), before(b.size() + 1), next(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    next[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      next[j + 1] = std::min({row[j] + (a[i] == b[j] ? 0 : 1), next[j] + 1, row[j + 1] + 1});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
        next[j + 1] = std::min(next[j + 1], before[j - 1] + 1);
    }
    std::swap(before, row);
    std::swap(row, next);
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::vector<std::string>& names, const std::string& misspelt) {
  constexpr std::size_t most_letters = 3;
  std::string nearest;
  std::size_t least = most_letters + 1;
  for (const std::string& name : names) {
    const std::size_t allowed = std::min(most_letters, std::max(name.size(), misspelt.size()) / 3);
    if (std::max(name.size(), misspelt.size()) - std::min(name.size(), misspelt.size()) > allowed) continue;
    if (const std::size_t letters = distance(name, misspelt); letters <= allowed && letters < least) {
      nearest = name;
      least = letters;
    }
  }
  return nearest;
}

std::string did_you_mean(const std::vector<std::string>& names, const std::string& misspelt,
                         const std::string& dashes) {
  const std::string nearest = nearest_name(names, misspelt);
  return nearest.empty() ? "" : " Did you mean " + dashes + nearest + "?";
}

}  // namespace moat
