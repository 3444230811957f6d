// Attaches two observers: one that offers a quantity, and one that counts steps. With MOAT_TEST_PAUSE the run takes
// longer than a second, so that it writes its progress to a log; with MOAT_TEST_INTEGRATOR it gives an integrator; with
// MOAT_TEST_NAME this text ends every name; with MOAT_TEST_MEMORY there is no memory after this number of steps; with
// MOAT_TEST_SHEET there is a design sheet.
#include <moat.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <thread>

#include "design/design_sheet.hpp"

using namespace moat;
using namespace moat::units;

const std::string end_of_names = std::getenv("MOAT_TEST_NAME") != nullptr ? std::getenv("MOAT_TEST_NAME") : "";

struct Momentum final : QuantityRecorder {
  std::vector<OfferedQuantity> quantities() const override {
    return {{"momentum" + end_of_names, "body" + end_of_names, "kg m/s" + end_of_names}};
  }
  void sample(const StepView& view, std::span<double> values) const override {
    values[0] = 2.0 * view.state.motion().velocity[0];
  }
};

struct StepCount final : StepObserver {
  void start(const StepView&) override {
    if (std::getenv("MOAT_TEST_PAUSE") != nullptr) std::this_thread::sleep_for(std::chrono::seconds{1});
  }
  void step(const StepView&) override {
    const char* last = std::getenv("MOAT_TEST_MEMORY");
    if (++steps, last != nullptr && steps > std::atoi(last)) throw std::bad_alloc{};
  }
  int steps = 0;
};

int main(int argc, char** argv) {
  Script script{argc, argv, "Observers" + end_of_names};
  Model model;
  const NodeId body = add(model, Node{.name = "body" + end_of_names, .mass = 2 * kg});
  add(model, ShearSpring{.name = "spring" + end_of_names, .lower = ground, .upper = body, .stiffness = 80 * N / m});
  const GroundMotion push{"push" + end_of_names, 0.01, std::vector<double>(101, 1.0)};
  Momentum momentum;
  StepCount count;
  script.attach(count);
  TransientOptions options;
  if (std::getenv("MOAT_TEST_INTEGRATOR") != nullptr) options.integrator = GeneralizedAlpha{.spectral_radius = 0.7};
  StepObserver* const observer = std::getenv("MOAT_TEST_NULL_OBSERVER") != nullptr ? nullptr : &momentum;
  if (std::getenv("MOAT_TEST_SHEET") != nullptr) script.design_sheet({.name = "body", .code = "a code"});
  const int exit_code = script.run(model, push, options, {observer});
  std::printf("%d steps\n", count.steps);
  return exit_code;
}
