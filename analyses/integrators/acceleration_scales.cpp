#include "analyses/integrators/acceleration_scales.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/building.hpp"
#include "model/equation_of_motion.hpp"

namespace moat {
namespace {

// Trials on 200 random models: without a bound of a quarter of the largest scale in the building the median error fell
// by a third for 0.4 % more steps. Without one of sixteen times the acceleration of an impact for nodes in contact it
// halved, for 5 % more steps. There is neither.

// A node with an acceleration below this share of the ground's peak is at rest, or free.
constexpr double least_share_of_ground = 0.02;
constexpr double seconds_to_fade = 1.0;  // by a factor e

// The entries between two quantities of one or two components.
struct Entries {
  std::array<double, 4> values{};

  // The largest singular value.
  [[nodiscard]] double stretch() const {
    const auto [a, b, c, d] = values;
    const double squares = a * a + b * b + c * c + d * d, determinant = a * d - b * c;
    const double difference = std::sqrt(std::max(squares * squares - 4.0 * determinant * determinant, 0.0));
    return std::sqrt(0.5 * (squares + difference));
  }
};

}  // namespace

Resultants::Resultants(const Model& model) {
  if (!model.is_plan()) return;
  for (int i = 0; i < model.degrees_of_freedom(); ++i) partners_.push_back(i);
  for (const PlacedDiaphragm& diaphragm : model.diaphragms()) {
    if (diaphragm.id.x.is_follower()) continue;
    partners_[static_cast<std::size_t>(diaphragm.id.x.index)] = diaphragm.id.y.index;
    partners_[static_cast<std::size_t>(diaphragm.id.y.index)] = diaphragm.id.x.index;
  }
}

Vector Resultants::row_sums(const SparseMatrix& matrix) const {
  Vector sums = Vector::Zero(matrix.rows());
  const auto first_of = [&](int i) { return std::min(i, partner(i)); };
  std::vector<Entries> of_row(static_cast<std::size_t>(matrix.rows()));
  std::vector<int> rows;
  for (int first = 0; first < matrix.rows(); ++first) {
    if (first_of(first) != first) continue;
    rows.clear();
    const int second = partner(first);
    for (int column = first; column <= std::max(first, second); column += std::max(second - first, 1)) {
      for (SparseMatrix::InnerIterator entry{matrix, column}; entry; ++entry) {
        const int row = static_cast<int>(entry.row()), head = first_of(row);
        of_row[static_cast<std::size_t>(head)].values[(row != head ? 2 : 0) + (column != first ? 1 : 0)] =
            entry.value();
        rows.push_back(head);
      }
    }
    for (const int row : rows) {
      Entries& entries = of_row[static_cast<std::size_t>(row)];
      sums[row] += entries.stretch();
      entries = {};
    }
  }
  for (int i = 0; i < matrix.rows(); ++i) sums[i] = sums[first_of(i)];
  return sums;
}

AccelerationScales::AccelerationScales(const AnalysisState& state, double peak_ground_acceleration)
    : lowest_{std::max(least_share_of_ground * peak_ground_acceleration, std::numeric_limits<double>::min())},
      resultants_{state.model()},
      building_{connected_parts(state.model())},
      touching_(static_cast<std::size_t>(std::ranges::max(building_)) + 1, 0),
      touched_before_(touching_) {
  values_.setConstant(state.model().degrees_of_freedom(), lowest_);
  outside_contact_ = values_;
  for (int i = 0; i < state.model().degrees_of_freedom(); ++i) {
    const int building = building_[static_cast<std::size_t>(i)];
    if (runs_.empty() || runs_.back().building != building) runs_.push_back({i, i, building});
    runs_.back().end = i + 1;
  }
  regimes_changed(state);
}

void AccelerationScales::regimes_changed(const AnalysisState& state) {
  if (!any_touching_) outside_contact_ = values_;
  touched_before_.swap(touching_);
  std::ranges::fill(touching_, 0);
  any_touching_ = false;
  for (std::size_t b = 0; b < state.model().blocks().size(); ++b) {
    if (!std::isfinite(state.elements(b).shortest_contact())) continue;
    const ElementBlock& block = *state.model().blocks()[b];
    for (std::size_t e = 0; e < block.size(); ++e) {
      if (!state.elements(b).contact(e).touching) continue;
      any_touching_ = true;
      for (const NodeId end : {block.info(e).first, block.info(e).second}) {
        if (end == ground) continue;
        const auto place = static_cast<std::size_t>(state.model().place(end));
        touching_[static_cast<std::size_t>(building_[place])] = 1;
      }
    }
  }
  // The last contact of a building has ended: its scales return to those without contact.
  for (const Run& run : runs_) {
    const auto building = static_cast<std::size_t>(run.building);
    if (touched_before_[building] == 0 || touching_[building] != 0) continue;
    for (int i = run.begin; i < run.end; ++i) values_[i] = outside_contact_[i];
  }
}

void AccelerationScales::accepted(const AnalysisState& state, double h, GroundVector ground_acceleration) {
  if (h != step_of_fade_) {
    step_of_fade_ = h;
    fade_ = std::exp(-h / seconds_to_fade);
  }
  const double fade = fade_;
  const int count = state.model().degrees_of_freedom();
  const double* acceleration = state.motion().acceleration.data();
  double* __restrict values = values_.data();
  double* __restrict outside = outside_contact_.data();
  with_ground_component(state.model(), ground_acceleration, [&, lowest = lowest_](const auto& of_ground) {
    const auto absolute = [&](int i) { return acceleration[i] + of_ground(i); };
    resultants_.with([&](const auto& size) {
      for (int i = 0; i < count; ++i) values[i] = std::max(std::max(values[i] * fade, lowest), size(i, absolute));
    });
  });
  if (!any_touching_) return;
  // `outside` excludes accelerations of impacts: while a building is in contact it only decays.
  for (const Run& run : runs_) {
    const bool touching = touching_[static_cast<std::size_t>(run.building)] != 0;
    for (int i = run.begin; i < run.end; ++i) outside[i] = touching ? std::max(outside[i] * fade, lowest_) : values[i];
  }
}

}  // namespace moat
