#include "elements/matrix/linear_structure_states.hpp"

#include "base/hermite.hpp"
#include "elements/block/link_energies.hpp"

namespace moat {

LinearStructureStates::LinearStructureStates(const LinearStructureBlock& block, const SparseMatrix& matrix)
    : zeros_(block.size(), 0.0) {
  for (const StructureMatrices& each : block.matrices()) {
    Structure structure{.matrices = &each};
    for (const int column : each.all)
      for (const int row : each.all) structure.slots.push_back(entry_position(matrix, row, column));
    const auto size = static_cast<Eigen::Index>(each.nodes.size());
    for (Instant* instant : {&structure.start, &structure.now})
      for (Vector* values : {&instant->deformation, &instant->rate, &instant->second_rate, &instant->force})
        values->setZero(size);
    structures_.push_back(std::move(structure));
  }
}

// u - R b: the difference comes first, so that pairs that move alike keep their digits.
void LinearStructureStates::Structure::relative(const double* values, Vector& result) const {
  for (std::size_t i = 0; i < matrices->nodes.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    result[row] = values[matrices->nodes[i]];
    for (std::size_t j = 0; j < matrices->base.size(); ++j)
      result[row] -= matrices->carried(row, static_cast<Eigen::Index>(j)) * values[matrices->base[j]];
  }
}

void LinearStructureStates::Structure::add_force(const Vector& own, double* force) {
  for (std::size_t i = 0; i < matrices->nodes.size(); ++i)
    force[matrices->nodes[i]] += own[static_cast<Eigen::Index>(i)];
  of_base.noalias() = matrices->carried.transpose() * own;
  for (std::size_t j = 0; j < matrices->base.size(); ++j)
    force[matrices->base[j]] -= of_base[static_cast<Eigen::Index>(j)];
}

double LinearStructureStates::Structure::power(const Vector& rate) const {
  return rate.dot(matrices->damping.selfadjointView<Eigen::Lower>() * rate);
}

double LinearStructureStates::Structure::stored() const {
  return 0.5 * now.deformation.dot(matrices->stiffness.selfadjointView<Eigen::Lower>() * now.deformation);
}

bool LinearStructureStates::evaluate(double, const double* displacement, const double* velocity, double* force) {
  for (Structure& each : structures_) {
    each.relative(displacement, each.now.deformation);
    each.relative(velocity, each.now.rate);
    each.now.force.noalias() = each.matrices->stiffness * each.now.deformation;
    each.now.force.noalias() += each.matrices->damping * each.now.rate;
    if (force != nullptr) each.add_force(each.now.force, force);
  }
  return false;
}

void LinearStructureStates::evaluate_rates(const double* acceleration, double* force_rate) {
  for (Structure& each : structures_) {
    each.relative(acceleration, each.now.second_rate);
    each.force_rate.noalias() = each.matrices->stiffness * each.now.rate;
    each.force_rate.noalias() += each.matrices->damping * each.now.second_rate;
    if (force_rate != nullptr) each.add_force(each.force_rate, force_rate);
  }
}

void LinearStructureStates::add_tangent(double displacement_weight, double velocity_weight,
                                        SparseMatrix& matrix) const {
  double* values = matrix.valuePtr();
  for (const Structure& each : structures_) {
    const double *stiffness = each.matrices->all_stiffness.data(), *damping = each.matrices->all_damping.data();
    for (std::size_t k = 0; k < each.slots.size(); ++k)
      values[each.slots[k]] += displacement_weight * stiffness[k] + velocity_weight * damping[k];
  }
}

// The rules are those of LinkEnergies.
void LinearStructureStates::Structure::add_energies(double h, WorkRule rule) {
  const Instant &a = start, &b = now;
  if (rule == WorkRule::mean_force) {
    Vector middle{b.rate.size()};
    for (Eigen::Index i = 0; i < middle.size(); ++i)
      middle[i] = HermiteCubic{a.deformation[i], a.rate[i], b.deformation[i], b.rate[i], h}.rate(0.5);
    work += 0.5 * (a.force + b.force).dot(b.deformation - a.deformation);
    dissipated += h / 6.0 * (power(a.rate) + 4.0 * power(middle) + power(b.rate));
    return;
  }
  Vector deformation{b.rate.size()}, rate{b.rate.size()};
  double its_work = a.force.dot(a.rate) + b.force.dot(b.rate), its_power = power(a.rate) + power(b.rate);
  for (const double place : lobatto_inside) {
    const HermiteQuinticsAt at{place, h};
    for (Eigen::Index i = 0; i < rate.size(); ++i) {
      deformation[i] =
          at.value(a.deformation[i], a.rate[i], a.second_rate[i], b.deformation[i], b.rate[i], b.second_rate[i]);
      rate[i] = at.rate(a.deformation[i], a.rate[i], a.second_rate[i], b.deformation[i], b.rate[i], b.second_rate[i]);
    }
    its_work += 5.0 * (rate.dot(matrices->stiffness * deformation) + power(rate));
    its_power += 5.0 * power(rate);
  }
  work += h / 12.0 * its_work;
  dissipated += h / 12.0 * its_power;
}

void LinearStructureStates::commit(double step, WorkRule rule) {
  if (!keeps_energies_) return;
  for (Structure& each : structures_) {
    if (step > 0.0) each.add_energies(step, rule);
    each.start = each.now;
  }
}

void LinearStructureStates::start_energy_accounts() {
  keeps_energies_ = true;
  for (Structure& each : structures_) {
    each.start = each.now;
    each.work = each.dissipated = 0.0;
    each.stored_at_start = each.stored();
  }
}

void LinearStructureStates::archive(StateArchive& archive) {
  archive(keeps_energies_);
  for (Structure& each : structures_)
    archive(each.start, each.now, each.force_rate, each.work, each.dissipated, each.stored_at_start);
}

ElementEnergy LinearStructureStates::energy(std::size_t element) const {
  if (!keeps_energies_) throw std::logic_error{"LinearStructureStates: energy() without start_energy_accounts()"};
  const Structure& its = structures_[element];
  return {.work = its.work, .stored = its.stored() - its.stored_at_start, .dissipated = its.dissipated};
}

}  // namespace moat
