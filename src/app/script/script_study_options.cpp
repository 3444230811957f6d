#include "app/script/script_study_options.hpp"

#include <charconv>
#include <string_view>

#include "base/error.hpp"

namespace moat {
namespace {

std::size_t whole_number(std::string_view text, const std::string& option, const std::string& whole) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw InputError{option + ": \"" + whole + "\" is not allowed. Write --case 17, or --cases 0:100 for 0 to 99."};
  return value;
}

int threads_of(const std::string& text) {
  constexpr int most = 1024;
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0 || value > most)
    throw InputError{"--threads: \"" + text + "\" is not allowed; it must be a whole number from 0 to " +
                     std::to_string(most) + ". 0 takes one thread per core."};
  return value;
}

std::optional<std::pair<std::size_t, std::size_t>> part_of(const std::optional<std::string>& one,
                                                           const std::optional<std::string>& several) {
  if (one && several) throw InputError{"--case and --cases: give one of them."};
  if (one) {
    const std::size_t number = whole_number(*one, "--case", *one);
    return {{number, number + 1}};
  }
  if (!several) return std::nullopt;
  const std::size_t colon = several->find(':');
  if (colon == std::string::npos) whole_number("", "--cases", *several);
  const std::string_view text{*several};
  return {{whole_number(text.substr(0, colon), "--cases", *several),
           whole_number(text.substr(colon + 1), "--cases", *several)}};
}

}  // namespace

ScriptStudyOptions::ScriptStudyOptions(CommandLine& line) {
  const std::filesystem::path preset = std::filesystem::path{"results"} / line.program();
  folder = line.look_up("out", preset.string(), "results folder; a study that is there goes on", "FOLDER")
               .value_or(preset.string());
  if (folder.empty())
    throw InputError{"--out: the name of the folder is empty. Give one, for example " + preset.string() + "."};
  const auto thread_count = line.look_up("threads", "0", "that compute cases; 0: one per core", "INTEGER");
  const auto one = line.look_up("case", "", "compute this case alone, counted from 0, into a file of its own", "N");
  const auto several = line.look_up("cases", "", "compute the cases A to B - 1 alone, into a file of their own", "A:B");
  line.add_flag("retry", retry, "compute cases that failed, did not converge or were damaged once more");
  line.add_flag("accept-changes", accept_changes,
                "go on although script, library, options or records changed; earlier cases stay as they are");
  line.add_flag("quiet", quiet, "print answers, warnings and errors only");
  line.add_json_flag();
  if (thread_count) threads = threads_of(*thread_count);
  part = part_of(one, several);
}

}  // namespace moat
