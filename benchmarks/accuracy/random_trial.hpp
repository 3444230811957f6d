// One random model, computed by moat and by the independent reference.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "analyses/time_history/transient.hpp"
#include "moat_model.hpp"
#include "reference_history.hpp"

namespace moat {

/// A way to run moat.
struct TrialSetting {
  std::string name;
  TransientOptions options;
};

/// A peak of moat beside the reference.
struct TrialPeak {
  std::string name;  ///< quantity and place
  double value = 0.0, reference = 0.0;
  double reference_change = 0.0;  ///< of the reference with half the length of steps, in the unit of the peak
  bool counts = true;             ///< at least a thousandth of the largest of its quantity in the model
  double error_bar = std::numeric_limits<double>::quiet_NaN();  ///< moat's estimate of its error, NaN where it has none

  /// Relative; the value itself where the reference is zero.
  [[nodiscard]] double error() const;
};

enum class PeaksToCompare { counting, all };

/// One model with one setting.
struct Trial {
  std::string refused;  ///< moat's message where it refused the model or stopped
  std::vector<TrialPeak> peaks;
  std::size_t impacts = 0;
  long steps = 0;
  bool warned = false;
  double cpu_seconds = 0.0;

  /// The peak with the largest error; null without peaks.
  [[nodiscard]] const TrialPeak* worst(PeaksToCompare of) const;
};

/// One model with all settings.
struct TrialModel {
  std::uint64_t seed = 0;
  std::string failed;  ///< message of the reference where it stopped; there are no trials then
  testing::CheckedReference reference;
  std::vector<Trial> trials;
};

Trial run_trial(const testing::PlainModel& plain, const testing::CheckedReference& reference,
                const TrialSetting& setting);

/// Draws the model of the seed and runs it with every setting.
TrialModel run_trials(std::uint64_t seed, const std::vector<TrialSetting>& settings);

}  // namespace moat
