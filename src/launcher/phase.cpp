#include "launcher/phase.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <future>
#include <iostream>

#include "base/terminal.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"
#include "launcher/without_progress.hpp"

namespace moat::launcher {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// The line of one phase. On a terminal it is written again with the seconds that have passed.
class ProgressLine {
 public:
  ProgressLine(const std::string& name, const std::string& detail) {
    line_ =
        "moat: " + name + std::string(name.size() < 9 ? 9 - name.size() : 0, ' ') + " " + printable(detail) + " ... ";
  }
  void show() {
    if (!shown_ || ::isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "%s%s", shown_ ? "\r" : "", line_.c_str());
    if (shown_ && ::isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "%.0f s ", seconds());
    shown_ = true;
  }
  void end(int exit_code) {
    if (!shown_ && exit_code == 0) return;
    show();
    std::fprintf(stderr, "%s%s%.1f s\n", ::isatty(STDERR_FILENO) != 0 ? ("\r" + line_).c_str() : "",
                 exit_code == 0 ? "" : "FAILED after ", seconds());
  }

 private:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  Clock::time_point start_ = Clock::now();
  std::string line_;
  bool shown_ = false;
};

std::string end_of(const std::string& text) {
  constexpr std::size_t most_lines = 25;
  const std::vector<std::string> lines = lines_of(text);
  std::string end;
  for (std::size_t i = lines.size() < most_lines ? 0 : lines.size() - most_lines; i < lines.size(); ++i)
    end += "    " + lines[i] + "\n";
  return end;
}

}  // namespace

void say(const std::string& line) { print_text(std::cerr, "moat: " + line + "\n"); }

int phase(const std::filesystem::path& logs, const std::string& name, const std::string& detail,
          const Command& command) {
  ProgressLine line{name, detail};
  auto exit_code = std::async(std::launch::async, [&] { return run_into(logs / (name + ".log"), command); });
  for (auto patience = 300ms; exit_code.wait_for(patience) != std::future_status::ready; patience = 1000ms) line.show();
  const int code = exit_code.get();
  line.end(code);
  return code;
}

void required_phase(const std::filesystem::path& logs, const std::string& name, const std::string& detail,
                    const Command& command) {
  if (phase(logs, name, detail, command) == 0) return;
  const std::filesystem::path log = logs / (name + ".log");
  print_text(std::cerr, end_of(without_progress(text_of(log))));
  throw Stop{exit_failed, "The whole log: " + log.string()};
}

}  // namespace moat::launcher
