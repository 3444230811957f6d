// Tables of buildings: storeys with outlines, bearings, modes with their shapes.

#include <cstdlib>

#include "base/units.hpp"
#include "fuzzing.hpp"
#include "structures/files/bearing_table.hpp"
#include "structures/files/mode_files.hpp"
#include "structures/files/storey_table.hpp"

using namespace moat;
using namespace moat::units;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  static const BearingTypes types{
      {{"LRB", LeadRubberBearing{
                   .yield_force = 1.0 * kN, .yield_displacement = 1.0 * cm, .post_yield_stiffness = 1.0 * kN / m}}}};
  const std::vector<std::string_view> parts = fuzz::parts_of(fuzz::text_of(data, size), 2);
  const std::filesystem::path first = folder.file("first.csv", parts[0]), second = folder.file("second.csv", parts[1]);
  (void)fuzz::tried([&] { (void)read_storeys(first, read_outlines(second)); });
  (void)fuzz::tried([&] { (void)read_storeys(first); });
  (void)fuzz::tried([&] { (void)read_bearings(first, types); });
  return fuzz::tried([&] {
    const ModesFromFile modes = read_modes(first, second);
    if (!modes.eigenvalues.allFinite() || !modes.shapes.allFinite()) std::abort();
  });
}
