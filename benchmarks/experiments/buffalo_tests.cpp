#include "experiments/buffalo_tests.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/text/rows.hpp"
#include "base/text/text_file.hpp"
#include "motions/high_pass.hpp"

namespace moat::experiments {
namespace {

using Vectors = Eigen::Map<const Eigen::VectorXd>;

// Printed times are rounded to 0.1 ms.
constexpr double step = 1.0 / 256.0;

Vectors vector_of(const History& history) { return {history.data(), static_cast<Eigen::Index>(history.size())}; }

History history_of(const Eigen::VectorXd& values) { return {values.data(), values.data() + values.size()}; }

BuffaloTest read(const std::filesystem::path& path) {
  const TextFile file = read_text_file(path);
  const Eigen::MatrixXd values = numbers_of(Rows{file}).values;
  const std::string name = path.stem().string();
  const std::size_t level = name.find_first_of("0123456789", name.rfind('s'));
  if (values.cols() != 6 || level == std::string::npos)
    refuse_file(path, "must have six columns, and a name such as fpgm171s2.csv.");
  const Eigen::VectorXd acceleration = standard_gravity * (values.col(1).array() - values.col(1).mean());
  BuffaloTest test{.name = name,
                   .isolated = name.starts_with("fp"),
                   .level = std::stoi(name.substr(level)),
                   .table = {name, step, history_of(acceleration)},
                   .measured = {}};
  const auto filtered = [](const Eigen::VectorXd& inches) { return high_passed_both_ways(history_of(inch * inches)); };
  test.measured.isolators = filtered(values.col(2) - vector_of(test.table.displacement()) / inch);
  for (int storey = 0; storey < 3; ++storey)
    test.measured.drifts[static_cast<std::size_t>(storey)] = filtered(values.col(3 + storey) - values.col(2 + storey));
  return test;
}

}  // namespace

std::vector<BuffaloTest> read_buffalo_tests(const std::filesystem::path& folder) {
  std::vector<BuffaloTest> tests;
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    const std::string name = entry.path().filename().string();
    if ((name.starts_with("fpgm") || name.starts_with("fbgm")) && name.ends_with(".csv"))
      tests.push_back(read(entry.path()));
  }
  std::ranges::sort(tests, {}, &BuffaloTest::name);
  return tests;
}

History high_passed_both_ways(History history) {
  const double first = history.front();
  for (double& value : history) value -= first;
  for (int way = 0; way < 2; ++way) {
    const GroundMotion filtered = high_passed({"history", step, history}, 0.15 * units::Hz, 2);
    history.assign(filtered.samples().rbegin(), filtered.samples().rend());
  }
  return history;
}

double largest(const History& history) { return vector_of(history).lpNorm<Eigen::Infinity>(); }

double correlation(const History& a, const History& b) {
  const Eigen::VectorXd from_a = vector_of(a).array() - vector_of(a).mean(),
                        from_b = vector_of(b).array() - vector_of(b).mean();
  return from_a.dot(from_b) / (from_a.norm() * from_b.norm());
}

}  // namespace moat::experiments
