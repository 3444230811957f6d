// Modes of a superstructure, and damping by modes.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "structures/superstructure/structure_system.hpp"

namespace moat {

/// Adds shapes, modal stiffness and damping to a system that has its mass. `into_metres` has the radius of gyration of
/// every rotation, else 1; `positions` those of the system's rows among the rows of the shapes. Throws InputError for
/// shapes that are not orthogonal, or not of norm 1, within 2 %.
void add_modes(const StructureModes& modes, decltype(Superstructure::damping) damping, const Check& check,
               const Eigen::VectorXd& into_metres, const std::vector<int>& positions, StructureSystem& system);

/// Returns the ratios of `count` modes; a note says so where the last given one holds for more. Throws InputError for a
/// ratio outside [0, 1).
Eigen::VectorXd ratios_of(const Check& check, const ModalDamping& damping, Eigen::Index count,
                          std::vector<std::string>& notes);

/// Returns the factors as given, or those that give the ratio in the first mode and in the next one along the same
/// direction. Throws InputError as given_factors() does.
RayleighFactors rayleigh_factors_of(const RayleighDamping& damping, const std::vector<ParticipatingMass>& modes);

/// Returns the share of every mode, from the squared frequencies w^2, 1/s^2, the rows Q' M R of shapes with
/// Q' M Q = I, and the mass R' M R.
std::vector<ParticipatingMass> participating_masses(const Eigen::VectorXd& squared_frequencies,
                                                    const Eigen::MatrixXd& loads, const Eigen::MatrixXd& mass);

}  // namespace moat
