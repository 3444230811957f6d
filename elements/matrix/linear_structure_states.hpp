// The states of linear structures in an analysis.
#pragma once

#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "base/vector.hpp"
#include "elements/matrix/linear_structure_block.hpp"
#include "model/element_states.hpp"

namespace moat {

/// Motion, forces and energies of the structures of a block. They have no memory: the committed state is needed for
/// the energies of a step alone.
class LinearStructureStates final : public ElementStates {
 public:
  LinearStructureStates(const LinearStructureBlock& block, const SparseMatrix& matrix);

  std::unique_ptr<ElementStates> clone() const override { return std::make_unique<LinearStructureStates>(*this); }
  bool evaluate(double step, const double* displacement, const double* velocity, double* force) override;
  void evaluate_rates(const double* acceleration, double* force_rate) override;
  void add_tangent(double displacement_weight, double velocity_weight, SparseMatrix& matrix) const override;
  void find_corners(UnlocatedCorners&, double*) const override {}
  AxialActions axial_actions() override { return {}; }
  void add_force_by_compression(std::size_t, double, double*) const override {}
  void commit(double step, WorkRule rule) override;
  void start_energy_accounts() override;
  ElementEnergy energy(std::size_t element) const override;
  /// Zeros: its deformation is no single number.
  ElementResults results() const override { return {.line = {zeros_, zeros_, zeros_, zeros_}}; }
  ReportedValue law_quantity(std::size_t, std::size_t) const override {
    throw std::logic_error{"LinearStructureStates: it has no quantities"};
  }
  double force_inside(std::size_t, double) const override { return 0.0; }
  void scan(double, double, RegimeScan&) const override {}
  double next_fall(double) const override { return std::numeric_limits<double>::infinity(); }
  void change(std::size_t, std::vector<RegimeChange>&) override {}
  ContactView contact(std::size_t) const override { return {}; }
  double shortest_contact() const override { return std::numeric_limits<double>::infinity(); }
  void archive(StateArchive& archive) override;

 private:
  // Deformation v with its rates, and the force K v + C v'.
  struct Instant {
    Vector deformation{}, rate{}, second_rate{}, force{};  // m, m/s, m/s^2, N

    void archive(auto& archive) { archive(deformation, rate, second_rate, force); }
  };
  struct Structure {
    const StructureMatrices* matrices;
    std::vector<int> slots{};  // of all pairs in the values of a matrix, column by column
    Instant start{}, now{};
    Vector of_base{}, force_rate{};                              // R' f, N/s
    double work = 0.0, dissipated = 0.0, stored_at_start = 0.0;  // J

    void relative(const double* values, Vector& result) const;
    void add_force(const Vector& own, double* force);
    [[nodiscard]] double power(const Vector& rate) const;  // W
    [[nodiscard]] double stored() const;                   // J
    void add_energies(double step, WorkRule rule);
  };

  std::vector<Structure> structures_;
  std::vector<double> zeros_;
  bool keeps_energies_ = false;
};

}  // namespace moat
