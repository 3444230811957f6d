#include "model/weight/axial_distribution.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace moat {
namespace {

using Span = AxialDistribution::Span;
using Eigen::Matrix3d, Eigen::Vector3d;

// Places of round-off in forces, as a share of the weight.
constexpr double round_off = 1e-13;

// A point on the function phi(e) of a support, with its integral from 0, N^2.
struct Branch {
  double force, slope, integral;
};

Branch branch(const AxialSupport& support, double e) {
  if (e > 0.0) return {e, 1.0, 0.5 * e * e};
  if (support.cavitation < 0.0) return {0.0, 0.0, 0.0};
  const double ratio = support.tension_stiffness_ratio, force = ratio * e, limit = support.cavitation;
  if (force >= -limit) return {force, ratio, 0.5 * force * e};
  const double beyond = e + limit / ratio, cavitated = support.cavitated_stiffness_ratio;
  return {cavitated * beyond - limit, cavitated,
          0.5 * limit * limit / ratio + (0.5 * cavitated * beyond - limit) * beyond};
}

Vector3d vector(const std::array<double, 3>& triple) { return {triple[0], triple[1], triple[2]}; }

Vector3d arm_of(PlanVector place, Span span) { return {1.0, place.x, span == Span::plan ? place.y : 0.0}; }

// On a line the third equation is that of y = 0.
Matrix3d empty_hessian(Span span) {
  Matrix3d hessian = Matrix3d::Zero();
  if (span == Span::line) hessian(2, 2) = 1.0;
  return hessian;
}

bool is_singular(const Eigen::LDLT<Matrix3d>& factors) {
  constexpr double smallest_pivot = 1e-12;
  return !(factors.vectorD().minCoeff() > smallest_pivot * factors.vectorD().maxCoeff());
}

}  // namespace

// The residual sum N A - b, the convex function and its Hessian at a motion of the slab.
struct AxialDistribution::Balance {
  Vector3d residual;
  double value, size;  // size: of the terms of the value
  Matrix3d hessian;
};

AxialDistribution::AxialDistribution(std::vector<AxialSupport> supports, Span span)
    : supports_{std::move(supports)},
      span_{span},
      arms_(supports_.size()),
      elastic_(supports_.size()),
      slopes_(supports_.size()),
      inverse_{} {
  for (const AxialSupport& support : supports_) {
    centre_ += support.at / static_cast<double>(supports_.size());
    weight_ += support.share;
    may_pull_ = may_pull_ || support.cavitation > 0.0;
  }
  for (const AxialSupport& support : supports_)
    extent_ = std::max({extent_, std::abs(support.at.x - centre_.x), std::abs(support.at.y - centre_.y)});
}

AxialDistribution::Triple AxialDistribution::arm(std::size_t i, std::span<const PlanVector> shifts) const {
  PlanVector from_centre = supports_[i].at - centre_;
  if (!shifts.empty()) from_centre += shifts[i];
  return {1.0, from_centre.x / extent_, span_ == Span::plan ? from_centre.y / extent_ : 0.0};
}

AxialDistribution::Triple AxialDistribution::reduced(Resultant b) const {
  const PlanVector moment = b.moment - b.load * centre_;
  return {b.load, moment.x / extent_, span_ == Span::plan ? moment.y / extent_ : 0.0};
}

AxialDistribution::Balance AxialDistribution::balance(double sigma, const Triple& b, const Triple& motion) {
  Balance sum{-vector(b), 0.0, 0.0, empty_hessian(span_)};
  // Plain numbers: this loop is most of the work.
  double load = 0.0, x_moment = 0.0, y_moment = 0.0, k = 0.0, kx = 0.0, ky = 0.0, kxx = 0.0, kxy = 0.0, kyy = 0.0;
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    const AxialSupport& support = supports_[i];
    const double x = arms_[i][1], y = arms_[i][2];
    const double e = sigma * support.share + support.stiffness * (motion[0] + motion[1] * x + motion[2] * y);
    const Branch at = branch(support, e);
    elastic_[i] = e;
    // A support that presses by round-off alone does not hold the slab.
    slopes_[i] = support.cavitation < 0.0 && e <= round_off * weight_ ? 0.0 : at.slope;
    const double stiffness = slopes_[i] * support.stiffness;
    load += at.force;
    x_moment += at.force * x;
    y_moment += at.force * y;
    sum.value += at.integral / support.stiffness;
    k += stiffness;
    kx += stiffness * x;
    ky += stiffness * y;
    kxx += stiffness * x * x;
    kxy += stiffness * x * y;
    kyy += stiffness * y * y;
  }
  sum.residual += Vector3d{load, x_moment, y_moment};
  sum.hessian += (Matrix3d{} << k, kx, ky, kx, kxx, kxy, ky, kxy, kyy).finished();
  const Vector3d works = vector(b).cwiseProduct(vector(motion));
  sum.size = sum.value + works.lpNorm<1>();
  sum.value -= works.sum();
  return sum;
}

bool AxialDistribution::none(std::span<double> compressions) {
  std::ranges::fill(compressions, 0.0);
  std::ranges::fill(elastic_, 0.0);
  std::ranges::fill(slopes_, 0.0);
  inverse_ = {};
  return false;
}

bool AxialDistribution::distribute(double sigma, Resultant b, std::span<const PlanVector> shifts,
                                   std::span<double> compressions) {
  constexpr int most_iterations = 100, full_steps = 3;
  constexpr double armijo = 1e-4, growth = 8.0, shortest_step = 1e-12, longest_step = 1e12, stagnation = 1e-10,
                   softness = 1e-9, last_digits = 2e-15;
  if (!may_pull_ && b.load <= 0.0) return none(compressions);
  for (std::size_t i = 0; i < supports_.size(); ++i) arms_[i] = arm(i, shifts);
  const Triple wanted = reduced(b);
  Triple motion = motion_;
  Balance now = balance(sigma, wanted, motion);
  double before = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    Eigen::LDLT<Matrix3d> factors{now.hessian};
    const bool singular = is_singular(factors);
    const double residual = now.residual.lpNorm<Eigen::Infinity>();
    if (residual <= round_off * weight_ || (residual <= stagnation * weight_ && residual > 0.5 * before)) {
      if (singular) break;
      motion_ = motion;
      Eigen::Map<Matrix3d>{inverse_[0].data()} = factors.solve(Matrix3d::Identity());
      for (std::size_t i = 0; i < supports_.size(); ++i) compressions[i] = branch(supports_[i], elastic_[i]).force;
      return true;
    }
    if (singular) {
      if (!may_pull_ && reach({wanted[1] / wanted[0], wanted[2] / wanted[0]}, shifts) <= 1.0) break;
      // Soft springs, also where the slab is lifted, give a direction in which the function falls. They do not give the
      // length of the step: it grows while the function falls as steeply.
      for (std::size_t i = 0; i < supports_.size(); ++i)
        now.hessian += softness * supports_[i].stiffness * vector(arms_[i]) * vector(arms_[i]).transpose();
      factors.compute(now.hessian);
    }
    const Vector3d step = -factors.solve(now.residual);
    const double fall = now.residual.dot(step), noise = last_digits * now.size;
    const Vector3d from = vector(motion);
    const double value = now.value;
    bool grows = singular;
    for (double part = 1.0;; part *= grows ? growth : 0.5) {
      Eigen::Map<Vector3d>{motion.data()} = from + part * step;
      now = balance(sigma, wanted, motion);
      grows = grows && part < longest_step && now.residual.dot(step) < 0.5 * fall;
      const bool falls = now.value <= value + armijo * part * fall + noise;
      if (!grows && (iteration < full_steps || part < shortest_step || falls)) break;
    }
    before = residual;
  }
  return none(compressions);
}

double AxialDistribution::deficit(std::size_t i) const {
  return supports_[i].cavitation < 0.0 ? std::max(-elastic_[i], 0.0) : 0.0;
}

double AxialDistribution::by(std::size_t i, const Triple& b) const {
  return slopes_[i] * supports_[i].stiffness *
         vector(arms_[i]).dot(Eigen::Map<const Matrix3d>{inverse_[0].data()} * vector(b));
}

PlanVector AxialDistribution::by_moment(std::size_t i) const {
  return {by(i, reduced({0.0, {1.0, 0.0}})), by(i, reduced({0.0, {0.0, 1.0}}))};
}

double AxialDistribution::by_load(std::size_t i) const { return by(i, reduced({1.0, {}})); }

void AxialDistribution::rates(double sigma_rate, Resultant b_rate, std::span<const PlanVector> shift_rates,
                              std::span<double> compression_rates) const {
  // Nothing presses where there is no distribution: N is 0 and stays there.
  if (std::ranges::all_of(slopes_, [](double slope) { return slope == 0.0; })) {
    std::ranges::fill(compression_rates, 0.0);
    return;
  }
  // The rate of N while c rests, and that of the balance.
  Vector3d rest = vector(reduced(b_rate));
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    double rate = sigma_rate * supports_[i].share;
    if (!shift_rates.empty()) {
      const PlanVector moved = shift_rates[i] / extent_;
      const Vector3d turned{0.0, moved.x, span_ == Span::plan ? moved.y : 0.0};
      rate += supports_[i].stiffness * turned.dot(vector(motion_));
      rest -= branch(supports_[i], elastic_[i]).force * turned;
    }
    compression_rates[i] = rate;
    rest -= slopes_[i] * rate * vector(arms_[i]);
  }
  const Vector3d motion_rate = Eigen::Map<const Matrix3d>{inverse_[0].data()} * rest;
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    compression_rates[i] += supports_[i].stiffness * vector(arms_[i]).dot(motion_rate);
    if (slopes_[i] > 0.0) compression_rates[i] *= slopes_[i];
  }
}

// Largest factor of the way from the mean of the acting points to a point (both from the centre over the extent) at
// which it is still in their hull. The edge is found between a support on the left of the way and one on its right: the
// support that lies farthest beyond their connection takes the place of one of them until none is beyond.
double AxialDistribution::reach(PlanVector point, std::span<const PlanVector> shifts) const {
  const auto place = [&](std::size_t i) {
    const Triple a = arm(i, shifts);
    return PlanVector{a[1], a[2]};
  };
  PlanVector mean{};
  for (std::size_t i = 0; i < supports_.size(); ++i) mean += place(i) / static_cast<double>(supports_.size());
  const PlanVector way = point - mean;
  if (way == PlanVector{}) return std::numeric_limits<double>::infinity();
  const auto farthest = [&](PlanVector direction) {
    PlanVector found = place(0) - mean;
    for (std::size_t i = 1; i < supports_.size(); ++i)
      if (const PlanVector other = place(i) - mean; dot(direction, other) > dot(direction, found)) found = other;
    return found;
  };
  if (span_ == Span::line) return dot(way, farthest(way)) / dot(way, way);
  PlanVector left = farthest(turned_left(way)), right = farthest(-turned_left(way));
  for (std::size_t i = 0;; ++i) {
    const PlanVector outwards = -turned_left(left - right), beyond = farthest(outwards);
    constexpr double last_digits = 1e-15;
    if (i == supports_.size() || dot(outwards, beyond - right) <= last_digits * length(outwards))
      return dot(outwards, right) / dot(outwards, way);
    (cross(way, beyond) > 0.0 ? left : right) = beyond;
  }
}

Resultant AxialDistribution::moved_into_hull(Resultant b, std::span<const PlanVector> shifts) const {
  constexpr double inwards = 1e-9;  // of the extent
  if (b.load <= 0.0) return {};
  PlanVector mean = centre_;
  for (const PlanVector shift : shifts) mean += shift / static_cast<double>(shifts.size());
  const PlanVector way = b.moment / b.load - mean;
  const Triple from_centre = reduced(b);
  const double factor = reach({from_centre[1] / b.load, from_centre[2] / b.load}, shifts) -
                        inwards * extent_ / (span_ == Span::plan ? length(way) : std::abs(way.x));
  return factor < 1.0 ? Resultant{b.load, b.load * (mean + factor * way)} : b;
}

bool carries_moments(std::span<const PlanVector> positions, Span span) {
  double extent = 0.0;
  for (const PlanVector at : positions) extent = std::max(extent, length(at - positions[0]));
  if (extent == 0.0) return false;
  Matrix3d hessian = empty_hessian(span);
  for (const PlanVector at : positions) {
    const Vector3d arm = arm_of((at - positions[0]) / extent, span);
    hessian += arm * arm.transpose();
  }
  return !is_singular(Eigen::LDLT<Matrix3d>{hessian});
}

std::vector<double> balanced_shares(std::span<const PlanVector> positions, std::span<const double> stiffnesses,
                                    double weight, PlanVector centre, Span span) {
  Matrix3d hessian = empty_hessian(span);
  const auto arm = [&](PlanVector at) { return arm_of(at - centre, span); };
  for (std::size_t i = 0; i < positions.size(); ++i)
    hessian += stiffnesses[i] * arm(positions[i]) * arm(positions[i]).transpose();
  const Vector3d motion = hessian.ldlt().solve(Vector3d{weight, 0.0, 0.0});
  std::vector<double> shares(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) shares[i] = stiffnesses[i] * arm(positions[i]).dot(motion);
  return shares;
}

}  // namespace moat
