// Results that replace others, killed at every system call.
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <functional>
#include <random>
#include <set>

#include "output/files/results_folder.hpp"
#include "output_testing.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using testing_output::read_file;

void write_text(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream{path} << text;
}

/// As on a file system that cannot exchange two folders, for this process.
void forbid_exchange() {
  std::array<sock_filter, 4> program{{{BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
                                      {BPF_JMP | BPF_JEQ | BPF_K, 0, 1, SYS_renameat2},
                                      {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | EINVAL},
                                      {BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW}}};
  const sock_fprog filter{program.size(), program.data()};
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0) _exit(2);
}

/// Returns whether the process was killed at the entry of its system call of this number, counted from 1, before the
/// end of `work`.
bool killed_at(int number, const std::function<void()>& prepare, const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    prepare();
    if (ptrace(PTRACE_TRACEME, 0, 0, 0) != 0) _exit(3);
    raise(SIGSTOP);
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  // Every system call stops the child twice.
  for (int stops = 0; WIFSTOPPED(status); ++stops) {
    if (stops == 2 * number - 1) {
      kill(child, SIGKILL);
    } else if (ptrace(PTRACE_SYSCALL, child, 0, 0) != 0) {
      ADD_FAILURE() << "ptrace: " << std::strerror(errno);
      kill(child, SIGKILL);  // it would wait for ever
    }
    waitpid(child, &status, 0);
  }
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0) << status;
  return WIFSIGNALED(status);
}

/// Some containers do not let a process follow its child.
bool may_trace() {
  const pid_t child = fork();
  if (child == 0) _exit(ptrace(PTRACE_TRACEME, 0, 0, 0) == 0 ? 0 : 3);
  int status = -1;
  waitpid(child, &status, 0);
  return status == 0;
}

class KilledExchange : public testing_output::InFolder, public ::testing::WithParamInterface<bool> {
 protected:
  // A disk would let each of hundreds of runs wait.
  KilledExchange() {
    if (!fs::is_directory("/dev/shm")) return;
    fs::remove(folder);
    folder = fs::path{"/dev/shm"} / folder.filename();
  }

  void SetUp() override {
    if (!may_trace()) GTEST_SKIP() << "ptrace is forbidden (container: --cap-add SYS_PTRACE)";
  }

  fs::path x() const { return folder / "x"; }
  const std::set<fs::path> of_user{"notes.txt", "impacts.csv", "frames/mine.vtu", "own/deep/data.txt"};

  static void write_files(const fs::path& results, const std::string& text) {
    for (const fs::path name : {"summary.json", "report.html", "frames/frame_000000.vtu"})
      write_text(results / name, text);
    write_text(results / "charts" / (text + ".svg"), text);
  }
  std::unique_ptr<ResultsFolder> written(const std::string& text) const {
    auto results = std::make_unique<ResultsFolder>(x(), WhenFolderExists::overwrite);
    write_files(results->path(), text);
    return results;
  }
  /// The text of all files of moat in complete results; else a description.
  static std::string text_of(const fs::path& results) {
    if (!fs::exists(results)) return "nothing";
    const std::string text = read_file(results / "summary.json");
    for (const fs::path name : {"report.html", "frames/frame_000000.vtu"})
      if (read_file(results / name) != text) return "torn: " + name.string();
    for (const auto& entry : fs::directory_iterator{results / "charts"})
      if (entry.path().stem() != text || read_file(entry.path()) != text) return "torn: " + entry.path().string();
    return fs::exists(results / ".moat") ? text : "without list";
  }
  void expect_files_of_user(const fs::path& results) const {
    for (const fs::path& name : of_user) EXPECT_EQ(read_file(results / name), "mine") << name;
    EXPECT_TRUE(fs::is_directory(results / "own" / "empty"));
  }
  void begin() const {
    fs::remove_all(folder);
    write_files(x(), "old");
    write_text(x() / ".moat",
               "moat wrote these files. Overwriting the results replaces them and no others.\nsummary.json\n"
               "report.html\nframes/frame_000000.vtu\ncharts/old.svg\n.moat\n");
    for (const fs::path& name : of_user) write_text(x() / name, "mine");
    fs::create_directory(x() / "own" / "empty");
  }
  /// Where results are after a run was killed: with GetParam() at their place.
  fs::path place() const { return GetParam() || fs::exists(x()) ? x() : folder / "x.new.old"; }
};

TEST_P(KilledExchange, LeavesTheOldOrTheNewResults) {
  std::mt19937 random{1};
  std::unique_ptr<ResultsFolder> run;
  const auto limit = [] {
    if (!GetParam()) forbid_exchange();
  };
  std::set<std::string> seen;
  bool was_killed = true;
  for (int number = 1; was_killed && !HasFailure(); ++number) {
    SCOPED_TRACE("killed at system call " + std::to_string(number));
    begin();
    was_killed = killed_at(
        number,
        [&] {
          run = written("new");
          limit();
        },
        [&] { run->finish(); });
    const std::string left = text_of(place());
    if (was_killed) seen.insert(left);
    EXPECT_TRUE(left == "old" || left == "new") << left;
    expect_files_of_user(place());
    const bool is_complete = left == "new" || fs::exists(folder / "x.new" / ".moat");

    // A run that ends this exchange may be killed too.
    if (number % 5 == 0) {
      const int again = std::uniform_int_distribution{1, 400}(random);
      SCOPED_TRACE("and then at " + std::to_string(again));
      const bool next_was_killed = killed_at(again, limit, [&] { written("newer")->finish(); });
      const std::string then = text_of(place());
      EXPECT_TRUE(then == "newer" || (next_was_killed && (then == left || (is_complete && then == "new")))) << then;
      expect_files_of_user(place());
    }

    run = written("newest");
    EXPECT_FALSE(is_complete && text_of(x()) == "old") << "complete results have their place when a run begins";
    run->finish();
    EXPECT_EQ(text_of(x()), "newest");
    expect_files_of_user(x());
    EXPECT_FALSE(fs::exists(x() / "unfinished"));
    EXPECT_EQ(std::distance(fs::directory_iterator{folder}, fs::directory_iterator{}), 1) << "only x";
  }
  EXPECT_EQ(seen, (std::set<std::string>{"new", "old"})) << "after kills";
}

INSTANTIATE_TEST_SUITE_P(FileSystems, KilledExchange, ::testing::Bool(),
                         [](const auto& each) { return each.param ? "WithExchange" : "WithRenamesAlone"; });

}  // namespace
}  // namespace moat
