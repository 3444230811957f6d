#include "analyses/observers.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "output/step_observer.hpp"

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

// An observer that cannot write its last file takes nothing from the others.
TEST(Observers, AreAllFinishedAlsoIfOneFails) {
  Model model;
  add(model, Node{.name = "base", .mass = 1 * tonne});
  model.prepare();
  Failing failing;
  Counting before, after;
  Observers observers;
  for (StepObserver* observer : std::initializer_list<StepObserver*>{&before, &failing, &after})
    observers.add(*observer);
  EXPECT_THROW(observers.finish({model, 0.0, true}), FileError);
  EXPECT_EQ(before.finished, 1);
  EXPECT_EQ(after.finished, 1);
}

}  // namespace
}  // namespace moat
