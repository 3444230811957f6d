#include "launcher/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "launcher/stop.hpp"

extern char** environ;

namespace moat::launcher {
namespace {

std::vector<char*> argument_list(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

// A file descriptor that is closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_{descriptor} {}
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return descriptor_; }

 private:
  int descriptor_;
};

constexpr int inherited = -1;

// Descriptors for standard output and error; inherited leaves all three as they are.
int run_with(Command words, int output, int errors) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (output != inherited) {
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  }
  const std::vector<char*> list = argument_list(words);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, list.front(), &actions, nullptr, list.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return 127;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

int run(const Command& command) { return run_with(command, inherited, inherited); }

int run_into(const std::filesystem::path& log, const Command& command) {
  std::filesystem::create_directories(log.parent_path());
  const Descriptor file{::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)};
  if (file.get() < 0) throw Stop{exit_failed, log.string() + " cannot be written."};
  return run_with(command, file.get(), file.get());
}

Output output_of(const Command& command) {
  const Descriptor file{::memfd_create("output", MFD_CLOEXEC)}, nowhere{::open("/dev/null", O_WRONLY | O_CLOEXEC)};
  Output output{.exit_code = run_with(command, file.get(), nowhere.get()), .text = {}};
  output.text.resize(static_cast<std::size_t>(::lseek(file.get(), 0, SEEK_END)));
  if (::pread(file.get(), output.text.data(), output.text.size(), 0) < 0) output.text.clear();
  return output;
}

void prefer_large_pages() {
  // Memory is taken from the system in pieces of 64 MiB, and up to 1 GiB of free memory is kept: pages that are taken
  // again are cleared again. Single pieces from 32 MiB on go back.
  ::setenv("GLIBC_TUNABLES",
           "glibc.malloc.hugetlb=1:glibc.malloc.top_pad=67108864:glibc.malloc.trim_threshold=1073741824:"
           "glibc.malloc.mmap_threshold=33554432",
           0);
}

int become(const std::filesystem::path& program, const std::string& name, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{name};
  words.insert(words.end(), arguments.begin(), arguments.end());
  prefer_large_pages();
  ::execv(program.c_str(), argument_list(words).data());
  return errno;
}

}  // namespace moat::launcher
