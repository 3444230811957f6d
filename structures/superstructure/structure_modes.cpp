#include "structures/superstructure/structure_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solvers/dense.hpp"

namespace moat {
namespace {

// w^2, 1/s^2, as given or from the periods.
Eigen::VectorXd squared_frequencies(const Check& check, const StructureModes& modes) {
  check.that(modes.periods.empty() != modes.eigenvalues.empty(), "periods and eigenvalues: one of them is needed.",
             "Give the periods, or the squared angular frequencies.");
  std::vector<double> values = modes.eigenvalues;
  for (const Time period : modes.periods) values.push_back(std::pow(2.0 * std::numbers::pi / period.si(), 2));
  check.that(static_cast<Eigen::Index>(values.size()) == modes.shapes.cols(),
             "shapes has " + std::to_string(modes.shapes.rows()) + " rows and " + std::to_string(modes.shapes.cols()) +
                 " columns, " + (modes.periods.empty() ? "eigenvalues " : "periods ") + std::to_string(values.size()) +
                 ".",
             "Give a column of the shapes for each mode.");
  for (std::size_t i = 0; i < values.size(); ++i)
    check.positive("squared frequency of mode " + std::to_string(i + 1), values[i], "1/s^2");
  return Eigen::Map<const Eigen::VectorXd>{values.data(), static_cast<Eigen::Index>(values.size())};
}

std::string percent(double share) { return to_text(100.0 * share) + " %"; }

// The `masses` are Phi' M Phi, in the unit in which those of modes should be 1.
void check_shapes(const Check& check, const Eigen::MatrixXd& masses, ShapeNorm norm, std::vector<std::string>& notes) {
  constexpr double round_off = 1e-6, tolerated = 0.02;
  double worst = 0.0, off_norm = 0.0;
  Eigen::Index a = 0, b = 0;
  for (Eigen::Index i = 0; i < masses.rows(); ++i) {
    check.that(masses(i, i) > 0.0, "shape " + std::to_string(i + 1) + " is zero.", "Give its column.");
    off_norm = std::max(off_norm, std::abs(masses(i, i) - 1.0));
    for (Eigen::Index j = 0; j < i; ++j) {
      const double coupled = std::abs(masses(i, j)) / std::sqrt(masses(i, i) * masses(j, j));
      if (coupled <= worst) continue;
      worst = coupled;
      a = j;
      b = i;
    }
  }
  const std::string text = "shapes " + std::to_string(a + 1) + " and " + std::to_string(b + 1) +
                           " are not orthogonal with these masses: " + percent(worst);
  check.that(worst <= tolerated, text + ".",
             "Masses and shapes may belong to different models, or their order differs.");
  if (worst > round_off) notes.push_back(text + ". The masses count in full.");
  if (norm == ShapeNorm::any) return;
  const std::string norm_text = "masses of modes differ from 1 by up to " + percent(off_norm);
  check.that(off_norm <= tolerated, norm_text + ".",
             "Give .norm = ShapeNorm::any for shapes that are not normalised by the mass, or their unit .mass.");
  if (off_norm > round_off) notes.push_back(norm_text + ": periods differ from the given ones.");
}

// A list for all modes of a file holds for those that are kept.
ModalDamping of_kept(const ModalDamping& damping, Eigen::Index given, Eigen::Index kept) {
  if (static_cast<Eigen::Index>(damping.ratios.size()) != given) return damping;
  return {std::vector<double>{damping.ratios.begin(), damping.ratios.begin() + kept}};
}

// The mass of the modes that are left out rides on the base.
void note_residual_mass(const StructureSystem& system, const Eigen::MatrixXd& modal_mass, const Eigen::MatrixXd& load,
                        std::vector<std::string>& notes) {
  const Eigen::MatrixXd whole = projected(system.rigid, system.mass, system.rigid),
                        left = whole - product(load.transpose(), solve_definite(modal_mass, load));
  std::string text = "The modes leave out";
  const char* const names[] = {"x", "y", "rotation"};
  double largest = 0.0;
  for (Eigen::Index d = 0; d < whole.cols(); ++d) {
    const double share = std::max(left(d, d) / whole(d, d), 0.0);
    largest = std::max(largest, share);
    text += (d == 0 ? " " : ", ") + percent(share) + (d < 2 ? " (" + to_text(left(d, d) / 1000.0) + " t)" : "") +
            " of the mass in " + names[d];
  }
  constexpr double round_off = 1e-9, noticeable = 0.1;
  if (largest < round_off) return;
  notes.push_back(text + (system.is_isolated() ? "; it rides on the base." : "; it rides on the ground.") +
                  (largest > noticeable ? " Keep more modes." : ""));
}

}  // namespace

void add_modes(const StructureModes& modes, decltype(Superstructure::damping) damping, const Check& check,
               const Eigen::VectorXd& into_metres, const std::vector<int>& positions, StructureSystem& system) {
  if (std::holds_alternative<std::monostate>(damping) && !modes.ratios.empty()) damping = ModalDamping{modes.ratios};
  const Eigen::VectorXd all_frequencies = squared_frequencies(check, modes);
  system.notes.insert(system.notes.end(), modes.notes.begin(), modes.notes.end());
  check.that(modes.shapes.allFinite(), "shapes has an entry that is infinite or no number.");
  check.positive("length of modes", modes.length);
  check.positive("mass of modes", modes.mass);
  const Eigen::Index given = modes.shapes.cols(), kept = modes.keep == 0 ? given : modes.keep;
  check.between("keep", static_cast<double>(kept), 1.0, static_cast<double>(given), "1", "0 keeps all modes.");
  const auto size = static_cast<Eigen::Index>(positions.size());
  Eigen::MatrixXd shapes{size, kept};
  for (Eigen::Index i = 0; i < size; ++i)
    shapes.row(i) = into_metres[i] * modes.shapes.row(positions[static_cast<std::size_t>(i)]).head(kept) /
                    (system.in_plan && i % 3 == 2 ? modes.length.si() : 1.0);
  Eigen::MatrixXd masses = projected(shapes, system.mass, shapes) / modes.mass.si();
  check_shapes(check, masses, modes.norm, system.notes);
  Eigen::VectorXd squared = all_frequencies.head(kept);
  for (Eigen::Index i = 1; i < kept; ++i)
    if (squared[i] < squared[i - 1])
      system.notes.push_back("The period of mode " + std::to_string(i + 1) + " is longer than that of mode " +
                             std::to_string(i) + ".");
  if (modes.orthonormalise) {
    if (modes.norm == ShapeNorm::any) {
      const Eigen::VectorXd norm = masses.diagonal().cwiseSqrt().cwiseInverse();
      shapes = (shapes * norm.asDiagonal()).eval();
      masses = (norm.asDiagonal() * masses * norm.asDiagonal()).eval();
    }
    const EigenPairs uncoupled = eigen_pairs(squared.asDiagonal(), masses);
    system.notes.push_back("Shapes are orthonormalised: the first period is " +
                           to_text(2.0 * std::numbers::pi / std::sqrt(squared.minCoeff())) + " s, and " +
                           to_text(2.0 * std::numbers::pi / std::sqrt(uncoupled.values[0])) +
                           " s with the masses as they are.");
    shapes = product(shapes, inverse_root(masses));
    masses.setIdentity();
  }
  const Eigen::VectorXd own =
      modes.norm == ShapeNorm::any ? Eigen::VectorXd{masses.diagonal()} : Eigen::VectorXd{Eigen::VectorXd::Ones(kept)};
  // A largest entry of 1 makes coordinates of m.
  const Eigen::VectorXd scale = shapes.cwiseAbs().colwise().maxCoeff().cwiseInverse().transpose();
  const Eigen::VectorXd mass_of_mode = modes.mass.si() * own.cwiseProduct(scale.cwiseAbs2());
  system.shapes = shapes * scale.asDiagonal();
  system.modal_stiffness = squared.cwiseProduct(mass_of_mode);
  system.damping = Eigen::MatrixXd::Zero(kept, kept);
  const Eigen::MatrixXd modal_mass = projected(system.shapes, system.mass, system.shapes),
                        load = projected(system.shapes, system.mass, system.rigid);
  note_residual_mass(system, modal_mass, load, system.notes);
  const EigenPairs pairs = eigen_pairs(system.modal_stiffness.asDiagonal(), modal_mass);
  system.modes = participating_masses(pairs.values, product(pairs.vectors.transpose(), load),
                                      projected(system.rigid, system.mass, system.rigid));
  if (const auto* ratios = std::get_if<ModalDamping>(&damping)) {
    system.damping.diagonal() = 2.0 * ratios_of(check, of_kept(*ratios, given, kept), kept, system.notes)
                                          .cwiseProduct(squared.cwiseSqrt())
                                          .cwiseProduct(mass_of_mode);
  } else if (const auto* rayleigh = std::get_if<RayleighDamping>(&damping)) {
    const RayleighFactors factors = rayleigh_factors_of(*rayleigh, system.modes);
    system.damping = factors.mass_factor * modal_mass;
    system.damping.diagonal() += factors.stiffness_factor * system.modal_stiffness;
    system.damping = 0.5 * (system.damping + system.damping.transpose()).eval();
  } else {
    check.that(std::holds_alternative<std::monostate>(damping), "damping is a matrix, but modes are given.",
               "Give ModalDamping or RayleighDamping.");
  }
}

Eigen::VectorXd ratios_of(const Check& check, const ModalDamping& damping, Eigen::Index count,
                          std::vector<std::string>& notes) {
  const auto given = static_cast<Eigen::Index>(damping.ratios.size());
  check.that(given >= 1 && given <= count,
             "damping has " + std::to_string(given) + " ratios for " + std::to_string(count) + " modes.",
             "Give one for all modes, or one for each.");
  Eigen::VectorXd ratios{count};
  for (Eigen::Index i = 0; i < count; ++i) {
    const double ratio = damping.ratios[static_cast<std::size_t>(std::min(i, given - 1))];
    check.that(ratio >= 0.0 && ratio < 1.0, "ratio of mode " + std::to_string(i + 1), ratio, "1", ">= 0 and < 1",
               "5 % is 0.05.");
    ratios[i] = ratio;
  }
  if (given > 1 && given < count)
    notes.push_back((given + 1 == count
                         ? "Mode " + std::to_string(count) + " has"
                         : "Modes " + std::to_string(given + 1) + " to " + std::to_string(count) + " have") +
                    " the damping ratio of mode " + std::to_string(given) + ".");
  return ratios;
}

RayleighFactors rayleigh_factors_of(const RayleighDamping& damping, const std::vector<ParticipatingMass>& modes) {
  if (const auto given = given_factors(damping)) return *given;
  const auto frequency = [&](std::size_t mode) { return 2.0 * std::numbers::pi / modes[mode].period; };
  const auto direction = [&](const ParticipatingMass& mode) {
    return mode.rotation > std::max(mode.x, mode.y) ? 2 : mode.y > mode.x ? 1 : 0;
  };
  std::size_t first = 0;
  while (first + 1 < modes.size() && direction(modes[first]) == 2) ++first;
  std::size_t second = first + 1;
  while (second < modes.size() && direction(modes[second]) != direction(modes[first])) ++second;
  if (second >= modes.size()) return {.mass_factor = 0.0, .stiffness_factor = 2.0 * damping.ratio / frequency(first)};
  return rayleigh_factors(damping.ratio, frequency(first), frequency(second));
}

std::vector<ParticipatingMass> participating_masses(const Eigen::VectorXd& squared_frequencies,
                                                    const Eigen::MatrixXd& loads, const Eigen::MatrixXd& mass) {
  std::vector<ParticipatingMass> modes;
  for (Eigen::Index i = 0; i < squared_frequencies.size(); ++i) {
    ParticipatingMass mode{.period = 2.0 * std::numbers::pi / std::sqrt(squared_frequencies[i])};
    const auto share = [&](Eigen::Index d) { return d < mass.cols() ? loads(i, d) * loads(i, d) / mass(d, d) : 0.0; };
    mode.x = share(0);
    mode.y = share(1);
    mode.rotation = share(2);
    modes.push_back(mode);
  }
  return modes;
}

}  // namespace moat
