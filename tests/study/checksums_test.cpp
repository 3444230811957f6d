// The rows of a study know when they were changed.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <random>
#include <sstream>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "message_of.hpp"
#include "run_program.hpp"
#include "study/file/sqlite.hpp"
#include "study/file/store.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing::message_of;

std::string bits_of(double value) {
  return std::isnan(value) ? "nan" : std::to_string(std::bit_cast<std::uint64_t>(value));
}

class Checksums : public testing::InTemporaryFolder {
 protected:
  const StudyCases cases{{.name = "gap", .unit = "cm", .values = {10.0, 20.0, 30.5}},
                         StudyAxis::of_names("record", {"north", "south"})};
  const StudyIdentity identity{{"script", std::string(64, 'a')}};
  const fs::path file = folder / "study.db";

  Checksums() {
    for (const char* name : {"a", "b"}) std::ofstream{folder / name} << name;
  }
  FileRead of_file(const std::string& name) const { return {(folder / name).string(), sha256_of(name)}; }

  CaseOutcome outcome_of(std::size_t number) const {
    const double x = 0.1 * static_cast<double>(number);
    // Files in another order than that in which earlier cases brought them.
    if (number == 4) return {.state = CaseState::failed, .reason = "no", .files = {of_file("b"), of_file("a")}};
    return {.state = CaseState::done,
            .results = {{"drift", "storey 1", "m", x},
                        {"drift_error", "storey 1", "m", 1e-3 * x},
                        {"x", "", "1", number % 2 == 0 ? std::nan("") : -0.0},
                        {"y", "", "1", number == 2 ? -INFINITY : 4.9e-324},
                        {"unsettled", "", "1", 1.0}},
            .files = {of_file("a"), of_file("b")},
            .steps = 100 + static_cast<long>(number),
            .energy_error = number == 3 ? std::nan("") : 1e-9 * x,
            .seconds = 0.5};
  }
  StudyStore open() const { return {file, cases, identity, {.title = "A study", .engine = "1 thread"}}; }
  void compute(std::size_t first, std::size_t last) const {
    StudyStore store = open();
    const StudyResult known = store.result();
    for (std::size_t number = first; number < last; ++number)
      if (known.state(number) == CaseState::open) store.write(number, outcome_of(number));
  }
  /// Everything that a reader sees of the cases, in every bit.
  static std::string contents_of(const fs::path& path, bool with_sessions = true) {
    const StoredStudy study = read_study(path);
    std::ostringstream text;
    for (std::size_t number = 0; number < study.result.cases().count(); ++number) {
      const CaseOutcome each = study.result.outcome(number);
      text << StudyCase{study.result.cases(), number}.description() << name_of(each.state) << each.reason << each.steps
           << " " << bits_of(each.energy_error) << " " << bits_of(each.seconds) << " ";
      for (const FileRead& one : each.files) text << one.path << one.sha256;
      for (const NamedNumber& one : each.results)
        text << one.quantity << one.where << one.unit << bits_of(one.value) << " ";
      text << (each.state == CaseState::open || !with_sessions ? 0 : study.session_of_case[number]) << "\n";
    }
    return text.str();
  }
  void change(const std::string& statement) const {
    sqlite::Database{file, sqlite::Database::Access::write}.run(statement.c_str());
  }
};

TEST_F(Checksums, RefuseEveryChangeAndNameTheCase) {
  compute(0, 6);
  const std::string before = contents_of(file);
  fs::copy(file, folder / "good.db");
  const std::string of_one = " WHERE number = 1", of_row = " WHERE number = 1 AND position = ";
  for (const std::string& statement :
       std::vector<std::string>{"UPDATE results SET value = 2 * value" + of_row + "0",
                                "UPDATE results SET value = NULL" + of_row + "0",
                                "UPDATE results SET value = 0.0" + of_row + "2",
                                "UPDATE results SET value = 0.002" + of_row + "1",
                                "UPDATE results SET value = 0" + of_row + "4",
                                "UPDATE results SET result = 3" + of_row + "2",
                                "DELETE FROM results" + of_row + "4",
                                "DELETE FROM results" + of_one,
                                "UPDATE results SET position = 17" + of_row + "0",
                                "INSERT INTO results SELECT number, 9, result, value FROM results" + of_row + "0",
                                "UPDATE cases SET state = 'failed'" + of_one,
                                "UPDATE cases SET state = 'dona'" + of_one,
                                "UPDATE cases SET reason = 'x'" + of_one,
                                "UPDATE cases SET steps = steps + 1" + of_one,
                                "UPDATE cases SET energy_error = NULL" + of_one,
                                "UPDATE cases SET seconds = 2 * seconds" + of_one,
                                "UPDATE cases SET session = 7" + of_one,
                                "UPDATE cases SET parameters = '{}'" + of_one,
                                "UPDATE cases SET checksum = ''" + of_one,
                                "UPDATE cases SET checksum = 'x' || checksum" + of_one,
                                "DELETE FROM case_files WHERE file = 1 AND number = 1",
                                "DELETE FROM cases" + of_one}) {
    fs::copy_file(folder / "good.db", file, fs::copy_options::overwrite_existing);
    change(statement);
    const fs::path all = folder / "all.db";
    const std::string shown = message_of<FileError>([&] { read_study(file); });
    EXPECT_NE(shown.find("the results of case 1 are not those that were written"), std::string::npos)
        << statement << ": " << shown;
    EXPECT_NE(shown.find("--retry"), std::string::npos) << shown;
    EXPECT_EQ(message_of<FileError>([&] { (void)open().result(); }), shown) << statement;
    EXPECT_EQ(message_of<FileError>([&] { merge_studies(all, {file}); }), shown) << statement;
    EXPECT_FALSE(fs::exists(all));
    open().forget_failures();
    const StudyResult kept = open().result();
    for (std::size_t number = 0; number < 6; ++number)
      EXPECT_EQ(kept.state(number) == CaseState::open, number == 1 || number == 4) << statement << ", case " << number;
    compute(0, 6);
    EXPECT_EQ(bits_of(value_of(open().result().outcome(1).results, "drift", "storey 1")), bits_of(0.1)) << statement;
  }
  fs::copy_file(folder / "good.db", file, fs::copy_options::overwrite_existing);
  EXPECT_EQ(contents_of(file), before);
}

TEST_F(Checksums, RefuseChangesOfThatWhichCasesShare) {
  compute(0, 6);
  fs::copy(file, folder / "good.db");
  for (const char* statement : {"UPDATE result_names SET unit = 'cm' WHERE quantity = 'drift'",
                                "UPDATE result_names SET place = 'storey 2' WHERE quantity = 'drift'",
                                "UPDATE axis_values SET value = 11 WHERE axis = 0 AND position = 0",
                                "UPDATE axes SET unit = 'm' WHERE axis = 0",
                                "UPDATE axis_values SET label = 'South' WHERE axis = 1 AND position = 1"}) {
    fs::copy_file(folder / "good.db", file, fs::copy_options::overwrite_existing);
    change(statement);
    EXPECT_NE(message_of<FileError>([&] { read_study(file); }).find("the results of case"), std::string::npos)
        << statement;
  }
  // The names are written again with the cases.
  fs::copy_file(folder / "good.db", file, fs::copy_options::overwrite_existing);
  const std::string before = contents_of(file);
  change("UPDATE result_names SET unit = 'cm' WHERE quantity = 'drift'");
  open().forget_failures();
  compute(0, 6);
  EXPECT_EQ(read_study(file).result.table().columns[2].unit, "m");
}

// Of flips in all bytes every one is refused, or changes nothing that a reader sees of the cases.
TEST_F(Checksums, RefuseFlippedBits) {
  compute(0, 6);
  const std::string before = contents_of(file), without_sessions = contents_of(file, false);
  std::ifstream in{file, std::ios::binary};
  const std::string good{std::istreambuf_iterator<char>{in}, {}};
  std::mt19937 random{7};
  int refused = 0, computed_again = 0;
  for (int i = 0; i < 600; ++i) {
    std::string bytes = good;
    bytes[random() % bytes.size()] ^= static_cast<char>(1U << (random() % 8));
    std::ofstream{file, std::ios::binary} << bytes;
    try {
      ASSERT_EQ(contents_of(file), before) << "flip " << i;
    } catch (const Error&) {
      ++refused;
      try {
        open().forget_failures();
        compute(0, 6);
        EXPECT_EQ(contents_of(file, false), without_sessions) << "flip " << i;
        ++computed_again;
      } catch (const Error&) {
        // The tables themselves are damaged, or that which is no case.
      }
      for (const char* name : {"study.db-wal", "study.db-shm"}) fs::remove(folder / name);
    }
  }
  EXPECT_GT(refused, 10);
  EXPECT_GT(computed_again, 0);
}

TEST_F(Checksums, CannotBeTurnedOff) {
  compute(0, 5);
  fs::copy(file, folder / "good.db");
  for (const char* statement :
       {"UPDATE study SET value = '2' WHERE key = 'format'", "ALTER TABLE cases RENAME COLUMN checksum TO checksun"}) {
    fs::copy_file(folder / "good.db", file, fs::copy_options::overwrite_existing);
    change(statement);
    EXPECT_THROW(read_study(file), FileError) << statement;
    EXPECT_THROW((void)open().result(), FileError) << statement;
  }
}

TEST_F(Checksums, StayRightInMergedParts) {
  const fs::path one = folder / "one.db", two = folder / "two.db", all = folder / "all.db";
  compute(4, 5);  // brings its files in another order
  compute(0, 3);
  fs::rename(file, one);
  compute(2, 6);
  fs::rename(file, two);
  merge_studies(all, {one, two});
  compute(0, 6);  // undisturbed
  const StudyResult merged = read_study(all).result, whole = open().result();
  for (std::size_t number = 0; number < 6; ++number) {
    const StudyRecord found = merged.outcome(number).results, expected = whole.outcome(number).results;
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(bits_of(found[i].value), bits_of(expected[i].value));
  }
}

}  // namespace
}  // namespace moat
