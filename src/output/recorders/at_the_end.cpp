#include "output/recorders/at_the_end.hpp"

namespace moat {

std::vector<Peak> isolators_at_the_end(const Table& histories) {
  std::vector<Peak> offsets;
  if (histories.rows() == 0) return offsets;
  const double time = histories.values("time").back();
  for (const Column& column : histories.columns)
    if (column.quantity == "isolator_deformation")
      offsets.push_back({"isolator_deformation_at_the_end", column.where, column.values.back(), column.unit, time});
  return offsets;
}

}  // namespace moat
