#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/text/number_format.hpp"
#include "solvers/factorisation.hpp"
#include "structures/frame/constraints.hpp"
#include "structures/frame/finite_elements.hpp"

namespace moat {
namespace {

using Index = Eigen::Index;
using Dense = Eigen::MatrixXd;

// The symmetric part of a matrix, after a check.
SparseMatrix symmetric_part(const Check& check, const std::string& what, const SparseMatrix& matrix,
                            const Constraints& parts, std::vector<std::string>& notes) {
  const Index unknowns = parts.of_levels.rows();
  check.that(matrix.rows() == unknowns && matrix.cols() == unknowns,
             what + " has " + std::to_string(matrix.rows()) + " rows and " + std::to_string(matrix.cols()) +
                 " columns, the model has " + std::to_string(unknowns) + " unknowns.");
  const Vector diagonal = matrix.diagonal();
  const auto name = [&](Index unknown) { return parts.names[static_cast<std::size_t>(unknown)]; };
  const SparseMatrix transposed = matrix.transpose();
  double worst = 0.0;
  Eigen::Triplet<double> entry_of_worst;
  for (Index column = 0; column < unknowns; ++column)
    for (SparseMatrix::InnerIterator entry{matrix, column}; entry; ++entry) {
      if (!std::isfinite(entry.value()))
        check.that(false, what + " has an entry that is not finite, at " + name(column) + ".");
      const double difference = std::abs(entry.value() - transposed.coeff(entry.row(), column));
      const double share = difference / std::sqrt(std::abs(diagonal[entry.row()] * diagonal[column]));
      if (difference == 0.0 || share <= worst) continue;
      worst = share;
      entry_of_worst = {static_cast<int>(entry.row()), static_cast<int>(column), entry.value()};
    }
  if (worst > 1e-6)
    check.that(false, what + " is not symmetric: entry (" + name(entry_of_worst.row()) + "; " +
                          name(entry_of_worst.col()) + ") = " + to_text(entry_of_worst.value()) + ", transposed " +
                          to_text(transposed.coeff(entry_of_worst.row(), entry_of_worst.col())) + ", " +
                          to_significant(100.0 * worst, 3) + " % of the diagonals.");
  if (worst > 1e-12)
    notes.push_back(what + " is not symmetric by " + to_text(worst) + " of its diagonals; the mean is taken.");
  return worst > 0.0 ? SparseMatrix{0.5 * (matrix + transposed)} : matrix;
}

// K_ss, scaled to ones on the diagonal, with its factors.
class Condenser {
 public:
  Condenser(const SparseMatrix& stiffness, const Constraints& parts, const Check& check) : parts_{parts} {
    const Vector diagonal = stiffness.diagonal();
    for (Index i = 0; i < diagonal.size(); ++i) {
      if (diagonal[i] == 0.0) refuse_loose(i, check);
      if (!(diagonal[i] > 0.0))
        check.that(false, "stiffness of " + name(i) + " is " + to_text(diagonal[i]) + ".",
                   "The order or the unit of the matrix may be another.");
    }
    scale_ = diagonal.cwiseSqrt().cwiseInverse();
    const SparseMatrix scaled = scale_.asDiagonal() * stiffness * scale_.asDiagonal();
    if (diagonal.size() == 0) return;
    // A shift leaves the weakest mode of a singular matrix where it is.
    if (const bool regular = factors_.factorise(scaled); !regular || weakest(factors_) < smallest_eigenvalue) {
      SparseMatrix unit(scaled.rows(), scaled.cols());
      unit.setIdentity();
      Factorisation shifted;
      if (shifted.factorise(scaled + 1e-10 * unit)) weakest(shifted);
      refuse_loose(loosest_, check);
    }
  }

  // K_ss^-1 times right sides.
  [[nodiscard]] Dense solve(const Dense& right) const {
    Dense x = scale_.asDiagonal() * right;
    if (x.size() > 0) factors_.solve(x);
    return scale_.asDiagonal() * x;
  }

 private:
  static constexpr double smallest_eigenvalue = 1e-13;  // of the scaled matrix, whose largest is of the order of 1

  [[nodiscard]] std::string name(Index i) const {
    return parts_.names[static_cast<std::size_t>(parts_.of_others.innerIndexPtr()[i])];
  }

  void refuse_loose(Index i, const Check& check) const {
    check.that(false, name(i) + ", has no stiffness: a pinned end at both members, or a missing restraint.");
  }

  // An inverse iteration estimates the smallest eigenvalue, and finds the motion that nothing holds.
  double weakest(const Factorisation& factors) {
    Dense x(scale_.size(), 1);
    for (Index i = 0; i < x.size(); ++i) x(i) = 1.0 + 0.5 * std::sin(1.0 + static_cast<double>(i));
    double growth = 0.0;
    for (int iteration = 0; iteration < 3; ++iteration) {
      x /= x.norm();
      factors.solve(x);
      growth = x.norm();
      if (!std::isfinite(growth)) return 0.0;
    }
    x.col(0).cwiseAbs().maxCoeff(&loosest_);
    return 1.0 / growth;
  }

  const Constraints& parts_;
  Factorisation factors_;
  Vector scale_;
  Index loosest_ = 0;
};

Dense symmetric(const Dense& matrix) { return 0.5 * (matrix + matrix.transpose()); }

// Masses of levels, and their centres, to which `parts` move. Returns the mass matrix of the levels.
Dense mass_of_levels(const FiniteElements& model, const SparseMatrix& mass, Constraints& parts, const Check& check) {
  SparseMatrix shift(parts.of_levels.cols(), parts.of_levels.cols());
  shift.setIdentity();
  const Dense own{SparseMatrix{parts.of_levels.transpose() * mass * parts.of_levels}};
  Dense given = Dense::Zero(own.rows(), own.cols());
  for (std::size_t i = 0; i < parts.levels.size(); ++i) {
    const FrameLevel& input = model.diaphragms[i];
    Level& level = parts.levels[i];
    check.not_negative(level.name + " mass", input.mass);
    check.not_negative(level.name + " rotary_inertia", input.rotary_inertia);
    const Index first = parts.per_level * static_cast<Index>(i);
    if (parts.per_level == 1) {
      given(first, first) = input.mass.si();
      level.mass = own(first, first) + input.mass.si();
      continue;
    }
    const PlanVector place = input.centre_of_mass ? input.centre_of_mass->si() : level.centre_of_mass;
    const PlanVector arm = place - level.centre_of_mass;
    Eigen::Matrix3d about_mean;
    about_mean << 1.0, 0.0, -arm.y, 0.0, 1.0, arm.x, -arm.y, arm.x, dot(arm, arm);
    about_mean *= input.mass.si();
    about_mean(2, 2) += input.rotary_inertia.si();
    given.block<3, 3>(first, first) = about_mean;
    about_mean += own.block<3, 3>(first, first);
    const double m = about_mean(0, 0), m_y = about_mean(1, 1);
    check.that(
        std::abs(m - m_y) <= 1e-6 * std::max(m, m_y),
        level.name + " has a mass of " + to_text(m / 1e3) + " t along x, and of " + to_text(m_y / 1e3) + " t along y.",
        "A floor has one mass.");
    const PlanVector to_centre = m > 0.0 ? PlanVector{about_mean(1, 2) / m, -about_mean(0, 2) / m} : arm;
    level.mass = m;
    level.rotary_inertia = about_mean(2, 2) - m * dot(to_centre, to_centre);
    level.centre_of_mass += to_centre;
    shift.coeffRef(first, first + 2) = to_centre.y;
    shift.coeffRef(first + 1, first + 2) = -to_centre.x;
  }
  parts.of_levels = parts.of_levels * shift;
  return symmetric(shift.transpose() * (own + given) * shift);
}

// "12 t along x, 30 t along z" of the given unknowns.
std::string masses_text(const Vector& diagonal, const std::vector<Index>& unknowns, const Constraints& parts) {
  const std::array<std::string, 4> kinds{"x", "y", "z", ""};
  std::array<double, 4> sums{};
  for (const Index unknown : unknowns) {
    const std::string& name = parts.names[static_cast<std::size_t>(unknown)];
    const auto kind = std::ranges::find_if(kinds, [&](const std::string& each) { return name.ends_with(", " + each); });
    sums[kind == kinds.end() ? 3 : static_cast<std::size_t>(kind - kinds.begin())] += diagonal[unknown] / 1e3;
  }
  std::string text;
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (sums[i] != 0.0)
      text += (text.empty() ? "" : ", ") + to_text(sums[i]) + (i < 3 ? " t along " + kinds[i] : " t m2 on rotations");
  return text;
}

// The first-order errors of the squared frequencies, and notes.
void estimate_errors(CondensedStructure& result, const SparseMatrix& k_ss, const SparseMatrix& m_ss,
                     const SparseMatrix& m_sm, const Dense& deflection) {
  constexpr Index most = 12;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Dense> modes{result.stiffness, result.mass};
  Factorisation factors;
  for (Index mode = 0; mode < std::min(most, result.stiffness.rows()); ++mode) {
    // Eigen scales the shapes so that their modal masses are 1.
    const Vector shape = modes.eigenvectors().col(mode);
    const double squared = modes.eigenvalues()[mode];
    const Vector residual = -squared * (m_sm * shape + m_ss * (deflection * shape));
    Vector correction = residual;
    const double period = 2.0 * std::numbers::pi / std::sqrt(squared);
    const std::string number = "Guyan: mode " + std::to_string(mode + 1) + " has " + to_text(period) + " s";
    if (!factors.factorise(k_ss - squared * m_ss)) {
      result.notes.push_back(number + "; its error is unknown, because condensed motions have this period too.");
      continue;
    }
    factors.solve(correction);
    result.eigenvalue_errors.push_back(-residual.dot(correction) / squared);
    result.notes.push_back(number + ", which is about " + to_significant(-50.0 * result.eigenvalue_errors.back(), 3) +
                           " % too short.");
  }
}

}  // namespace

CondensedStructure condensed(const FiniteElements& model) {
  return condensed(model, Check{"FiniteElements", model.name});
}

CondensedStructure condensed(const FiniteElements& model, const Check& check) {
  Constraints parts = constraints_of(model, check);
  CondensedStructure result;
  result.in_plan = parts.per_level == 3;
  result.notes = parts.notes;
  const SparseMatrix all = symmetric_part(check, "stiffness", model.stiffness, parts, result.notes);
  SparseMatrix mass(all.rows(), all.cols());
  if (model.mass.size() > 0) mass = symmetric_part(check, "mass", model.mass, parts, result.notes);
  result.mass = mass_of_levels(model, mass, parts, check);
  result.levels = parts.levels;

  const SparseMatrix &t_m = parts.of_levels, &t_s = parts.of_others;
  const SparseMatrix k_mm = t_m.transpose() * all * t_m, k_ms = t_m.transpose() * all * t_s,
                     k_ss = t_s.transpose() * all * t_s, k_sm = k_ms.transpose();
  const SparseMatrix m_ms = t_m.transpose() * mass * t_s, m_ss = t_s.transpose() * mass * t_s, m_sm = m_ms.transpose();
  const Vector masses = mass.diagonal();
  if (const std::string text = masses_text(masses, parts.held, parts); !text.empty())
    result.notes.push_back("Masses on motions that are held belong to the base or to the ground: " + text + ".");
  std::vector<Index> vanishing;
  for (Index i = 0; i < t_s.cols(); ++i)
    if (m_ss.col(i).norm() > 0.0 || m_ms.col(i).norm() > 0.0) vanishing.push_back(t_s.innerIndexPtr()[i]);
  const bool guyan = model.masses == Vanishing::guyan && !vanishing.empty();
  if (!vanishing.empty()) {
    const std::string text = std::to_string(vanishing.size()) + " motions that are condensed have mass (" +
                             masses_text(masses, vanishing, parts) + "), the first is " +
                             parts.names[static_cast<std::size_t>(vanishing[0])];
    check.that(model.masses != Vanishing::refuse, text + ".",
               "Take .masses = Vanishing::drop to leave them out, or Vanishing::guyan to move them to the floors.");
    result.notes.push_back(text + (guyan ? "; they are moved to the floors by Guyan." : "; they are left out."));
  }

  const Condenser condenser{k_ss, parts, check};
  constexpr Index chunk = 64;
  Dense stiffness{k_mm};
  Dense deflection(guyan ? k_sm.rows() : 0, k_sm.cols());
  for (Index first = 0; first < k_sm.cols(); first += chunk) {
    const Index count = std::min(chunk, k_sm.cols() - first);
    const Dense solution = condenser.solve(Dense{k_sm.middleCols(first, count)});
    stiffness.middleCols(first, count) -= k_ms * solution;
    if (guyan) deflection.middleCols(first, count) = -solution;
  }
  result.stiffness = symmetric(stiffness);
  const Vector diagonal = result.stiffness.diagonal().cwiseAbs().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  const double asymmetry =
      (diagonal.asDiagonal() * (stiffness - result.stiffness) * diagonal.asDiagonal()).cwiseAbs().maxCoeff() * 2.0;
  check.that(
      asymmetry <= 1e-9,
      "ill-conditioned: the condensed stiffness is not symmetric by " + to_text(asymmetry) + " of its diagonals.",
      "Look for members that are far stiffer than all others.");
  if (guyan) {
    const Dense coupled = m_ms * deflection;
    result.mass = symmetric(result.mass + coupled + coupled.transpose() + deflection.transpose() * (m_ss * deflection));
    estimate_errors(result, k_ss, m_ss, m_sm, deflection);
    const Index per_level = result.in_plan ? 3 : 1;
    for (std::size_t i = 0; i < result.levels.size(); ++i) {
      const Index row = static_cast<Index>(i) * per_level;
      result.levels[i].mass = result.mass(row, row);
      if (result.in_plan) result.levels[i].rotary_inertia = result.mass(row + 2, row + 2);
    }
  }
  return result;
}

}  // namespace moat
