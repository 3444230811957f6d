#include "model/mass_matrix.hpp"

#include <algorithm>

namespace moat {

Vector MassMatrix::Block::gathered(const double* values) const {
  Vector gathered{masses.rows()};
  for (Eigen::Index k = 0; k < gathered.size(); ++k) gathered[k] = values[rows[static_cast<std::size_t>(k)]];
  return gathered;
}

bool MassMatrix::add(std::span<const int> degrees_of_freedom, const Eigen::MatrixXd& masses) {
  // Blocks with common rows become one, whose factors are then those of the matrix.
  std::vector<int> rows{degrees_of_freedom.begin(), degrees_of_freedom.end()};
  std::ranges::sort(rows);
  std::vector<Block> others, joined;
  for (const Block& block : blocks_) {
    const bool common = std::ranges::any_of(block.rows, [&](int row) { return std::ranges::binary_search(rows, row); });
    (common ? joined : others).push_back(block);
  }
  for (const Block& block : joined) {
    std::vector<int> both;
    std::ranges::set_union(rows, block.rows, std::back_inserter(both));
    rows = std::move(both);
  }
  const auto position = [&](int row) { return std::ranges::lower_bound(rows, row) - rows.begin(); };
  const auto size = static_cast<Eigen::Index>(rows.size());
  Block block{.rows = rows, .masses = Eigen::MatrixXd::Zero(size, size), .factors = {}};
  for (const int row : rows) block.masses(position(row), position(row)) = diagonal_[static_cast<std::size_t>(row)];
  const auto add_all = [&](std::span<const int> of, const Eigen::MatrixXd& values, bool with_diagonal) {
    for (std::size_t i = 0; i < of.size(); ++i)
      for (std::size_t j = 0; j < of.size(); ++j)
        if (i != j || with_diagonal)
          block.masses(position(of[i]), position(of[j])) +=
              values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  };
  for (const Block& other : joined) add_all(other.rows, other.masses, false);
  add_all(degrees_of_freedom, masses, true);
  block.factors.compute(block.masses);
  if (block.factors.info() != Eigen::Success) return false;
  for (const int row : rows) diagonal_[static_cast<std::size_t>(row)] = block.masses(position(row), position(row));
  blocks_ = std::move(others);
  blocks_.push_back(std::move(block));
  return true;
}

std::span<const int> MassMatrix::coupled_with(int row) const {
  for (const Block& block : blocks_)
    if (std::ranges::binary_search(block.rows, row)) return block.rows;
  return {};
}

double MassMatrix::at(int row, int column) const {
  if (row == column) return diagonal_[static_cast<std::size_t>(row)];
  for (const Block& block : blocks_) {
    const auto i = std::ranges::find(block.rows, row), j = std::ranges::find(block.rows, column);
    if (i != block.rows.end() && j != block.rows.end())
      return block.masses(i - block.rows.begin(), j - block.rows.begin());
  }
  return 0.0;
}

void MassMatrix::multiply(const double* values, double* __restrict result) const {
  const double* diagonal = diagonal_.data();
  for (std::size_t i = 0; i < diagonal_.size(); ++i) result[i] = diagonal[i] * values[i];
  for (const Block& block : blocks_) {
    const Vector product = block.masses * block.gathered(values);
    for (std::size_t k = 0; k < block.rows.size(); ++k) result[block.rows[k]] = product[static_cast<Eigen::Index>(k)];
  }
}

void MassMatrix::solve(double* values) const {
  const double* diagonal = diagonal_.data();
  for (std::size_t i = 0; i < diagonal_.size(); ++i) values[i] /= diagonal[i];
  for (const Block& block : blocks_) {
    Vector solution = block.gathered(values);
    for (std::size_t k = 0; k < block.rows.size(); ++k)
      solution[static_cast<Eigen::Index>(k)] *= diagonal[static_cast<std::size_t>(block.rows[k])];
    block.factors.solveInPlace(solution);
    for (std::size_t k = 0; k < block.rows.size(); ++k) values[block.rows[k]] = solution[static_cast<Eigen::Index>(k)];
  }
}

double MassMatrix::mobility(std::span<const int> degrees_of_freedom, std::span<const double> a,
                            std::span<const double> b) const {
  double sum = 0.0;
  if (is_diagonal()) {
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += a[i] * b[i] / diagonal_[static_cast<std::size_t>(degrees_of_freedom[i])];
    return sum;
  }
  std::vector<double> values(diagonal_.size(), 0.0);
  for (std::size_t i = 0; i < b.size(); ++i) values[static_cast<std::size_t>(degrees_of_freedom[i])] = b[i];
  solve(values.data());
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * values[static_cast<std::size_t>(degrees_of_freedom[i])];
  return sum;
}

Vector MassMatrix::largest_accelerations(const Vector& sizes) const {
  Vector largest = sizes.cwiseQuotient(diagonal());
  for (const Block& block : blocks_) {
    const auto size = block.masses.rows();
    const Eigen::MatrixXd inverse = block.factors.solve(Eigen::MatrixXd::Identity(size, size));
    const Vector of_block = inverse.cwiseAbs() * block.gathered(sizes.data());
    for (Eigen::Index k = 0; k < size; ++k) largest[block.rows[static_cast<std::size_t>(k)]] = of_block[k];
  }
  return largest;
}

void MassMatrix::add_couplings(Couplings& couplings) const {
  for (const Block& block : blocks_)
    for (const int row : block.rows)
      for (const int column : block.rows) couplings.couple(row, column);
}

void MassMatrix::add_to(double weight, SparseMatrix& matrix) const {
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    const auto row = static_cast<int>(i);
    matrix.coeffRef(row, row) += weight * diagonal_[i];
  }
  for (const Block& block : blocks_)
    for (std::size_t i = 0; i < block.rows.size(); ++i)
      for (std::size_t j = 0; j < block.rows.size(); ++j)
        if (i != j)
          matrix.coeffRef(block.rows[i], block.rows[j]) +=
              weight * block.masses(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
}

}  // namespace moat
