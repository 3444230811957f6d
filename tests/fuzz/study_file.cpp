// The texts and numbers in the file of a study that moat itself understands: format, versions, axes, states, names.

#include "fuzzing.hpp"
#include "study/file/store.hpp"
#include "study/file/study_tables.hpp"
#include "study/result.hpp"

using namespace moat;

namespace {

const StudyCases& cases() {
  static const StudyCases both{StudyAxis{.name = "gap", .unit = "cm", .values = {10.0, 20.0}},
                               StudyAxis::of_names("record", {"A", "B"})};
  return both;
}

/// A finished study, as bytes.
std::string study(const fuzz::Folder& folder) {
  const std::filesystem::path file = folder.path() / "good.db";
  {
    StudyStore store{file, cases(), {{"script", "1"}}, {.title = "study"}};
    for (std::size_t i = 0; i < cases().count(); ++i)
      store.write(i, {.state = CaseState::done, .results = {{"peak", "floor", "m", 1.0}}, .files = {{"a", "b"}}});
  }
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  static const std::string good = study(folder);
  // One field of each kind; an input without separators changes one of them.
  static constexpr const char* statements[] = {"UPDATE study SET value = ? WHERE key = 'version'",
                                               "UPDATE study SET value = ? WHERE key = 'format'",
                                               "UPDATE study SET value = ? WHERE key = 'cases'",
                                               "UPDATE axes SET name = ? WHERE axis = 0",
                                               "UPDATE axes SET cases_group = ? WHERE axis = 1",
                                               "UPDATE axis_values SET value = ? WHERE axis = 0 AND position = 1",
                                               "UPDATE axis_values SET label = ? WHERE axis = 1 AND position = 0",
                                               "UPDATE versions SET value = ?",
                                               "UPDATE versions SET version = ?",
                                               "UPDATE sessions SET version = ?",
                                               "UPDATE sessions SET session = ?",
                                               "UPDATE cases SET number = ? WHERE number = 1",
                                               "UPDATE cases SET state = ? WHERE number = 1",
                                               "UPDATE cases SET parameters = ? WHERE number = 2",
                                               "UPDATE results SET result = ? WHERE number = 0",
                                               "UPDATE files SET path = ?"};
  if (size == 0) return 0;
  const std::string_view statement = statements[data[0] % std::size(statements)];
  const std::filesystem::path file = folder.file("study.db", good);
  (void)fuzz::tried([&] {
    const sqlite::Database database{file, sqlite::Database::Access::write};
    database.prepare(statement).run(fuzz::text_of(data + 1, size - 1));
    database.become_one_file();
  });
  const std::filesystem::path merged = folder.path() / "merged.db";
  std::filesystem::remove(merged);
  (void)fuzz::tried([&] { merge_studies(merged, {file}); });
  return fuzz::tried([&] {
    StudyStore store{file, cases(), {{"script", "1"}}, {.title = "study"}};
    (void)store.result();
    store.forget_failures();
  });
}
