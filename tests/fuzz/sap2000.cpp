// The files of SAP2000 beside a table of joints.

#include <cmath>
#include <cstdlib>

#include "base/units.hpp"
#include "fuzzing.hpp"
#include "structures/frame/sap2000.hpp"

using namespace moat;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  constexpr std::size_t files = 5;
  const std::vector<std::string_view> parts = fuzz::parts_of(fuzz::text_of(data, size), files);
  const char* const names[files] = {"joints.csv", "a.TXE", "a.TXK", "a.TXM", "a.TXC"};
  for (std::size_t i = 0; i < files; ++i) (void)folder.file(names[i], parts[i]);
  return fuzz::tried([&] {
    const FiniteElements model = read_sap2000(folder.path() / "a", folder.path() / "joints.csv",
                                              {.force = 1.0 * units::kN, .length = 1.0 * units::m});
    if (!model.stiffness.coeffs().allFinite()) std::abort();
  });
}
