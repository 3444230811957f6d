// Records of all networks and plain text, as one file.

#include <cmath>
#include <cstdlib>

#include "base/units.hpp"
#include "fuzzing.hpp"
#include "motions/readers/record.hpp"

using namespace moat;

namespace {

/// A motion that a reader lets pass can be computed with.
void require_usable(const GroundMotion& motion) {
  bool usable = motion.samples().size() >= 2 && motion.time_step() > 0.0 && std::isfinite(motion.time_step());
  for (const double sample : motion.samples()) usable = usable && std::isfinite(sample);
  if (!usable) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  // The name of a file may decide about its format and component.
  const std::filesystem::path file = folder.file(size % 2 == 0 ? "a_N10E.AT2" : "a.txt", fuzz::text_of(data, size));
  (void)fuzz::tried([&] {
    for (const RecordChannel& channel : read_channels(file, {.unit = 1.0 * units::g}))
      require_usable(motion_of(channel));
  });
  return fuzz::tried([&] {
    const FilesOfThisThread reading;
    const Record record =
        read_record({file}, {.text = {.step = 0.01 * units::s, .columns = size % 3 == 0 ? "time,x,y" : ""}});
    require_usable(record.first);
    if (record.second) require_usable(*record.second);
    if (record.vertical) require_usable(*record.vertical);
  });
}
