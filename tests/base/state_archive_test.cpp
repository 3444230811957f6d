// Values come back from bytes as they went in.

#include "base/state_archive.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

#include "base/sparse_matrix.hpp"
#include "base/vector.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

struct Named {
  std::string name;
  std::vector<double> values;

  void archive(auto& archive) { archive(name, values); }
  friend bool operator==(const Named&, const Named&) = default;
};

template <class Value>
Value after_both_ways(Value value, Value other) {
  StateArchive written;
  written(value);
  StateArchive read{written.take()};
  read(other);
  read.require_end();
  return other;
}

TEST(StateArchive, ReadsWhatItWrote) {
  EXPECT_EQ(after_both_ways(1.5, 0.0), 1.5);
  const double negative_nan = std::bit_cast<double>(0xfff8000000000123U);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(after_both_ways(negative_nan, 0.0)), 0xfff8000000000123U);
  const std::string text("a\0b", 3);
  EXPECT_EQ(after_both_ways(text, std::string{"longer than before"}), text);
  const Named named{"moat left", {1.0, -0.0}};
  EXPECT_EQ(after_both_ways(named, {}), named);
  EXPECT_EQ(after_both_ways(std::vector{named, named}, {}), (std::vector{named, named}));
  EXPECT_EQ(after_both_ways(std::optional{named}, {}), std::optional{named});
  EXPECT_EQ(after_both_ways(std::optional<Named>{}, std::optional{named}), std::nullopt);
  const std::map<long, double> map{{3, 0.1}, {7, 0.2}};
  EXPECT_EQ(after_both_ways(map, {{1, 1.0}}), map);
  EXPECT_EQ(after_both_ways(std::array{named, Named{}}, {}), (std::array{named, Named{}}));
  const Vector vector{{1.0, 2.0, 3.0}};
  EXPECT_EQ(after_both_ways(vector, Vector{}), vector);
  SparseMatrix matrix{2, 2}, same_pattern{2, 2};
  matrix.insert(1, 0) = 4.0;
  same_pattern.insert(1, 0) = 5.0;
  EXPECT_EQ(after_both_ways(matrix, same_pattern).coeff(1, 0), 4.0);
}

TEST(StateArchive, RefusesBytesThatDoNotFit) {
  StateArchive written;
  std::vector<double> values(10);
  written(values);
  const std::string bytes = written.take();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    StateArchive read{bytes.substr(0, size)};
    EXPECT_EQ(testing::message_of([&] { read(values); }), "The saved state is shorter than that of this analysis.");
  }
  // A number of values that no memory holds.
  StateArchive huge{std::string(16, '\x7f')};
  EXPECT_EQ(testing::message_of([&] { huge(values); }), "The saved state is shorter than that of this analysis.");
  StateArchive longer{bytes + "x"};
  longer(values);
  EXPECT_EQ(testing::message_of([&] { longer.require_end(); }),
            "The saved state is longer than that of this analysis.");
}

TEST(StateArchive, RefusesMatricesOfOtherShapes) {
  using Shape = std::array<Eigen::Index, 2>;
  const auto refusal = [](Shape shape, auto matrix) {
    StateArchive written;
    written(shape);
    StateArchive read{written.take()};
    return testing::message_of([&] { read(matrix); });
  };
  const std::string shape = "The saved state has a matrix of another shape than this analysis.";
  const std::string size = "The saved state is shorter than that of this analysis.";
  EXPECT_EQ(refusal({1, 2}, Vector{}), shape);
  EXPECT_EQ(refusal({-1, 1}, Vector{}), shape);
  EXPECT_EQ(refusal({3, 2}, Eigen::Matrix3d{}), shape);
  EXPECT_EQ(refusal({1, 1}, Vector{}), size);
  // Their product is 0 as a number of 64 bits.
  EXPECT_EQ(refusal({Eigen::Index{1} << 32, Eigen::Index{1} << 32}, Eigen::MatrixXd{}), size);
}

TEST(StateArchive, RefusesATextThatDiffers) {
  StateArchive written;
  written.require_same("tower", "Not read.");
  StateArchive read{written.take()};
  EXPECT_EQ(testing::message_of([&] { read.require_same("bridge", "It is that of another model."); }),
            "It is that of another model.");
}

}  // namespace
}  // namespace moat
