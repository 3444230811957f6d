#include "moat.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace moat {
namespace {

using namespace units;

struct Idle : StepObserver {
  void start(const StepView&) override {}
  void step(const StepView&) override {}
};

struct Failing final : Idle {
  void finish(const StepView&) override { throw FileError{"the disk is full"}; }
};

struct Counting final : Idle {
  int finished = 0;
  void finish(const StepView&) override { ++finished; }
};

// Records its calls in their order, and adds others at its first step.
struct Inviting final : StepObserver {
  Observers* observers = nullptr;
  std::vector<std::unique_ptr<Inviting>> guests;
  std::string calls;

  void start(const StepView&) override { calls += 's'; }
  void step(const StepView&) override {
    if (calls == "s" && observers != nullptr)
      for (int i = 0; i < 20; ++i) observers->add(*guests.emplace_back(std::make_unique<Inviting>()));
    calls += '.';
  }
  void event(const StepView&, std::span<const RegimeChange>) override { calls += '!'; }
};

// Observers that are added while another one is called start before the next step, and miss the event of this one.
TEST(Observers, MayBeAddedInsideAStep) {
  Model model;
  add(model, Node{.name = "base", .mass = 1 * tonne});
  const AnalysisState state{model};
  const StepView view{model, state};
  Observers observers;
  Inviting first, last;
  first.observers = &observers;
  observers.add(first);
  observers.add(last);
  for (int step = 0; step < 2; ++step) {
    observers.start(view);
    observers.step(view);
    observers.event(view, {});
  }
  EXPECT_EQ(first.calls, "s.!.!");
  EXPECT_EQ(last.calls, "s.!.!");
  ASSERT_EQ(first.guests.size(), 20u);
  for (const auto& guest : first.guests) EXPECT_EQ(guest->calls, "s.!");
}

// An observer that cannot write its last file takes nothing from the others.
TEST(Observers, AreAllFinishedAlsoIfOneFails) {
  Model model;
  add(model, Node{.name = "base", .mass = 1 * tonne});
  const AnalysisState state{model};
  Failing failing;
  Counting before, after;
  Observers observers;
  for (StepObserver* observer : std::initializer_list<StepObserver*>{&before, &failing, &after})
    observers.add(*observer);
  EXPECT_THROW(observers.finish({model, state}), FileError);
  EXPECT_EQ(before.finished, 1);
  EXPECT_EQ(after.finished, 1);
}

}  // namespace
}  // namespace moat
