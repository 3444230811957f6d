// The five-storey building in its moat, and the motions that shake it.
#pragma once

#include <filesystem>
#include <moat.hpp>
#include <string>
#include <utility>
#include <vector>

#include "paper/paper_building.hpp"

namespace moat::peers {

/// A model with the nodes whose peaks are compared, and its motion up to `end`, s.
struct Case {
  std::string name;
  Model model;
  NodeId base, top;
  GroundMotion motion;
  double end;
};

/// Balanced at the start of the motion, so that every program starts with the same accelerations.
inline Case balanced(std::string name, Model model, NodeId base, NodeId top, const GroundMotion& motion, double end) {
  const Transient at_start{model, motion};
  return {std::move(name), std::move(model), base, top, motion, end};
}

/// The building of benchmarks/paper in its moat of 10 cm, over a whole motion.
template <class Law>
Case five_storeys(std::string name, const Law& law, const GroundMotion& motion) {
  Model model;
  const Building building = paper::add(model, {});
  add(model, Moat{.around = building.base, .clearance = paper::paper_gap, .law = law});
  return balanced(std::move(name), std::move(model), building.base, building.floor(5), motion, motion.duration());
}

inline HertzDamp hertz_damp() {
  return {.stiffness = paper::hertz_impact_stiffness, .restitution = paper::restitution};
}

/// The synthetic pulse and, from the folder of records unless that is empty, three recorded motions, all of 0.4 g.
inline std::vector<std::pair<std::string, GroundMotion>> motions(const std::filesystem::path& records) {
  std::vector<std::pair<std::string, GroundMotion>> list{{"pulse", near_fault_pulse()}};
  if (!records.empty())
    for (const auto& [name, file] :
         {std::pair{"GBZ000", "RSN1161_KOCAELI_GBZ000.AT2"}, std::pair{"JEN022", "RSN982_NORTHR_JEN022.AT2"},
          std::pair{"WVC270", "RSN803_LOMAP_WVC270.AT2"}})
      list.emplace_back(name, read_motion(records / file));
  for (auto& [name, motion] : list) motion = motion.scaled_to_pga(0.4 * units::g);
  return list;
}

}  // namespace moat::peers
