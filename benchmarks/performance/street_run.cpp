#include "performance/street_run.hpp"

#include <string>
#include <utility>

#include "measuring/command_output.hpp"
#include "measuring/measure.hpp"
#include "measuring/street.hpp"
#include "output/recorders/energy_ledger.hpp"

namespace moat::performance {

StreetReport measure_street(const StreetSetting& setting) {
  StreetReport report;
  double start = seconds(Clock::wall);
  const Model model = street(setting.buildings);
  AnalysisState at_start = street_at_start(model);
  report.degrees_of_freedom = model.degrees_of_freedom();
  report.build_seconds = seconds(Clock::wall) - start;

  TransientOptions options{.step = 2.5 * units::ms, .events = EventTreatment::at_end_of_step};
  // A street has many contacts, none of which chatters.
  options.max_events_per_second = 1'000'000'000;
  Transient transient{model, street_motion(), std::move(at_start), options};
  EnergyLedger ledger;
  transient.attach(ledger);

  for (int i = 0; i < setting.steps_before; ++i) transient.advance();
  for (int i = 0; i < setting.steps; ++i) {
    const long iterations = transient.statistics().newton_iterations;
    start = seconds(Clock::wall);
    transient.advance();
    report.step_seconds.push_back(seconds(Clock::wall) - start);
    report.step_iterations.push_back(static_cast<double>(transient.statistics().newton_iterations - iterations));
  }
  report.peak_bytes = peak_resident_bytes();
  return report;
}

StreetReport run_street(int buildings) {
  return nlohmann::json::parse(output_of_this_program("street --buildings " + std::to_string(buildings)))
      .get<StreetReport>();
}

}  // namespace moat::performance
