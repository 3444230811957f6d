#include "output/recorders/offered_quantities.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"

namespace moat {

void OfferedQuantities::add(const QuantityRecorder& recorder) {
  const std::vector<OfferedQuantity> offered = recorder.quantities();
  for (const OfferedQuantity& each : offered) {
    const Check check{"QuantityRecorder", each.quantity};
    check.that(!each.quantity.empty() && !each.unit.empty(), "a quantity has no name or no unit.",
               "Give both; the unit of a plain number is \"1\".");
    const bool is_new = std::ranges::none_of(
        list_, [&](const auto& known) { return known.quantity == each.quantity && known.where == each.where; });
    check.that(is_new, "the quantity is offered twice at \"" + each.where + "\".", "Give it another place.");
    list_.push_back(each);
  }
  sources_.push_back({&recorder, list_.size() - offered.size(), offered.size()});
}

void OfferedQuantities::sample(const StepView& view, std::vector<double>& values) const {
  values.resize(list_.size());
  for (const Source& source : sources_)
    source.recorder->sample(view, std::span{values}.subspan(source.first, source.count));
}

void OfferedPeaks::step(const StepView& view) {
  quantities_->sample(view, values_);
  largest_.resize(values_.size());
  const double time = view.state.time();
  for (std::size_t i = 0; i < values_.size(); ++i) {
    Largest& largest = largest_[i];
    if (!std::isfinite(values_[i])) {
      if (largest.not_finite++ == 0) largest.first_not_finite_at = time;
    } else if (!std::isfinite(largest.value) || std::abs(values_[i]) > std::abs(largest.value)) {
      largest.value = values_[i];
      largest.time = time;
    }
  }
}

std::vector<Peak> OfferedPeaks::peaks() const {
  std::vector<Peak> peaks;
  for (std::size_t i = 0; i < largest_.size(); ++i) {
    const OfferedQuantity& each = quantities_->list()[i];
    peaks.push_back({each.quantity, each.where, largest_[i].value, each.unit, largest_[i].time});
  }
  return peaks;
}

std::vector<std::string> OfferedPeaks::warnings() const {
  std::vector<std::string> list;
  for (std::size_t i = 0; i < largest_.size(); ++i) {
    const Largest& largest = largest_[i];
    if (largest.not_finite == 0) continue;
    const OfferedQuantity& each = quantities_->list()[i];
    list.push_back("The quantity \"" + each.quantity + "\" of a recorder is infinite or no number at \"" + each.where +
                   "\", first at t = " + to_text(largest.first_not_finite_at) + " s, " +
                   std::to_string(largest.not_finite) +
                   " times in all. Its peak leaves these values out. Look for a division by zero in the recorder's "
                   "sample().");
  }
  return list;
}

}  // namespace moat
