#include "analyses/unconnected_bodies.hpp"

#include <map>
#include <string>
#include <utility>

#include "analyses/error_bars.hpp"

namespace moat {
namespace {

std::vector<Model> bodies_of(Model& model) {
  model.prepare();
  return model.unconnected_bodies();
}

}  // namespace

UnconnectedBodies::UnconnectedBodies(Model& model) : bodies_{bodies_of(model)} {}

void UnconnectedBodies::replace(std::vector<Peak>& peaks, std::vector<GapClearance>& clearances,
                                const GroundMotion& motion, const TransientOptions& options, StepObserver* observer,
                                const std::function<bool()>& stop) {
  std::map<std::pair<std::string, std::string>, Peak> largest;  // by quantity and place
  std::map<std::string, GapClearance> of_gap;
  for (Model& body : bodies_) {
    const PeaksAndImpacts found = compute_peaks(body, motion, options, observer, stop);
    for (const Peak& peak : found.peaks) {
      // Elements of several bodies may be listed at one place.
      Peak& known = largest.try_emplace({peak.quantity, peak.where}, peak).first->second;
      if (peak.magnitude() > known.magnitude()) known = peak;
    }
    for (const GapClearance& gap : found.clearances) of_gap.emplace(gap.where, gap);
  }
  for (Peak& peak : peaks)
    if (const auto found = largest.find({peak.quantity, peak.where}); found != largest.end()) peak = found->second;
  for (GapClearance& gap : clearances)
    if (const auto found = of_gap.find(gap.where); found != of_gap.end()) gap = found->second;
}

}  // namespace moat
