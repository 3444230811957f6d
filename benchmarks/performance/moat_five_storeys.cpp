#include "performance/moat_five_storeys.hpp"

#include <cmath>
#include <moat.hpp>

#include "output/peak_recorder.hpp"
#include "paper/paper_building.hpp"

namespace moat::performance {
namespace {

double peak_of(const std::vector<Peak>& peaks, std::string_view quantity, std::string_view where) {
  for (const Peak& peak : peaks)
    if (peak.quantity == quantity && peak.where == where) return peak.magnitude();
  throw InputError{"There is no peak " + std::string{quantity} + " of " + std::string{where} + "."};
}

Peaks five_of(const std::vector<Peak>& peaks) {
  return {peak_of(peaks, "displacement", "base"), peak_of(peaks, "displacement", "floor 5"),
          peak_of(peaks, "absolute_acceleration", "base"), peak_of(peaks, "absolute_acceleration", "floor 5"),
          peak_of(peaks, "impact_force", "moat")};
}

}  // namespace

Model five_storey_model(bool locate_yield) {
  using namespace units;
  Model model;
  const auto building = add(model, ShearBuilding{.storeys = 5,
                                                 .floor_mass = paper::floor_mass,
                                                 .storey_stiffness = 1 * GN / m,
                                                 .damping = RayleighDamping{.ratio = 0.05},
                                                 .base_mass = paper::base_mass,
                                                 .isolation = LeadRubberBearing{.yield_force = 1.93 * MN,
                                                                                .yield_displacement = 1 * cm,
                                                                                .post_yield_stiffness = 19.3 * MN / m,
                                                                                .locate_yield = locate_yield}});
  add(model, Moat{.around = building.base,
                  .clearance = paper::paper_gap,
                  .law = HertzDamp{.stiffness = paper::hertz_impact_stiffness, .restitution = paper::restitution}});
  model.prepare();
  return model;
}

Peaks moat_peaks(const Model& model, const GroundMotion& motion, const TransientOptions& options) {
  Model copy = model;
  Transient analysis{copy, motion, options};
  PeakRecorder recorder{copy};
  analysis.attach(recorder);
  analysis.run();
  return five_of(recorder.peaks());
}

Peaks moat_case(const Model& model, const GroundMotion& motion, const TransientOptions& options,
                ErrorBarMode error_bars) {
  Model copy = model;
  return five_of(run_case(copy, motion, {.transient = options, .error_bars = error_bars}).peaks);
}

}  // namespace moat::performance
