#include "app/script/checkpoint_file.hpp"

#include <ostream>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "base/sha256.hpp"
#include "output/files/file_io.hpp"
#include "output/files/folder_exchange.hpp"

namespace moat {
namespace {

constexpr std::string_view title = "moat checkpoint ", format = "1\n";
constexpr std::size_t hash_length = 64;

}  // namespace

void write_checkpoint(const std::filesystem::path& path, StudyIdentity identity,
                      const std::function<void(StateArchive&)>& write_state) {
  StateArchive archive;
  archive(identity);
  write_state(archive);
  const std::string bytes = archive.take();
  write_file(path, [&](std::ostream& file) { file << title << format << sha256_of(bytes) << bytes; });
}

StateArchive read_checkpoint(const std::filesystem::path& path, const StudyIdentity& identity) {
  const std::string name = path.string();
  const Check check{"checkpoint", name};
  const std::string remedy = "Compute the run again, without --resume.";
  std::string bytes = text_in(path);
  check.that(bytes.starts_with(title), "this is no checkpoint of moat, its begin is damaged, or it cannot be read.",
             remedy);
  const std::string_view behind = std::string_view{bytes}.substr(title.size());
  check.that(behind.starts_with(format), "another version of moat wrote it, in another format.", remedy);
  const std::string hash{behind.substr(format.size(), hash_length)};
  bytes.erase(0, title.size() + format.size() + hash.size());
  check.that(hash == sha256_of(bytes), "it is damaged: its checksum is another one.", remedy);
  StateArchive archive{std::move(bytes)};
  StudyIdentity before;
  archive(before);
  const std::string changes = differences(before, identity);
  check.that(changes.empty(), "it is of another run:" + changes + "\n",
             "Give the script and the options of that run, or compute again without --resume.");
  return archive;
}

}  // namespace moat
