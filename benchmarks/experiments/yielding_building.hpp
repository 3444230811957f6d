// An isolated building whose storeys yield, by its published numbers.
#pragma once

#include <moat.hpp>
#include <vector>

namespace moat::experiments {

/// Masses, initial stiffnesses, yield forces, and damping C = alpha M + beta K with the initial stiffness of all
/// storeys and bearings; the part of the mass acts against the ground. Base first.
struct YieldingBuilding {
  static constexpr double masses[] = {250e3, 270e3, 270e3, 180e3};               ///< kg
  static constexpr double stiffnesses[] = {50e6, 245e6, 195e6, 98e6};            ///< N/m
  static constexpr double yield_forces[] = {500e3, 1225e3, 975e3, 490e3};        ///< N
  static constexpr double post_yield_ratio = 0.05;                               ///< of the bearings
  static constexpr double alpha = 0.5059289317;                                  ///< 1/s
  static constexpr double beta = 0.003476512774;                                 ///< s
  static constexpr double periods[] = {0.959050, 0.282861, 0.174998, 0.122898};  ///< s
  static constexpr double damping_ratio = 0.05;                                  ///< in modes 1 and 2

  Model model;
  std::vector<NodeId> nodes;  ///< base and floors

  YieldingBuilding();
};

/// The initial periods of its model, s, longest first.
std::vector<double> periods_of(const YieldingBuilding& building);

}  // namespace moat::experiments
