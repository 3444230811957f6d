#include "peers/moat_histories.hpp"

#include <algorithm>
#include <cmath>
#include <moat.hpp>

#include "measuring/measure.hpp"
#include "output/peaks/peak_recorder.hpp"

namespace moat::peers {
namespace {

// A quantity at a place, or at all where the place is empty.
struct Sought {
  std::string quantity, where;
};

bool has_contacts(const Model& model) {
  return std::ranges::any_of(model.blocks(), [](const auto& block) { return block->kind().contacts; });
}

std::array<Sought, 5> sought(const Case& of) {
  const auto name = [&](NodeId node) {
    const PlacedDiaphragm* diaphragm = of.model.diaphragm_of(node);
    return diaphragm != nullptr ? diaphragm->name : std::string{of.model.node_name(node)};
  };
  const std::string base = name(of.base), top = name(of.top);
  if (of.compared == Compared::plan)
    return {{{"displacement_x", base},
             {"displacement_y", base},
             {"absolute_acceleration_x", top},
             {"absolute_acceleration_y", top},
             {"rotation", base}}};
  std::array<Sought, 5> list{{{"displacement", base},
                              {"displacement", top},
                              {"absolute_acceleration", base},
                              {"absolute_acceleration", top},
                              {"impact_force", ""}}};
  if (of.compared == Compared::isolation) list[2] = {"velocity", base};
  if (!has_contacts(of.model)) list[4] = {"storey_shear", "storey 1"};
  return list;
}

}  // namespace

History moat_history(const Case& of, TransientOptions options) {
  options.end = of.end * units::s;
  AnalysisState at_start = of.start(of.model);
  const double start = performance::seconds();
  Transient analysis{of.model, of.motion, std::move(at_start), options};
  History history;
  if (of.compared == Compared::rebounds) {
    analysis.run();
    history.seconds = performance::seconds() - start;
    for (int i = 0; i <= of.top.index - of.base.index; ++i)
      history.peaks.at(static_cast<std::size_t>(i)) = std::abs(analysis.state().velocity(NodeId{of.base.index + i}));
    return history;
  }
  PeakRecorder recorder{of.model};
  analysis.attach(recorder);
  analysis.run();
  history.seconds = performance::seconds() - start;
  const std::array<Sought, 5> all = sought(of);
  for (const Peak& peak : recorder.peaks())
    for (std::size_t i = 0; i < all.size(); ++i)
      if (peak.quantity == all[i].quantity && (peak.where == all[i].where || all[i].where.empty()))
        history.peaks[i] = std::max(history.peaks[i], peak.magnitude());
  return history;
}

Ladder moat_ladder(const Case& of, const std::string& name, Integrator integrator) {
  Ladder ladder{name, {}};
  for (const int steps : {4, 6, 8, 11, 16, 23, 32, 45, 64})
    ladder.settings.push_back(
        {std::to_string(steps) + " steps per contact", [&of, integrator, steps] {
           const double tolerance = std::min(0.12 / (static_cast<double>(steps) * steps), 1e-2);
           return moat_history(of, {.integrator = integrator, .tolerance = tolerance, .steps_per_contact = steps});
         }});
  return ladder;
}

performance::Peaks reference_of(const Case& of) {
  return of.exact ? *of.exact : moat_history(of, {.tolerance = 1e-8, .steps_per_contact = 2048}).peaks;
}

}  // namespace moat::peers
