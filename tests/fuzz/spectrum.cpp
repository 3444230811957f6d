// Target spectra: CSV, and the JSON of the service of the USGS.

#include <cmath>
#include <cstdlib>

#include "base/units.hpp"
#include "fuzzing.hpp"
#include "motions/spectra/target_spectrum.hpp"

using namespace moat;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  const std::filesystem::path file = folder.file("spectrum", fuzz::text_of(data, size));
  const auto level = size % 2 == 0 ? SpectrumLevel::design : SpectrumLevel::mce_r;
  return fuzz::tried([&] {
    const TargetSpectrum target = read_target_spectrum(file, {.level = level});
    if (!std::isfinite(target.acceleration(target.shortest).si())) std::abort();
  });
}
