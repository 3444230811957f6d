// A pounding problem as plain numbers: the common input of moat and the independent reference.
#pragma once

#include <string>
#include <vector>

namespace moat::testing {

/// Index of the fixed ground among nodes.
inline constexpr int plain_ground = -1;

struct PlainNode {
  std::string name;
  double mass = 0.0;          ///< kg
  double displacement = 0.0;  ///< m, at the start, relative to the ground
  double velocity = 0.0;      ///< m/s, at the start
};

/// F = stiffness (u_upper - u_lower) + damping (v_upper - v_lower).
struct PlainSpring {
  enum class Kind {
    storey,  ///< reports drift and storey_shear; without damping
    frame,   ///< one of all pairs of a frame that bends, of either sign; those of one name are a matrix, which reports
             ///< nothing
    wall,    ///< of a wall that gives way, from the ground: reports wall_deformation and wall_force
  };
  std::string name;
  Kind kind = Kind::storey;
  int lower = plain_ground, upper = plain_ground;
  double stiffness = 0.0;  ///< N/m
  double damping = 0.0;    ///< N s/m
};

/// F = damping (v_upper - v_lower).
struct PlainDashpot {
  std::string name;
  int lower = plain_ground, upper = plain_ground;
  double damping = 0.0;  ///< N s/m
};

/// Bilinear hysteresis with kinematic hardening.
struct PlainBearing {
  enum class Kind {
    isolator,  ///< reports isolator_deformation and isolator_force
    storey,    ///< that yields: reports drift, storey_shear, ductility and residual_drift
  };
  std::string name;
  int lower = plain_ground, upper = plain_ground;
  double yield_force = 0.0;           ///< N
  double yield_displacement = 0.0;    ///< m
  double post_yield_stiffness = 0.0;  ///< N/m
  Kind kind = Kind::isolator;
};

/// The impact laws of the reference. tests/materials/reference_laws_test.cpp fails for a law of AllImpactLaws that has
/// no kind here, unless it names the law with a reason.
enum class PlainLawKind {
  linear_elastic,
  kelvin,
  anagnostopoulos,
  kelvin_by_damping_ratio,
  modified_linear_viscoelastic,
  exact_kelvin,
  hertz,
  hertz_damp,
  lankarani_nikravesh,
  hunt_crossley,
  gonthier,
  ye_2009,
  hu_guo,
  modified_hertz_damp,
  exact_hertz_damp,
  nonlinear_viscoelastic,
  modified_hertz_damp_printed,
};
inline constexpr int plain_law_kinds = static_cast<int>(PlainLawKind::modified_hertz_damp_printed) + 1;

/// When the dashpot of the printed modified Hertz-damp law acts. Others know whether they may pull only.
enum class PlainDamping { throughout, may_pull, approach_only };

struct PlainLaw {
  PlainLawKind kind = PlainLawKind::linear_elastic;
  double stiffness = 0.0;      ///< N/m or N/m^1.5
  double restitution = 1.0;    ///< intended; not used by elastic laws and kelvin_by_damping_ratio
  double damping_ratio = 0.0;  ///< of kelvin_by_damping_ratio
  PlainDamping acts = PlainDamping::throughout;
};

/// u = (1 - share) u_node + share u_other.
struct PlainPoint {
  int node = plain_ground;
  int other = plain_ground;
  double share = 0.0;
};

/// Indentation = u_left - u_right - clearance.
struct PlainGap {
  std::string name;
  std::string place;  ///< where its peaks are listed
  PlainPoint left, right;
  double clearance = 0.0;  ///< m
  PlainLaw law;
};

/// Linear between samples, zero after the last.
struct PlainMotion {
  double time_step = 0.0;       ///< s
  std::vector<double> samples;  ///< m/s^2
};

struct PlainModel {
  std::vector<PlainNode> nodes;
  std::vector<PlainSpring> springs;
  std::vector<PlainDashpot> dashpots;
  std::vector<PlainBearing> bearings;
  std::vector<PlainGap> gaps;
  PlainMotion motion;
  double end = 0.0;  ///< s, a whole number of time steps of the motion
};

}  // namespace moat::testing
