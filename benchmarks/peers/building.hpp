// A model that both programs compute, the five-storey building in its moat, and the motions that shake it.
#pragma once

#include <moat.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measuring/five_peaks.hpp"
#include "paper/paper_building.hpp"
#include "paper/records.hpp"

namespace moat::peers {

using namespace units;

inline AnalysisState at_rest(const Model& model) { return AnalysisState{model}; }

/// The five values by which a model is judged.
enum class Compared {
  impacts,  ///< displacements and absolute accelerations of base and top, and the force of gaps or of the first storey
  isolation,  ///< displacements of both, velocity of the base, acceleration of the top, and shear of the first storey
  plan,       ///< base: displacements along x and y; top: absolute accelerations along x and y; base: rotation
  rebounds,   ///< velocities at the end of the five nodes from base to top, m/s
};

/// A model with the nodes whose peaks are compared, and its motion from start(model) up to `end`, s.
struct Case {
  std::string name;
  Model model;
  NodeId base, top;
  GroundMotion motion;
  double end;
  AnalysisState (*start)(const Model&) = at_rest;
  Compared compared = Compared::impacts;
  std::optional<performance::Peaks> exact{};  ///< where a closed form gives them
};

/// The building of benchmarks/paper in its moat of 10 cm, over a whole motion.
template <class Law>
Case five_storeys(std::string name, const Law& law, const GroundMotion& motion) {
  Model model;
  const Building building = paper::add(model, {});
  add(model, Moat{.around = building.base, .clearance = paper::paper_gap, .law = law});
  return {std::move(name), std::move(model), building.base, building.floor(5), motion, motion.duration()};
}

inline HertzDamp hertz_damp() {
  return {.stiffness = paper::hertz_impact_stiffness, .restitution = paper::restitution};
}

/// The synthetic pulse and, if asked, the records of the paper but KBU000, all of 0.4 g.
inline std::vector<std::pair<std::string, GroundMotion>> motions(bool recorded) {
  std::vector<std::pair<std::string, GroundMotion>> list{{"pulse", near_fault_pulse().scaled_to_pga(paper::paper_pga)}};
  for (const paper::PaperRecord& record : paper::paper_records)
    if (recorded && record.label != std::string{"KBU000"})
      list.emplace_back(record.label, paper::read_unscaled(record).scaled_to_pga(paper::paper_pga));
  return list;
}

}  // namespace moat::peers
