// A street of isolated buildings that pound each other: a model of any size.
#pragma once

#include <moat.hpp>
#include <string>

namespace moat::performance {

/// Buildings in a row, each five storeys on lead-rubber bearings, with a fixed wall at both ends of the street:
///
///     wall | [ 1 ] | [ 2 ] | ... | [ B ] | wall        6 degrees of freedom per building, B + 1 gaps
///
/// The building is that of the first tour. Post-yield stiffness of the bearings and mass of the floors differ from
/// building to building by up to 30 % either way, and so do their isolation periods (2.0 to 3.4 s); the clearances are
/// 2 to 6 cm. All follow additive sequences of irrational steps: the same street for the same number of buildings, in
/// which no two neighbours are alike.
///
/// Gaps have the contact law of the first tour, or another one. Throws InputError unless buildings >= 2.
Model street(int buildings);
Model street(int buildings, const NamedImpactLaw& law);  ///< With this law in all gaps.

/// The state in which a street starts, at the instant of the pulse's largest motion: every building stands within 2 cm
/// of its place, and all its floors move alike with up to 0.6 m/s, so that contacts begin and end from the first steps
/// on. The model must outlive it.
AnalysisState street_at_start(const Model& street);

/// A law of that name (impact_law_names()) about as stiff as that of street(int), with a restitution of 0.65.
NamedImpactLaw street_law(const std::string& name);

inline constexpr int degrees_of_freedom_per_building = 6;

/// The pulse that shakes the street: its default, from its beginning on.
GroundMotion street_motion();

}  // namespace moat::performance
