#include "analyses/case/available_memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "in_folder.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

class AvailableMemory : public testing::InFolder {
 protected:
  void put(const fs::path& path, const std::string& text) const {
    fs::create_directories((folder / path).parent_path());
    std::ofstream{folder / path} << text;
  }
};

TEST_F(AvailableMemory, IsThatOfTheSystem) {
  EXPECT_TRUE(std::isinf(available_memory(folder))) << "nothing is known";
  put("proc/meminfo", "MemTotal:       16000000 kB\nMemFree:        1000000 kB\nMemAvailable:   2000000 kB\n");
  EXPECT_EQ(available_memory(folder), 1024.0 * 2e6);
}

TEST_F(AvailableMemory, IsNotMoreThanTheGroupsOfTheProcessMayTake) {
  put("proc/meminfo", "MemAvailable:   2000000 kB\n");
  put("proc/self/cgroup", "0::/batch/job 7\n");
  put("sys/fs/cgroup/batch/job 7/memory.max", "max\n");
  put("sys/fs/cgroup/batch/job 7/memory.current", "300000000\n");
  EXPECT_EQ(available_memory(folder), 1024.0 * 2e6) << "without a limit";
  put("sys/fs/cgroup/batch/memory.max", "1000000000\n");
  put("sys/fs/cgroup/batch/memory.current", "400000000\n");
  EXPECT_EQ(available_memory(folder), 6e8) << "that of the group above";
  put("sys/fs/cgroup/batch/memory.stat", "anon 7\ninactive_file 100000000\nactive_file 5\n");
  EXPECT_EQ(available_memory(folder), 7e8) << "cached files make room";
  put("sys/fs/cgroup/batch/job 7/memory.max", "310000000\n");
  EXPECT_EQ(available_memory(folder), 1e7);
  put("sys/fs/cgroup/batch/job 7/memory.max", "100000000\n");
  EXPECT_EQ(available_memory(folder), 0.0) << "a limit below the use";
}

TEST_F(AvailableMemory, KnowsTheFirstVersionOfGroups) {
  put("proc/self/cgroup", "5:memory:/job\n4:cpu,cpuacct:/job\n");
  put("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "9223372036854771712\n");
  put("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "1000\n");
  EXPECT_GT(available_memory(folder), 1e18);
  put("sys/fs/cgroup/memory/memory.limit_in_bytes", "5000\n");
  put("sys/fs/cgroup/memory/memory.usage_in_bytes", "3000\n");
  EXPECT_EQ(available_memory(folder), 2000.0) << "a container sees its group at the root";
}

// The shadow memory of sanitizers keeps this limit too.
TEST_F(AvailableMemory, IsNotMoreThanTheLimitOfTheShell) {
  put("proc/self/statm", "1000 500\n");
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{100000000000000, RLIM_INFINITY};
    if (setrlimit(RLIMIT_AS, &limit) != 0) _exit(2);
    _exit(available_memory(folder) == 1e14 - 1000.0 * static_cast<double>(sysconf(_SC_PAGESIZE)) ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

TEST(MemoryText, IsShort) {
  EXPECT_EQ(memory_text(1.52e9), "1.52 GB");
  EXPECT_EQ(memory_text(2e8), "200 MB");
}

}  // namespace
}  // namespace moat
