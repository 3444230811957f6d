// The file of a study.

#include "study/file/store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "message_of.hpp"
#include "run_program.hpp"
#include "study/file/study_file.hpp"

namespace moat {
namespace {

using testing::message_of;

class Store : public testing::InTemporaryFolder {
 protected:
  const StudyCases cases{{.name = "gap", .unit = "cm", .values = {10.0, 20.0, 0.1}},
                         StudyAxis::of_names("record", {"north", "south, \"quoted\""})};
  const StudyIdentity identity{{"script", std::string(64, 'a')}, {"option pga", "0.4g"}};
  std::filesystem::path file = folder / "deep" / "study.db";

  StudyStore open() const { return {file, cases, identity, {.title = "A study", .engine = "1 thread"}}; }
  std::string refusal(const StudyCases& other, const StudyIdentity& by) const {
    return message_of<InputError>([&] { StudyStore{file, other, by, {}}; });
  }
};

CaseOutcome done(StudyRecord results) { return {.state = CaseState::done, .results = std::move(results)}; }

TEST_F(Store, GivesBackEveryBit) {
  const double third = 1.0 / 3.0, tiny = 4.9e-324, nan = std::nan("");
  {
    StudyStore store = open();
    CaseOutcome first =
        done({{"drift", "storey 1", "m", third}, {"drift", "storey 2", "m", tiny}, {"x", "", "1", nan}});
    first.steps = 1234;
    first.energy_error = 1e-5 * third;
    first.seconds = 0.25;
    store.write(4, first);
    store.write(1, done({{"x", "", "1", -INFINITY}, {"drift", "storey 1", "m", 0.1}}));
    store.write(5, {.state = CaseState::not_converged, .reason = "no"});
  }
  const StudyResult result = open().result();
  ASSERT_EQ(result.cases().count(), 6u);
  EXPECT_EQ(result.state(0), CaseState::open);
  const CaseOutcome fifth = result.outcome(4), second = result.outcome(1);
  EXPECT_EQ(fifth.state, CaseState::done);
  EXPECT_EQ(fifth.steps, 1234);
  EXPECT_EQ(fifth.energy_error, 1e-5 * third);
  EXPECT_EQ(fifth.seconds, 0.25);
  EXPECT_EQ(value_of(fifth.results, "drift", "storey 1"), third);
  EXPECT_EQ(value_of(fifth.results, "drift", "storey 2"), tiny);
  EXPECT_TRUE(std::isnan(value_of(fifth.results, "x", "")));
  ASSERT_EQ(second.results.size(), 2u);
  EXPECT_EQ(second.results[0].value, -INFINITY) << "results keep their order";
  EXPECT_EQ(result.state(5), CaseState::not_converged);
  EXPECT_EQ(result.outcome(5).reason, "no");
}

TEST_F(Store, CanBeReadWithoutItsScript) {
  open().write(3, done({{"x", "", "1", 7.0}}));
  const StoredStudy study = read_study(file);
  EXPECT_EQ(study.result.cases().count(), 6u);
  EXPECT_EQ((StudyCase{study.result.cases(), 3}.description()), "gap = 20 cm, record = south, \"quoted\"");
  EXPECT_EQ(study.result.values("x", "")[3], 7.0);
  EXPECT_EQ(study.result.count(CaseState::open), 5u);
  ASSERT_EQ(study.sessions.size(), 1u);
  EXPECT_EQ(study.sessions[0].engine, "1 thread");
}

TEST_F(Store, CanBeReadWhileItIsWritten) {
  StudyStore store = open();
  store.write(3, done({{"x", "", "1", 7.0}}));
  EXPECT_EQ(read_study(file).result.count(CaseState::done), 1u);
  store.write(2, done({{"x", "", "1", 8.0}}));
  EXPECT_EQ(read_study(file).result.count(CaseState::done), 2u);
}

TEST_F(Store, KeepsListsAndTheirProducts) {
  const StudyCases both = StudyCases::list({{.name = "a", .unit = "", .values = {1.0, 2.0}},
                                            {.name = "b", .unit = "m", .values = {3.0, 4.0}}})
                              .times({StudyAxis::of_names("c", {"x", "y", "z"})});
  { StudyStore store{file, both, {}, {}}; }
  const StoredStudy study = read_study(file);
  EXPECT_EQ(study.result.cases().groups(), both.groups());
  for (std::size_t i = 0; i < both.count(); ++i)
    EXPECT_EQ((StudyCase{study.result.cases(), i}.description()), (StudyCase{both, i}.description()));
}

TEST_F(Store, NamesEveryChange) {
  open();
  StudyIdentity other = identity;
  other["script"] = std::string(64, 'b');
  other["option gap"] = "3 cm";
  const std::string message = refusal(cases, other);
  EXPECT_NE(message.find("script: aaaaaaaaaaaa... -> bbbbbbbbbbbb..."), std::string::npos) << message;
  EXPECT_NE(message.find("option gap: none -> 3 cm"), std::string::npos) << message;
  EXPECT_EQ(message.find("pga"), std::string::npos) << message;
  EXPECT_NE(refusal(cases, {*identity.rbegin()}).find("option pga: 0.4g -> none"), std::string::npos);

  StudyAxis gap = cases.axes()[0];
  gap.values.push_back(3.0);
  EXPECT_NE(refusal({gap, cases.axes()[1]}, identity).find("axis gap: its values (3 -> 4), new: 3"), std::string::npos);
  EXPECT_NE(refusal({cases.axes()[1], cases.axes()[0]}, identity).find("axes: gap, record -> record, gap"),
            std::string::npos);
  StudyAxis record = cases.axes()[1];
  record.hashes = {"1", "2"};
  EXPECT_NE(refusal({cases.axes()[0], record}, identity).find("record north: none -> 1"), std::string::npos);
  EXPECT_NO_THROW(open());
}

CaseOutcome that_read(const std::filesystem::path& path, const std::string& sha256) {
  CaseOutcome outcome = done({});
  outcome.files = {{path.string(), sha256}};
  return outcome;
}

TEST_F(Store, RefusesAFileThatChangesMeanwhile) {
  StudyStore store = open();
  store.write(0, that_read("/north.AT2", "1"));
  store.write(1, that_read("/north.AT2", "1"));
  EXPECT_NE(message_of<InputError>([&] { store.write(2, that_read("/north.AT2", "2")); }).find("/north.AT2 changed"),
            std::string::npos);
  EXPECT_EQ(store.result().state(2), CaseState::open);
}

TEST_F(Store, KnowsTheVersionOfEveryCaseAfterAcceptedChanges) {
  const std::filesystem::path record = folder / "north.AT2";
  const auto accepted = [&](const StudyIdentity& by) {
    return StudyStore{file, cases, by, {.engine = "1 thread"}, StudyChanges::accept};
  };
  std::ofstream{record} << "before";
  open().write(0, that_read(record, sha256_of("before")));
  const StudyIdentity other{{"script", std::string(64, 'b')}};
  std::ofstream{record} << "after";
  accepted(other).write(1, that_read(record, sha256_of("after")));
  EXPECT_NE(refusal(cases, identity).find("script: bbbbbbbbbbbb... -> aaaaaaaaaaaa..."), std::string::npos);
  // Back to the first state: it is the first version again.
  std::ofstream{record} << "before";
  accepted(identity).write(2, that_read(record, sha256_of("before")));
  { const StudyStore goes_on = open(); }
  const StoredStudy study = read_study(file);
  ASSERT_EQ(study.versions.size(), 2u);
  EXPECT_EQ(study.versions[1], other);
  std::vector<std::size_t> versions;
  for (std::size_t i = 0; i < 3; ++i) versions.push_back(study.sessions[study.session_of_case[i]].version);
  EXPECT_EQ(versions, (std::vector<std::size_t>{0, 1, 0}));
  EXPECT_EQ(study.result.outcome(1).files.at(0).sha256, sha256_of("after"));
  EXPECT_EQ(study.result.outcome(2).files.at(0).sha256, sha256_of("before"));
  EXPECT_THROW((StudyStore{file, {cases.axes()[0]}, identity, {}, StudyChanges::accept}), InputError);
}

TEST_F(Store, GoesOnWithFilesOfAProcessKilledAtItsBeginning) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream{file};
  EXPECT_NO_THROW(open()) << "an empty file";
  std::filesystem::remove(file);
  { const StudyFile without_session{file, cases, "A study"}; }
  EXPECT_NO_THROW(open());
}

TEST_F(Store, IsOneFileAtItsEnd) {
  {
    StudyStore store = open();
    store.write(3, done({{"x", "", "1", 7.0}}));
    store.end_session("finished");
  }
  const auto files = [&] { return std::distance(std::filesystem::directory_iterator{file.parent_path()}, {}); };
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(read_study(file).sessions.at(0).ending, "finished");
  EXPECT_EQ(read_study(file).sessions.at(0).cases, 1u);
  EXPECT_EQ(files(), 1) << "reading leaves nothing behind";
}

TEST_F(Store, IsComputedByOneProcessAtATime) {
  const StudyStore store = open();
  EXPECT_NE(refusal(cases, identity).find("another process computes it now"), std::string::npos);
}

TEST_F(Store, RefusesOtherFiles) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream{file} << std::string(5000, 'x');
  EXPECT_THROW(open(), FileError);
  EXPECT_THROW(read_study(file), FileError);
  EXPECT_THROW(read_study(folder / "none.db"), FileError);
  EXPECT_FALSE(std::filesystem::exists(folder / "none.db"));
  EXPECT_THROW((StudyStore{"/proc/study.db", cases, identity, {}}), FileError);
}

TEST_F(Store, RefusesADamagedVersion) {
  open();
  for (const std::string text : {"b", "-1", "0x", "1 ", "99999999999999999999999", "4000000000", "999990"}) {
    sqlite::Database{file, sqlite::Database::Access::write}
        .prepare("UPDATE study SET value = ? WHERE key = 'version'")
        .run(text);
    EXPECT_EQ(message_of<FileError>([&] { (void)read_study(file); }),
              "study " + file.string() + ": its version is \"" + text +
                  "\"; it must be a whole number up to 10000. The file is damaged: restore a copy, or start again in "
                  "another file.");
  }
}

TEST_F(Store, RefusesVersionsAndSessionsThatAreNone) {
  open().write(0, done({}));
  std::filesystem::copy_file(file, folder / "good.db");
  const auto message = [&](const std::string& statement) {
    std::filesystem::copy_file(folder / "good.db", file, std::filesystem::copy_options::overwrite_existing);
    sqlite::Database{file, sqlite::Database::Access::write}.run(statement.c_str());
    return message_of<FileError>([&] { (void)read_study(file); });
  };
  for (const std::string table : {"versions", "sessions"})
    for (const std::string number : {"-1", "4000000000000"})
      EXPECT_EQ(message("UPDATE " + table + " SET version = " + number),
                "study " + file.string() + ": it has a version " + number +
                    ". The file is damaged: restore a copy, or start again in another file.");
  EXPECT_EQ(message("DELETE FROM sessions"),
            "study " + file.string() +
                ": it lacks session 1, which computed a case. The file is damaged: restore a copy, or start again in "
                "another file.");
}

// Without hashes and options a version has no rows.
TEST_F(Store, KnowsVersionsWithoutNames) {
  for (const StudyIdentity& each : {identity, StudyIdentity{}, identity})
    StudyStore{file, cases, each, {}, StudyChanges::accept};
  const StoredStudy study = read_study(file);
  EXPECT_EQ(study.versions, (std::vector<StudyIdentity>{identity, {}}));
  EXPECT_EQ(study.sessions.at(1).version, 1u);
  EXPECT_EQ(study.current_version, 0u);
}

TEST_F(Store, WritesNoCaseTwice) {
  StudyStore store = open();
  store.write(0, done({{"x", "", "1", 1.0}}));
  EXPECT_THROW(store.write(0, done({{"x", "", "1", 2.0}})), FileError);
  EXPECT_EQ(value_of(store.result().outcome(0).results, "x", ""), 1.0);
}

}  // namespace
}  // namespace moat
