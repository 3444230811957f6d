// Matrices: CSV, Matrix Market, text such as printA of OpenSees writes.

#include <cstdlib>

#include "base/units.hpp"
#include "fuzzing.hpp"
#include "structures/files/matrix_file.hpp"

using namespace moat;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  const std::filesystem::path file = folder.file("matrix.csv", fuzz::text_of(data, size));
  for (const MatrixFormat format :
       {MatrixFormat::detect, MatrixFormat::csv, MatrixFormat::matrix_market, MatrixFormat::text})
    (void)fuzz::tried([&] {
      const MatrixInUnits matrix =
          read_matrix(file, {.force = 1.0 * units::kN, .length = 1.0 * units::m, .format = format});
      if (matrix.values.size() == 0 || matrix.values.rows() != matrix.values.cols() || !matrix.values.allFinite())
        std::abort();
    });
  return 0;
}
