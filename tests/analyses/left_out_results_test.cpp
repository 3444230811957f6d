// Results of elements with constant tangents, which run() computes only for observers that read them.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "analyses/transient.hpp"
#include "analysis_testing.hpp"
#include "elements/lead_rubber_bearing.hpp"
#include "elements/shear_spring.hpp"
#include "elements/viscous_damper.hpp"
#include "output/peak_recorder.hpp"

namespace moat {
namespace {

using namespace units;
using testing::constant_acceleration;

constexpr double storey_stiffness = 80e6, damping = 90e3;

// The blocks are, in this order: storeys, dampers, bearings.
enum Block : std::size_t { storeys, dampers, bearings };

Model isolated_storey() {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = 50 * tonne});
  const NodeId floor = add(model, Node{.name = "floor", .mass = 40 * tonne});
  add(model, ShearSpring{.name = "storey", .lower = base, .upper = floor, .stiffness = storey_stiffness * N / m});
  add(model, ViscousDamper{.name = "damper", .lower = base, .upper = floor, .damping = damping * N * s / m});
  add(model, LeadRubberBearing{.name = "bearing",
                               .upper = base,
                               .yield_force = 40 * kN,
                               .yield_displacement = 1 * cm,
                               .post_yield_stiffness = 400 * kN / m});
  return model;
}

// Reads results of the given blocks; compares them with the motion of the nodes, or looks that they are left out.
class Reader final : public StepObserver {
 public:
  explicit Reader(std::vector<std::size_t> reads, std::vector<std::size_t> left_out = {})
      : reads_{std::move(reads)}, left_out_{std::move(left_out)} {}

  bool needs_results_of(std::size_t block) const override { return std::ranges::find(reads_, block) != reads_.end(); }
  void start(const StepView&) override {}
  void step(const StepView& view) override {
    ++steps;
    for (const std::size_t block : reads_) EXPECT_TRUE(is_up_to_date(view.model, block)) << "block " << block;
    for (const std::size_t block : left_out_) EXPECT_FALSE(is_up_to_date(view.model, block)) << "block " << block;
  }
  void finish(const StepView& view) override {
    for (const std::size_t block : {storeys, dampers, bearings})
      EXPECT_TRUE(is_up_to_date(view.model, block)) << "block " << block;
  }

  int steps = 0;

 private:
  static bool is_up_to_date(const Model& model, std::size_t block) {
    const Vector &u = model.state().displacement, &v = model.state().velocity, &a = model.state().acceleration;
    const ElementResults results = model.blocks()[block]->results();
    const int upper = block == bearings ? 0 : 1, lower = block == bearings ? 2 : 0;  // 2: the ground
    const double rate = v[upper] - v[lower];
    if (results.deformations[0] != u[upper] - u[lower]) return false;
    // Their rate is that with which the step was solved, before its velocity was corrected.
    if (block == bearings) return true;
    if (results.rates[0] != rate) return false;
    const double force = block == storeys ? storey_stiffness * (u[1] - u[0]) : damping * rate,
                 force_rate = block == storeys ? storey_stiffness * rate : damping * (a[1] - a[0]);
    return results.forces[0] == force && results.force_rates[0] == force_rate;
  }

  std::vector<std::size_t> reads_, left_out_;
};

GroundMotion push() { return constant_acceleration(2.0, 1 * s); }

class LeftOutResults : public ::testing::Test {
 protected:
  Model model = isolated_storey();
  Transient analysis{model, push()};
  Reader reader_of_bearings{{bearings}}, reader_of_all{{storeys, dampers, bearings}};
};

TEST_F(LeftOutResults, AreThoseThatNoObserverReads) {
  for (const auto& [reads, left_out] :
       std::vector<std::pair<std::vector<std::size_t>, std::vector<std::size_t>>>{{{bearings}, {storeys, dampers}},
                                                                                  {{storeys, bearings}, {dampers}},
                                                                                  {{dampers, bearings}, {storeys}},
                                                                                  {{storeys, dampers, bearings}, {}}}) {
    Model each = isolated_storey();
    Transient of_each{each, push()};
    Reader reader{reads, left_out};
    of_each.attach(reader);
    of_each.run();
    EXPECT_GT(reader.steps, 10);
  }
}

TEST_F(LeftOutResults, NoneAreWhereAnotherObserverReadsThem) {
  analysis.attach(reader_of_bearings);
  analysis.attach(reader_of_all);
  analysis.run();
  EXPECT_GT(reader_of_all.steps, 10);
}

// By hand, anything may be read between the steps.
TEST_F(LeftOutResults, NoneAreStepByStep) {
  while (!analysis.finished()) {
    analysis.advance();
    reader_of_all.step({model});
  }
  EXPECT_GT(reader_of_all.steps, 10);
}

TEST_F(LeftOutResults, ComeBackWhereARunIsStopped) {
  analysis.attach(reader_of_bearings);
  analysis.run([&] { return model.state().time > 0.3; });  // and finish() looks
  EXPECT_FALSE(analysis.finished());
  analysis.advance();
  reader_of_all.step({model});
}

TEST_F(LeftOutResults, AreThereForAnObserverThatIsAttachedDuringTheRun) {
  bool attached = false;
  analysis.run([&] {
    if (!attached && model.state().time > 0.3) {
      analysis.attach(reader_of_all);
      attached = true;
    }
    return false;
  });
  EXPECT_GT(reader_of_all.steps, 10);
}

TEST_F(LeftOutResults, AreThereInAnAnalysisOfACopyThatWasMadeDuringTheRun) {
  std::optional<Model> copy;
  Reader reader{{bearings}, {storeys, dampers}};
  analysis.attach(reader);
  analysis.run([&] {
    if (!copy && model.state().time > 0.3) copy.emplace(model);
    return false;
  });
  ASSERT_TRUE(copy);
  Transient of_copy{*copy, push()};
  reader_of_all.step({*copy});
  of_copy.advance();
  reader_of_all.step({*copy});
}

// No result of an element is needed for the motion.
TEST_F(LeftOutResults, DoNotChangeTheMotion) {
  Model with = isolated_storey();
  Transient of_with{with, push()};
  PeakRecorder peaks{with};
  of_with.attach(peaks);
  of_with.run();
  analysis.run();
  EXPECT_EQ(with.state().displacement, model.state().displacement);
  EXPECT_EQ(with.state().velocity, model.state().velocity);
}

}  // namespace
}  // namespace moat
