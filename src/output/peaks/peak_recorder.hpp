// Peaks of all channels over continuous time.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "output/files/case_result.hpp"
#include "output/peaks/peak_trackers.hpp"
#include "output/recorders/channels.hpp"

namespace moat {

/// Follows every channel and lists its peak with its sign; channels of one quantity and place share one, and bearings
/// have one of deformation and of force for each besides. Adds the `sum_of_floor_inertia_maxima` of every building: the
/// sum of mass times peak absolute acceleration. The axial force of a bearing has its smallest value besides,
/// `smallest_bearing_compression`, and where it lifted `uplift_time` [s], `uplifts` and `uplift_deficit` [N];
/// `bearing_unstable` says how often it exceeded the critical load of its rubber, at the time of the first.
class PeakRecorder final : public StepObserver {
 public:
  /// The model must be complete.
  explicit PeakRecorder(const Model& model);

  void start(const StepView& view) override;
  void step(const StepView& view) override;
  void event(const StepView& view, std::span<const RegimeChange> changes) override;
  void finish(const StepView& view) override;
  void archive(StateArchive& archive) override { archive(peaks_, smallest_); }

  /// All channels at the end of the last step, or just after an event behind which they jumped.
  [[nodiscard]] const CommonInstant& last() const { return peaks_.last(); }
  /// The channels, which other recorders may share.
  [[nodiscard]] const std::shared_ptr<const Channels>& channels() const { return channels_; }
  /// One for every channel that has a peak.
  [[nodiscard]] std::vector<Peak> peaks() const;

 private:
  void sample(const StepView& view);
  void keep_smallest(bool at_end_of_step);
  void add_slide_begins(const AnalysisState& state);
  [[nodiscard]] std::string side_of(std::size_t channel, const Peak& peak) const;

  const Model* model_;
  std::shared_ptr<const Channels> channels_;
  PeakTrackers peaks_;  // of all channels
  // The smallest value of a channel.
  struct Smallest {
    std::size_t channel;
    double value = std::numeric_limits<double>::infinity(), time = 0.0;

    void keep(double when, double found) {
      if (found >= value) return;
      value = found;
      time = when;
    }
  };
  std::vector<Smallest> smallest_;
  std::vector<Peak> uplifts_;
};

}  // namespace moat
