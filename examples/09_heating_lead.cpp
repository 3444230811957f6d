// Tour 9: lead-rubber bearings whose lead heats and weakens. Read 01_moat_wall.cpp and 08_friction_pendulum.cpp before.
//
//         _________
//        |   | |   |         Q = Q0 exp(-E2 T): every metre of slip warms the lead, and steel conducts heat away.
//        |===| |===|
//        |___|_|___|         A bilinear model has one strength. Taken from the first cycle, it is too strong in a long
//             lead           motion; taken from the third, too weak in the first pulse, when the wall is near.
//
// The picture loops.svg shows both loops, and the second panel the temperature.
//
//     ./moat run examples/09_heating_lead.cpp
//     ./moat run examples/09_heating_lead.cpp --cycles 12
#include <moat.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

using namespace moat;
using namespace moat::units;

// A harmonic ground motion that begins and ends smoothly.
GroundMotion shaking(int cycles) {
  constexpr double step = 0.005, period = 2.0;
  std::vector<double> samples;
  for (int i = 0; i * step <= cycles * period; ++i) {
    const double t = i * step, rise = std::sin(std::numbers::pi * t / (cycles * period));
    samples.push_back(2.5 * rise * rise * std::sin(2.0 * std::numbers::pi * t / period));
  }
  return GroundMotion{"shaking", step, samples};
}

Model building(Isolation isolation) {
  Model model;
  add(model, ShearBuilding{.storeys = 3,
                           .floor_mass = 250 * tonne,
                           .storey_stiffness = 0.6 * GN / m,
                           .damping = {.ratio = 0.05},
                           .base_mass = 250 * tonne,
                           .isolation = isolation});
  return model;
}

int main(int argc, char** argv) {
  Script script{argc, argv, "Building on lead-rubber bearings that heat"};
  const int cycles = script.integer("cycles", 8, "of the ground motion");
  const std::string picture = script.text("picture", "loops.svg", "file of the picture");
  const GroundMotion motion = script.motion(shaking(cycles));

  HeatedLeadRubber bearing = HeatedLeadRubber::typical();
  const Isolator<HeatedLeadRubber> heating{.law = bearing, .count = 4};
  bearing.weakening = 0.0;
  const Isolator<HeatedLeadRubber> constant{.law = bearing, .count = 4};

  std::vector<Chart> charts{
      {.title = "Loops", .x_label = "deformation of the bearings [cm]", .y_label = "force [MN]", .series = {}},
      {.title = "Lead", .x_label = "time [s]", .y_label = "rise of temperature [K]", .series = {}}};
  for (const auto& [name, isolation] : {std::pair{"heating", heating}, std::pair{"constant strength", constant}}) {
    Model model = building(isolation);
    const CaseResult result = run_case(model, motion, {.history_interval = 5 * ms});
    Series loop{.name = name, .x = {}, .y = {}}, heat = loop;
    for (const double u : result.histories.values("isolator_deformation", "bearings")) loop.x.push_back(100 * u);
    for (const double f : result.histories.values("isolator_force", "bearings")) loop.y.push_back(f / 1e6);
    heat.x = result.histories.values("time");
    heat.y = result.histories.values("lead_temperature_rise", "bearings");
    charts[0].series.push_back(loop);
    if (isolation.law.weakening > 0.0) charts[1].series.push_back(heat);
    for (const Peak& peak : result.peaks)
      if (peak.quantity == "isolator_deformation") std::printf("%-20s %5.1f cm\n", name, 100.0 * peak.magnitude());
  }
  write_svg(charts, picture);

  Model model = building(heating);
  return script.run(model, motion);  // the report lists lead_temperature_rise and characteristic_strength
}
