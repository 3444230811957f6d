#include "base/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace moat {
namespace {

// How many letters must be put in, taken out or exchanged (Levenshtein).
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::vector<std::string>& names, const std::string& misspelt) {
  std::string nearest;
  std::size_t least = 1 + misspelt.size() / 3;
  for (const std::string& name : names)
    if (const std::size_t letters = distance(name, misspelt); letters <= least) {
      nearest = name;
      least = letters - 1;
      if (letters == 0) break;
    }
  return nearest;
}

}  // namespace moat
