// The compression of the bearings under a rigid slab.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/plan_vector.hpp"

namespace moat {

/// A bearing, as a vertical spring under a rigid slab. With e, N, the compression of a spring that always holds:
///
///     N |      /          N = e        where e > 0
///       |     /           N = 0        where e < 0, for compression only
///       |    /
///       +---/------- e    A bearing that may pull: N = tension_stiffness_ratio e until N = -cavitation;
///       _ -'              beyond, N falls by cavitated_stiffness_ratio e.
struct AxialSupport {
  PlanVector at{};                          ///< m
  double stiffness = 1.0;                   ///< k > 0 N/m
  double share = 0.0;                       ///< Static compression > 0 N.
  double cavitation = -1.0;                 ///< > 0 N: it may pull; < 0: compression only.
  double tension_stiffness_ratio = 1.0;     ///< > 0
  double cavitated_stiffness_ratio = 0.05;  ///< > 0
};

/// The vertical load on all bearings and its moments about the origin of the plan.
struct Resultant {
  double load = 0.0;    ///< V, N, downwards
  PlanVector moment{};  ///< sums of N_i x_i and N_i y_i, N m
};

/// Compressions N_i of bearings under a rigid slab, N, in balance with a resultant b = (V, M_x, M_y):
///
///     sum N_i A_i = b,   N_i = phi_i(e_i),   e_i = sigma share_i + k_i A_i.c,   A_i = (1, x_i, y_i)
///
/// phi_i is the function of AxialSupport and c the small motion of the slab. The compressions are unique: they minimise
/// the sum of (N_i - sigma share_i)^2/(2 k_i) over those in balance. A distribution exists where the resultant acts
/// inside the convex hull of the bearings, V > 0; farther where some of them may pull.
///
/// c minimises a convex function with the gradient sum N_i A_i - b (semismooth Newton; no step is needed where the same
/// bearings press as before and b is that of before).
class AxialDistribution {
 public:
  /// line: all y are 0 and moment.y is not used. plan: three equations.
  enum class Span { line, plan };

  /// At least two positions on a line, three not in a row in plan: see carries_moments().
  AxialDistribution(std::vector<AxialSupport> supports, Span span);

  /// Finds the compressions, N, one for each support; they act at the supports moved by `shifts`, m (empty: none).
  /// sigma multiplies the shares. Starts from the c of the last call that succeeded. Returns false, with all
  /// compressions 0, where no distribution exists: the slab rocks or flies.
  bool distribute(double sigma, Resultant b, std::span<const PlanVector> shifts, std::span<double> compressions);

  [[nodiscard]] std::size_t size() const { return supports_.size(); }  ///< Number of supports.
  /// Writes or reads the last distribution, from which the next one starts.
  void archive(auto& archive) { archive(arms_, elastic_, slopes_, motion_, inverse_); }

  // The following belong to the last distribution; they are zero after one that does not exist.
  /// e_i > 0.
  [[nodiscard]] bool presses(std::size_t i) const { return elastic_[i] > 0.0; }
  /// Stiffness times opening under the slab, N: -e_i > 0 where a support that cannot pull is lifted, else 0.
  [[nodiscard]] double deficit(std::size_t i) const;
  /// e_i/share_i: 1 at rest, 0 where it lifts.
  [[nodiscard]] double margin(std::size_t i) const { return elastic_[i] / supports_[i].share; }
  /// dN_i/dM_x and dN_i/dM_y at constant load and sigma, 1/m.
  [[nodiscard]] PlanVector by_moment(std::size_t i) const;
  /// dN_i/dV at constant moments and sigma, 1.
  [[nodiscard]] double by_load(std::size_t i) const;
  /// Rates N_i', N/s, of a lifted support that of e_i, from sigma', 1/s, b' and the rates of the shifts, m/s (empty:
  /// 0), while the same bearings press.
  void rates(double sigma_rate, Resultant b_rate, std::span<const PlanVector> shift_rates,
             std::span<double> compression_rates) const;

  /// Returns a resultant outside the hull of the bearings at the hull's edge, less 1e-9 of its extent: it moves towards
  /// the mean of their positions. One inside remains; one without load, V <= 0, becomes zero.
  [[nodiscard]] Resultant moved_into_hull(Resultant b, std::span<const PlanVector> shifts) const;

 private:
  using Triple = std::array<double, 3>;
  struct Balance;

  [[nodiscard]] Triple arm(std::size_t i, std::span<const PlanVector> shifts) const;
  [[nodiscard]] Triple reduced(Resultant b) const;
  [[nodiscard]] Balance balance(double sigma, const Triple& b, const Triple& motion);
  [[nodiscard]] double reach(PlanVector point, std::span<const PlanVector> shifts) const;
  [[nodiscard]] double by(std::size_t i, const Triple& b) const;
  bool none(std::span<double> compressions);

  std::vector<AxialSupport> supports_;
  Span span_;
  bool may_pull_ = false;
  double weight_ = 0.0;            // sum of the shares
  PlanVector centre_{};            // mean position
  double extent_ = 0.0;            // farthest of a support from it along an axis
  std::vector<Triple> arms_;       // 1, and the acting points from the centre over the extent
  std::vector<double> elastic_;    // e_i
  std::vector<double> slopes_;     // phi_i'(e_i)
  Triple motion_{};                // c
  std::array<Triple, 3> inverse_;  // of the Hessian, the sum of slope k A A^T
};

/// Whether supports at these places can balance a moment about every axis: two positions on a line, three not in a row
/// in plan.
[[nodiscard]] bool carries_moments(std::span<const PlanVector> positions, AxialDistribution::Span span);

/// Static compressions W_i = k_i A_i.c, N, whose resultant is a weight > 0 N at `centre`: those of a rigid slab on
/// vertical springs, one stiffness k_i > 0 for each position. Negative ones would be tension. The positions must carry
/// moments.
[[nodiscard]] std::vector<double> balanced_shares(std::span<const PlanVector> positions,
                                                  std::span<const double> stiffnesses, double weight, PlanVector centre,
                                                  AxialDistribution::Span span);

}  // namespace moat
