#include "output/recorders/offered_quantities.hpp"

#include <cmath>
#include <limits>

#include "output/recorders/history_recorder.hpp"
#include "output_testing.hpp"
#include "recorders_testing.hpp"

namespace moat {
namespace {

using testing_output::HandMovedBuilding;
using testing_output::message_of;

// The drift, and the number of steps so far.
class Drift final : public QuantityRecorder {
 public:
  explicit Drift(std::string name = "tilt") : name_{std::move(name)} {}
  std::vector<OfferedQuantity> quantities() const override { return {{name_, "tower", "m"}, {"steps", "tower", "1"}}; }
  void step(const StepView&) override { ++steps_; }
  void sample(const StepView& view, std::span<double> values) const override {
    values[0] = view.state.motion().displacement[1] - view.state.motion().displacement[0];
    values[1] = steps_;
  }

 private:
  std::string name_;
  int steps_ = 0;
};

TEST(OfferedQuantities, AreColumnsOfTheHistories) {
  HandMovedBuilding building;
  Drift drift;
  OfferedQuantities offered;
  offered.add(drift);
  HistoryRecorder recorder{building.model, 0.25, nullptr, true};
  recorder.add(offered);
  recorder.start(building.move(0.0, 0.0, 0.0));
  const StepView end = building.move(0.5, 0.01, 0.05);
  drift.step(end);
  recorder.step(end);
  const Table table = recorder.table();
  const std::vector<double>& values = table.values("tilt", "tower");
  ASSERT_EQ(values.size(), 3u);
  EXPECT_NEAR(values[1], 0.02, 1e-15) << "linear inside the step";
  EXPECT_NEAR(values[2], 0.04, 1e-15);
  EXPECT_EQ(table.values("steps", "tower").back(), 1.0);
}

TEST(OfferedQuantities, HavePeaksWithTheirSign) {
  HandMovedBuilding building;
  const Drift drift;
  OfferedQuantities offered;
  offered.add(drift);
  OfferedPeaks peaks{offered};
  peaks.start(building.move(0.0, 0.0, 0.0));
  peaks.step(building.move(1.0, 0.0, -0.03));
  peaks.step(building.move(2.0, 0.0, 0.02));
  ASSERT_EQ(peaks.peaks().size(), 2u);
  const Peak peak = peaks.peaks()[0];
  EXPECT_EQ(peak.quantity, "tilt");
  EXPECT_EQ(peak.where, "tower");
  EXPECT_EQ(peak.unit, "m");
  EXPECT_NEAR(peak.value, -0.03, 1e-15);
  EXPECT_EQ(peak.time, 1.0);
}

// A peak that a later, smaller value replaced.
TEST(OfferedQuantities, LeaveOutValuesThatAreNoNumbersAndSaySo) {
  struct Ratio final : QuantityRecorder {
    double value = 0.0;
    std::vector<OfferedQuantity> quantities() const override { return {{"ratio", "roof", "1"}}; }
    void sample(const StepView&, std::span<double> values) const override { values[0] = value; }
  } ratio;
  HandMovedBuilding building;
  OfferedQuantities offered;
  offered.add(ratio);
  OfferedPeaks peaks{offered}, without{offered};
  ratio.value = 100.0;
  peaks.start(building.move(0.0, 0.0, 0.0));
  EXPECT_TRUE(peaks.warnings().empty());
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    ratio.value = value;
    peaks.step(building.move(5.0, 0.0, 0.0));
    without.step(building.move(5.0, 0.0, 0.0));
  }
  ratio.value = 1.0;
  peaks.step(building.move(6.0, 0.0, 0.0));
  EXPECT_EQ(peaks.peaks()[0].value, 100.0);
  EXPECT_EQ(peaks.peaks()[0].time, 0.0);
  ASSERT_EQ(peaks.warnings().size(), 1u);
  EXPECT_TRUE(peaks.warnings()[0].starts_with(
      "The quantity \"ratio\" of a recorder is infinite or no number at \"roof\", first at t = 5 s, 2 times in all."))
      << peaks.warnings()[0];
  EXPECT_TRUE(std::isnan(without.peaks()[0].value));
}

TEST(OfferedQuantities, AreRefusedUnderANameThatIsTaken) {
  const HandMovedBuilding building;
  const Drift drift, again;
  OfferedQuantities offered;
  offered.add(drift);
  EXPECT_EQ(message_of<InputError>([&] { offered.add(again); }),
            "QuantityRecorder \"tilt\": the quantity is offered twice at \"tower\". Give it another place.");

  struct Displacement final : QuantityRecorder {
    std::vector<OfferedQuantity> quantities() const override { return {{"displacement", "base", "m"}}; }
    void sample(const StepView&, std::span<double>) const override {}
  } const displacement;
  OfferedQuantities taken;
  taken.add(displacement);
  HistoryRecorder recorder{building.model, 0.25};
  EXPECT_EQ(
      message_of<InputError>([&] { recorder.add(taken); }),
      "QuantityRecorder \"displacement\": moat records a quantity of this name at \"base\" itself. Choose another "
      "name.");
}

}  // namespace
}  // namespace moat
