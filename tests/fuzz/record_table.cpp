// The table records.csv beside two files of records, of plain text and of PEER.

#include <cmath>
#include <cstdlib>

#include "fuzzing.hpp"
#include "motions/readers/record.hpp"

using namespace moat;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  const std::vector<std::string_view> parts = fuzz::parts_of(fuzz::text_of(data, size), 3);
  (void)folder.file("records.csv", parts[0]);
  (void)folder.file("a.txt", parts[1]);
  (void)folder.file("b.AT2", parts[2]);
  return fuzz::tried([&] {
    const FilesOfThisThread reading;
    for (const Record& record : read_records(folder.path()))
      for (const double sample : record.first.samples())
        if (!std::isfinite(sample)) std::abort();
  });
}
