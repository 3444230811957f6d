#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/text/number_format.hpp"
#include "base/vector.hpp"
#include "solvers/dense.hpp"
#include "solvers/factorisation.hpp"
#include "structures/frame/constraints.hpp"
#include "structures/frame/finite_elements.hpp"

namespace moat {
namespace {

using Index = Eigen::Index;
using Dense = Eigen::MatrixXd;

Dense symmetric(const Dense& matrix) { return 0.5 * (matrix + matrix.transpose()); }

// Condenses one model.
class Condenser {
 public:
  Condenser(const FiniteElements& model, const Check& check)
      : model_{model}, check_{check}, nodes_{model.nodes, check}, parts_{constraints_of(model, nodes_, check)} {}

  CondensedStructure condense() {
    result_.in_plan = parts_.per_level == 3;
    result_.notes = parts_.notes;
    const SparseMatrix all = symmetric_part("stiffness", model_.stiffness);
    SparseMatrix mass(all.rows(), all.cols());
    if (model_.mass.size() > 0) mass = symmetric_part("mass", model_.mass);
    const Dense given = masses_of_levels(mass);
    result_.levels = parts_.levels;
    sort_masses(mass);

    const Index of_levels = parts_.of_levels.cols();
    SparseMatrix t_m = parts_.of_levels, t_s(all.rows(), std::ssize(parts_.others));
    t_m.conservativeResize(all.rows(), of_levels + std::ssize(kept_));
    for (Index column = of_levels; const Index unknown : kept_) t_m.insert(unknown, column++) = 1.0;
    for (Index column = 0; const Index unknown : parts_.others) t_s.insert(unknown, column++) = 1.0;
    const SparseMatrix k_ms = t_m.transpose() * all * t_s, k_ss = t_s.transpose() * all * t_s;
    result_.mass = symmetric(SparseMatrix{t_m.transpose() * mass * t_m});
    result_.mass.topLeftCorner(of_levels, of_levels) += given;
    const Dense deflection = deflections(k_ss, SparseMatrix{k_ms.transpose()}),
                stiffness = Dense{SparseMatrix{t_m.transpose() * all * t_m}} + k_ms * deflection;
    result_.stiffness = symmetric(stiffness);
    const Vector diagonal = result_.stiffness.diagonal().cwiseAbs().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
    const Dense difference = diagonal.asDiagonal() * (stiffness - stiffness.transpose()) * diagonal.asDiagonal();
    const double asymmetry = difference.cwiseAbs().maxCoeff();
    check_.that(asymmetry <= 1e-9,
                "ill-conditioned: the condensed stiffness differs from its transpose by " + to_text(asymmetry) + ".",
                "Look for members that are far stiffer than all others.");
    if (guyan_) move_masses(k_ss, t_s.transpose() * mass * t_s, t_s.transpose() * mass * t_m, deflection);
    for (Index row = 0; Level & level : result_.levels) {
      level.mass = result_.mass(row, row);
      if (result_.in_plan) level.rotary_inertia = result_.mass(row + 2, row + 2);
      row += parts_.per_level;
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::string name(Index unknown) const {
    return nodes_.motion_name(parts_.motions[static_cast<std::size_t>(unknown)]);
  }

  // The symmetric part of a matrix, after a check.
  SparseMatrix symmetric_part(const std::string& field, const SparseMatrix& matrix) {
    const Index unknowns = parts_.of_levels.rows();
    check_.that(matrix.rows() == unknowns && matrix.cols() == unknowns,
                field + " has " + std::to_string(matrix.rows()) + " rows and " + std::to_string(matrix.cols()) +
                    " columns, the model has " + std::to_string(unknowns) + " unknowns.");
    const Vector diagonal = matrix.diagonal().cwiseAbs();
    const SparseMatrix transposed = matrix.transpose();
    double worst = 0.0;
    std::string text;
    for (Index column = 0; column < unknowns; ++column)
      for (SparseMatrix::InnerIterator entry{matrix, column}; entry; ++entry) {
        if (!std::isfinite(entry.value()))
          check_.that(false, field + " has an entry that is not finite, at " + name(column) + ".");
        const double other = transposed.coeff(entry.row(), column);
        const double share = std::abs(entry.value() - other) / std::sqrt(diagonal[entry.row()] * diagonal[column]);
        if (entry.value() == other || share <= worst) continue;
        worst = share;
        text = field + " is not symmetric: entry (" + name(entry.row()) + "; " + name(column) +
               ") = " + to_text(entry.value()) + ", transposed " + to_text(other) + ", " +
               to_significant(100.0 * worst, 3) + " % of the diagonals.";
      }
    check_.that(worst <= 1e-6, text);
    if (worst > 1e-12) result_.notes.push_back(text + " The mean is taken.");
    return 0.5 * (matrix + transposed);
  }

  // Returns the masses that levels are given, and moves the levels to their centres of mass.
  Dense masses_of_levels(const SparseMatrix& mass) {
    SparseMatrix shift(parts_.of_levels.cols(), parts_.of_levels.cols());
    shift.setIdentity();
    const Dense own{SparseMatrix{parts_.of_levels.transpose() * mass * parts_.of_levels}};
    Dense given = Dense::Zero(shift.rows(), shift.cols());
    for (std::size_t i = 0; i < parts_.levels.size(); ++i) {
      const FrameLevel& input = model_.diaphragms[i];
      Level& level = parts_.levels[i];
      check_.not_negative(level.name + " mass", input.mass);
      check_.not_negative(level.name + " rotary_inertia", input.rotary_inertia);
      const Index first = parts_.per_level * static_cast<Index>(i);
      if (parts_.per_level == 1) {
        given(first, first) = input.mass.si();
        continue;
      }
      const PlanVector arm = input.centre_of_mass ? input.centre_of_mass->si() - level.centre_of_mass : PlanVector{};
      Eigen::Matrix3d about_mean;
      about_mean << 1.0, 0.0, -arm.y, 0.0, 1.0, arm.x, -arm.y, arm.x, dot(arm, arm);
      about_mean *= input.mass.si();
      about_mean(2, 2) += input.rotary_inertia.si();
      given.block<3, 3>(first, first) = about_mean;
      about_mean += own.block<3, 3>(first, first);
      const double m = about_mean(0, 0), m_y = about_mean(1, 1);
      check_.that(std::abs(m - m_y) <= 1e-6 * std::max(m, m_y),
                  level.name + " has a mass of " + to_text(m / 1e3) + " t along x, and of " + to_text(m_y / 1e3) +
                      " t along y.",
                  "A floor has one mass.");
      const PlanVector to_centre = m > 0.0 ? PlanVector{about_mean(1, 2) / m, -about_mean(0, 2) / m} : arm;
      level.centre_of_mass += to_centre;
      shift.coeffRef(first, first + 2) = to_centre.y;
      shift.coeffRef(first + 1, first + 2) = -to_centre.x;
    }
    parts_.of_levels = parts_.of_levels * shift;
    return symmetric(shift.transpose() * given * shift);
  }

  // "12 t along x, 30 t along z" of these unknowns.
  [[nodiscard]] std::string masses_text(const SparseMatrix& mass, const std::vector<Index>& unknowns) const {
    const std::array<std::string, 4> kinds{" t along x", " t along y", " t along z", " t m2 on rotations"};
    std::array<double, 4> sums{};
    for (const Index unknown : unknowns)
      sums[static_cast<std::size_t>(std::min<Index>(parts_.motions[static_cast<std::size_t>(unknown)] % 6, 3))] +=
          mass.coeff(unknown, unknown) / 1e3;
    std::string text;
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (sums[i] != 0.0) text += (text.empty() ? "" : ", ") + to_text(sums[i]) + kinds[i];
    return text;
  }

  // Masses on motions that no level has: of those that are held, and of `others`.
  void sort_masses(const SparseMatrix& mass) {
    if (const std::string text = masses_text(mass, parts_.held); !text.empty())
      result_.notes.push_back("Masses on motions that are held belong to the base or to the ground: " + text + ".");
    const auto has_mass = [&](Index unknown) { return mass.col(unknown).squaredNorm() > 0.0; };
    std::ranges::copy_if(parts_.others, std::back_inserter(kept_), has_mass);
    if (kept_.empty()) return;
    const std::string text = std::to_string(kept_.size()) + " motions of no level have mass (" +
                             masses_text(mass, kept_) + "), the first is " + name(kept_[0]);
    check_.that(model_.masses != Vanishing::refuse, text + ".",
                "Take .masses = Vanishing::drop to leave them out, Vanishing::guyan to move them to the floors, or "
                "Vanishing::keep to keep these motions.");
    guyan_ = model_.masses == Vanishing::guyan;
    const bool keep = model_.masses == Vanishing::keep;
    result_.notes.push_back(text + (keep     ? "; they are kept."
                                    : guyan_ ? "; they are moved to the floors by Guyan."
                                             : "; they are left out."));
    if (!keep) return kept_.clear();
    std::erase_if(parts_.others, has_mass);
    describe_kept();
  }

  // Rigid motions of the nodes give those of the unknowns, by the least squares of their equations.
  void describe_kept() {
    const PlanVector centre = result_.in_plan ? PlanVector{} : result_.levels[0].centre_of_mass;
    Dense of_nodes = Dense::Zero(parts_.equations.rows(), 6);
    for (std::size_t node = 0; node < model_.nodes.size(); ++node) {
      const double x = model_.nodes[node].x.si() - centre.x, y = model_.nodes[node].y.si() - centre.y,
                   z = model_.nodes[node].z.si() - parts_.lowest;
      auto motions = of_nodes.middleRows<6>(6 * static_cast<Index>(node));
      motions.setIdentity();
      motions.topRightCorner<3, 3>() << 0.0, z, -y, -z, 0.0, x, y, -x, 0.0;
    }
    const SparseMatrix transposed = parts_.equations.transpose();
    Factorisation squares;
    Dense rigid = transposed * of_nodes;
    check_.that(squares.factorise(transposed * parts_.equations), "its equations of constraints are not independent.");
    squares.solve(rigid);
    for (const Index unknown : kept_) {
      const auto node = static_cast<std::size_t>(parts_.motions[static_cast<std::size_t>(unknown)] / 6);
      auto level = static_cast<std::size_t>(parts_.level_of_node[node]);
      if (parts_.level_of_node[node] < 0)
        for (level = 0; level + 1 < result_.levels.size() &&
                        result_.levels[level].height + parts_.lowest < model_.nodes[node].z.si();)
          ++level;
      check_.that(parts_.level_of_node[node] >= 0 || result_.levels[level].tower.empty(),
                  name(unknown) + ", has mass, and its node belongs to no level of a tower.",
                  "Make a level of its node, or take Vanishing::drop or Vanishing::guyan.");
      result_.kept.push_back({name(unknown), level, rigid.row(unknown).transpose()});
      auto& r = result_.kept.back().rigid;
      if (model_.motion == LevelMotion::along_y) r = decltype(KeptMotion::rigid){r[1], -r[0], r[2], r[4], -r[3], r[5]};
    }
  }

  // Returns -K_ss^-1 K_sm. K_ss is scaled to ones on its diagonal.
  [[nodiscard]] Dense deflections(const SparseMatrix& stiffness, const Dense& right) const {
    const Vector diagonal = stiffness.diagonal();
    const auto name_of = [&](Index i) { return name(parts_.others[static_cast<std::size_t>(i)]); };
    const auto refuse_loose = [&](Index i) {
      check_.that(false, name_of(i) + ", has no stiffness: a pinned end at both members, or a missing restraint.");
    };
    for (Index i = 0; i < diagonal.size(); ++i) {
      if (diagonal[i] == 0.0) refuse_loose(i);
      if (!(diagonal[i] > 0.0))
        check_.that(false, "stiffness of " + name_of(i) + " is " + to_text(diagonal[i]) + ".",
                    "The order or the unit of the matrix may be another.");
    }
    if (diagonal.size() == 0) return right;
    const Vector scale = diagonal.cwiseSqrt().cwiseInverse();
    const SparseMatrix scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
    Factorisation factors;
    const bool regular = factors.factorise(scaled);
    // Inverse iteration finds the motion that strains least. A shift leaves it where it is.
    Vector loose = Vector::LinSpaced(diagonal.size(), 1.0, 2.0);
    double strain = 0.0;
    const auto find_loose = [&](const Factorisation& of) {
      constexpr int iterations = 4;
      for (int i = 0; i < iterations; ++i) {
        of.solve(loose);
        strain = 1.0 / loose.norm();
        loose *= strain;
      }
    };
    SparseMatrix unit = scaled;
    unit.setIdentity();
    if (Factorisation shifted; regular)
      find_loose(factors);
    else if (shifted.factorise(scaled + 1e-10 * unit))
      find_loose(shifted);
    constexpr double round_off = 1e-12;
    if (!regular || !(strain > round_off)) {
      Index weakest = 0;
      scale.cwiseProduct(loose).cwiseAbs().maxCoeff(&weakest);
      refuse_loose(weakest);
    }
    Dense solution = scale.asDiagonal() * right;
    factors.solve(solution);
    return -(scale.asDiagonal() * solution);
  }

  // Guyan: M_c = G' M G, with the first-order errors of the squared frequencies.
  void move_masses(const SparseMatrix& k_ss, const SparseMatrix& m_ss, const SparseMatrix& m_sm,
                   const Dense& deflection) {
    const Dense coupled = m_sm.transpose() * deflection;
    result_.mass += symmetric(coupled + coupled.transpose() + deflection.transpose() * (m_ss * deflection));
    const EigenPairs modes = eigen_pairs(result_.stiffness, result_.mass);
    Factorisation factors;
    for (Index mode = 0; mode < std::min<Index>(12, result_.stiffness.rows()); ++mode) {
      const Vector shape = modes.vectors.col(mode);
      const double squared = modes.values[mode];
      const Vector residual = -squared * (m_sm * shape + m_ss * (deflection * shape));
      const std::string number = "Guyan: mode " + std::to_string(mode + 1) + " has " +
                                 to_text(2.0 * std::numbers::pi / std::sqrt(squared)) + " s";
      if (!factors.factorise(k_ss - squared * m_ss)) {
        result_.notes.push_back(number + "; its error is unknown, because condensed motions have this period too.");
        continue;
      }
      Vector correction = residual;
      factors.solve(correction);
      result_.eigenvalue_errors.push_back(-residual.dot(correction) / squared);
      result_.notes.push_back(number + ", which is about " +
                              to_significant(-50.0 * result_.eigenvalue_errors.back(), 3) + " % too short.");
    }
  }

  const FiniteElements& model_;
  const Check& check_;
  const NodeNumbers nodes_;
  Constraints parts_;
  std::vector<Index> kept_;  // unknowns
  bool guyan_ = false;
  CondensedStructure result_;
};

}  // namespace

CondensedStructure condensed(const FiniteElements& model, std::string_view kind) {
  const Check check{kind, model.name};
  return Condenser{model, check}.condense();
}

}  // namespace moat
