#include "output/recorders/history_recorder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "message_of.hpp"
#include "recorders_testing.hpp"

namespace moat {
namespace {

using testing_output::HandMovedBuilding;

std::vector<double> recorded_times(double interval, const std::vector<double>& times) {
  HandMovedBuilding building;
  HistoryRecorder recorder{building.model, interval};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const StepView view = building.move(times[i], times[i], 0.0);
    if (i == 0)
      recorder.start(view);
    else
      recorder.step(view);
  }
  require_equal_lengths(recorder.table());
  return recorder.table().columns.front().values;
}

TEST(HistoryRecorder, KeepsEveryMultipleOfItsInterval) {
  EXPECT_EQ(recorded_times(0.1, {0.0, 0.05, 0.1, 0.15, 0.2}), (std::vector<double>{0.0, 0.1, 0.2}));
  EXPECT_EQ(recorded_times(0.1, {0.0, 0.04, 0.08, 0.12, 0.16, 0.2, 0.24}), (std::vector<double>{0.0, 0.1, 0.2}));
  // Also inside steps longer than the interval.
  EXPECT_EQ(recorded_times(0.25, {0.0, 0.6, 1.1}), (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
}

TEST(HistoryRecorder, InterpolatesByValueAndRate) {
  // The base moves like exp(t/10), as the hand-moved building's velocities say.
  HandMovedBuilding building;
  HistoryRecorder recorder{building.model, 0.25};
  recorder.start(building.move(0.0, 0.01, 0.01, 1e-4, 1e-4));
  const double end = 0.01 * std::exp(0.1);
  recorder.step(building.move(1.0, end, end, 0.01 * end, 0.01 * end, 2.0));
  const Table table = recorder.table();
  ASSERT_EQ(table.rows(), 5u);
  const auto displacement =
      static_cast<std::size_t>(testing_output::find(Channels{building.model}, "displacement", "base")) + 2;
  for (std::size_t i = 0; i < 5; ++i) {
    const double time = 0.25 * static_cast<double>(i);
    EXPECT_DOUBLE_EQ(table.columns[0].values[i], time);
    EXPECT_DOUBLE_EQ(table.columns[1].values[i], 2.0 * time);
    EXPECT_NEAR(table.columns[displacement].values[i], 0.01 * std::exp(0.1 * time), end * 1e-4 / 384.0);
  }
}

TEST(HistoryRecorder, HasTheOpeningOfEveryGap) {
  HandMovedBuilding building;
  HistoryRecorder recorder{building.model, 0.5};
  recorder.start(building.move(0.0, 0.0, 0.0));
  recorder.step(building.move(0.5, 0.12, 0.0));
  EXPECT_NEAR(recorder.table().values("opening", "moat left")[1], 0.22, 1e-15);
  EXPECT_NEAR(recorder.table().values("opening", "moat right")[1], -0.02, 1e-15) << "indented";
}

TEST(HistoryRecorder, RoundOffOfTimesDoesNotMatter) {
  std::vector<double> times, expected;
  for (int i = 0; i <= 30000; ++i) times.push_back(i * 0.001);
  for (int i = 0; i <= 30000; i += 5) expected.push_back(i * 0.001);
  EXPECT_EQ(recorded_times(0.005, times), expected);
}

TEST(HistoryRecorder, AddsNoRowForAnEvent) {
  HandMovedBuilding building;
  HistoryRecorder recorder{building.model, 0.1};
  recorder.start(building.move(0.0, 0.0, 0.0));
  recorder.step(building.move(0.11, 0.0, 0.0, 0.0, 0.0, 0.0, false));
  recorder.event(building.move(0.11, 0.0, 0.0, 0.0, 0.0, 0.0, false), {});
  recorder.step(building.move(0.15, 0.0, 0.0));
  EXPECT_EQ(recorder.table().columns.front().values, (std::vector<double>{0.0, 0.1}));
}

TEST(HistoryRecorder, StartsWhereTheModelIs) {
  EXPECT_EQ(recorded_times(0.1, {7.3, 7.35, 7.4, 7.45, 7.5}), (std::vector<double>{7.3, 7.4, 7.5}));
  EXPECT_EQ(recorded_times(0.5, {7.3, 7.5, 7.9, 8.1}), (std::vector<double>{7.5, 8.0}));
}

TEST(HistoryRecorder, SharesTheSamplesOfPeaks) {
  HandMovedBuilding building;
  PeakRecorder peaks{building.model};
  HistoryRecorder own{building.model, 0.1}, sharing{building.model, 0.1};
  sharing.share_samples_of(peaks);
  const std::vector<StepObserver*> observers{&peaks, &own, &sharing};
  const StepView at_start = building.move(0.0, 0.0, 0.01);
  for (StepObserver* observer : observers) observer->start(at_start);
  const StepView touch = building.move(0.17, 0.1, 0.02, -3.0, 2.0, 1.0);
  for (StepObserver* observer : observers) observer->step(touch);
  // The force jumps here, and the accelerations with it.
  const std::vector<RegimeChange> changes{{.touched = true}};
  const StepView behind = building.move(0.17, 0.1, 0.02, -7.0, 2.0, 1.0);
  for (StepObserver* observer : observers) observer->event(behind, changes);
  const StepView at_end = building.move(0.32, 0.12, 0.05, -5.0, 1.0);
  for (StepObserver* observer : observers) observer->step(at_end);
  const Table expected = own.table(), found = sharing.table();
  ASSERT_EQ(found.rows(), 4u);
  ASSERT_EQ(found.columns.size(), expected.columns.size());
  for (std::size_t i = 0; i < found.columns.size(); ++i)
    EXPECT_EQ(found.columns[i].values, expected.columns[i].values) << found.columns[i].quantity;
}

TEST(HistoryRecorder, HasMoreRowsThanExpected) {
  HandMovedBuilding building;
  HistoryRecorder recorder{building.model, 0.1};
  recorder.reserve(0.2);
  recorder.start(building.move(0.0, 0.0, 0.01));
  recorder.step(building.move(1.0, 0.0, 0.01));
  EXPECT_EQ(recorder.table().rows(), 11u);
  const Table taken = recorder.take_table();
  EXPECT_EQ(taken.rows(), 11u);
  require_equal_lengths(taken);
  EXPECT_TRUE(recorder.table().columns.empty());
}

TEST(HistoryRecorder, TakesFewerRowsWhereTheMemoryIsSmall) {
  HandMovedBuilding building;
  HistoryRecorder recorder{building.model, 0.1};
  const double row = static_cast<double>(recorder.table().columns.size()) * 500.0 / 45.0;
  EXPECT_EQ(recorder.fit(10.0, 101.5 * row), 0.0);
  EXPECT_EQ(recorder.interval(), 0.1);
  EXPECT_DOUBLE_EQ(recorder.fit(10.0, 40.0 * row), 101.0 * row);
  EXPECT_DOUBLE_EQ(recorder.interval(), 0.5);
  recorder.start(building.move(0.0, 0.0, 0.01));
  recorder.step(building.move(1.0, 0.0, 0.01));
  EXPECT_EQ(recorder.table().rows(), 3u) << "at 0, 0.5 and 1 s";
}

TEST(HistoryRecorder, HasAColumnForTimeGroundAndEveryChannel) {
  HandMovedBuilding building;
  HistoryRecorder recorder{building.model, 0.1};
  recorder.start(building.move(0.0, 0.02, 0.03, 4.0, 5.0, 1.5));
  const Table table = recorder.table();
  const Channels channels{building.model};
  ASSERT_EQ(table.columns.size(), channels.list().size() + 2 + 2) << "two gaps have openings";
  EXPECT_EQ(column_name(table.columns[0]), "time [s]");
  EXPECT_EQ(column_name(table.columns[1]), "ground_acceleration [m/s^2] ground");
  EXPECT_EQ(table.columns[1].values, std::vector<double>{1.5});
  std::vector<double> values, rates;
  channels.sample({building.model, *building.state, {1.5}}, values, rates);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(table.columns[i + 2].quantity, channels.list()[i].quantity);
    EXPECT_EQ(table.columns[i + 2].where, channels.list()[i].where);
    EXPECT_EQ(table.columns[i + 2].unit, channels.list()[i].unit);
    EXPECT_EQ(table.columns[i + 2].values, std::vector<double>{values[i]});
  }
}

TEST(HistoryRecorder, RefusesAnIntervalThatIsNotPositive) {
  const HandMovedBuilding building;
  EXPECT_EQ(
      testing::message_of([&] { HistoryRecorder(building.model, 0.0); }),
      "HistoryRecorder: interval = 0 s is not allowed; it must be > 0 s and finite. Check its sign and its unit.");
}

}  // namespace
}  // namespace moat
