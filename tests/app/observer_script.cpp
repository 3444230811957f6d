// Attaches two observers: one that offers a quantity, and one that counts steps. With MOAT_TEST_PAUSE the run takes
// longer than a second, so that it writes its progress to a log; with MOAT_TEST_INTEGRATOR it gives an integrator.
#include <moat.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

using namespace moat;
using namespace moat::units;

struct Momentum final : QuantityRecorder {
  std::vector<OfferedQuantity> quantities() const override { return {{"momentum", "body", "kg m/s"}}; }
  void sample(const StepView& view, std::span<double> values) const override {
    values[0] = 2.0 * view.model.state().velocity[0];
  }
};

struct StepCount final : StepObserver {
  void start(const StepView&) override {
    if (std::getenv("MOAT_TEST_PAUSE") != nullptr) std::this_thread::sleep_for(std::chrono::seconds{1});
  }
  void step(const StepView&) override { ++steps; }
  int steps = 0;
};

int main(int argc, char** argv) {
  Script script{argc, argv, "Observers"};
  Model model;
  const NodeId body = add(model, Node{.name = "body", .mass = 2 * kg});
  add(model, ShearSpring{.name = "spring", .lower = ground, .upper = body, .stiffness = 80 * N / m});
  const GroundMotion push{"push", 0.01, std::vector<double>(101, 1.0)};
  Momentum momentum;
  StepCount count;
  script.attach(count);
  TransientOptions options;
  if (std::getenv("MOAT_TEST_INTEGRATOR") != nullptr) options.integrator = GeneralizedAlpha{.spectral_radius = 0.7};
  StepObserver* const observer = std::getenv("MOAT_TEST_NULL_OBSERVER") != nullptr ? nullptr : &momentum;
  const int exit_code = script.run(model, push, options, {observer});
  std::printf("%d steps\n", count.steps);
  return exit_code;
}
