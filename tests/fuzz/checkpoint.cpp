// Checkpoints: inputs as whole files, and as the state in a file whose checksum fits.

#include "base/sha256.hpp"
#include "fuzzing.hpp"
#include "saved_state.hpp"

using namespace moat;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  const std::string bytes{fuzz::text_of(data, size)};
  for (const std::string& file : {bytes, "moat checkpoint 1\n" + sha256_of(bytes) + bytes})
    (void)fuzz::tried([&] {
      StateArchive archive = read_checkpoint(folder.file("checkpoint", file), fuzz::identity_of_saved);
      fuzz::SavedState state;
      state.archive(archive);
    });
  return 0;
}
