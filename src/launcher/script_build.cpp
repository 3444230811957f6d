#include "launcher/script_build.hpp"

#include <algorithm>
#include <chrono>
#include <climits>
#include <cstdio>
#include <functional>
#include <iostream>

#include "base/terminal.hpp"
#include "launcher/compile_errors.hpp"
#include "launcher/phase.hpp"
#include "launcher/process.hpp"
#include "launcher/script_header.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"
#include "launcher/time_of_change.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

// In the value of a variable nothing else has a meaning.
std::string ninja_value(const std::string& text) { return replaced(text, "$", "$$"); }

std::string ninja_words(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(shell_quoted(word));
  return ninja_value(joined(quoted));
}

std::string hash_of(const std::string& bytes) {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016zx", std::hash<std::string>{}(bytes));
  return hash;
}

// Folders of scripts that were not run for two weeks.
void remove_unused(const fs::path& scripts) {
  const auto oldest = fs::file_time_type::clock::now() - std::chrono::hours{14 * 24};
  std::error_code ignored;
  std::vector<fs::path> unused;
  for (const auto& entry : fs::directory_iterator{scripts, ignored})
    if (const fs::path used = entry.path() / "build.ninja"; !fs::exists(used) || fs::last_write_time(used) < oldest)
      unused.push_back(entry.path());
  for (const fs::path& folder : unused) fs::remove_all(folder, ignored);
}

}  // namespace

std::string ninja_file(const ScriptRule& rule) {
  return "rule script\n"
         "  command = LC_ALL=C.UTF-8 " +
         ninja_words(rule.compile) + " $in -o $out.new -MMD -MF $out.d " + ninja_words(rule.link) +
         " 2> diagnostics && sync $out.new && mv $out.new $out\n"
         "  depfile = $out.d\n"
         "  deps = gcc\n"
         "source = " +
         ninja_value(rule.script) +
         "\n"
         "header = " +
         ninja_value(rule.precompiled_header) +
         "\n"
         "build program: script $source" +
         (rule.precompiled_header.empty() ? "" : " | $header") + "\n";
}

ScriptBuild::ScriptBuild(const Places& places, const fs::path& typed)
    : places_{places}, typed_{typed}, script_{fs::canonical(typed)} {
  const std::string path = script_.string();
  if (std::any_of(path.begin(), path.end(), [](unsigned char c) { return c < ' ' || c == 127; }))
    throw Stop{exit_usage,
               "The name of a script and of its folders must not hold line breaks, tabs or other control characters.\n"
               "Rename it: " +
                   replaced(replaced(path, "\n", "\\n"), "\t", "\\t")};
  const std::string name = script_.stem().string() + "-" + hash_of(path);
  if (name.size() > NAME_MAX)
    throw Stop{exit_usage, "The name of the script is too long, by " + std::to_string(name.size() - NAME_MAX) +
                               " bytes. Give it a shorter one: " + path};
  folder_ = places_.scripts() / name;
}

bool ScriptBuild::is_newer_than_its_files(const fs::path& precompiled_header) const {
  std::vector<fs::path> files{script_};
  if (!precompiled_header.empty()) files.push_back(precompiled_header);
  const std::vector<std::string> included = lines_of(text_of(list_of_files()));
  if (included.size() < 2 || included.back() != hash_of(text_of(program()))) return false;
  files.insert(files.end(), included.begin(), included.end() - 1);
  return std::ranges::none_of(files, [&](const fs::path& file) { return changed_after(file, program()); });
}

void ScriptBuild::keep_list_of_files() const {
  // "program: #deps 3, deps mtime 1700000000 (VALID)", and behind it one indented line for each file.
  std::string files;
  for (const std::string& line : lines_of(output_of({MOAT_NINJA, "-C", folder_, "-t", "deps", "program"}).text))
    if (line.starts_with("    ")) files += line.substr(4) + "\n";
  write_text(list_of_files(), files + hash_of(text_of(program())) + "\n");
}

void ScriptBuild::bring_up_to_date() const {
  // An installed package can be moved: its words name places by {root}.
  const auto words = [&](const char* file) {
    return lines_of(replaced(text_of(places_.build / file), "{root}", places_.root.string()));
  };
  ScriptRule rule{.compile = words("script_compile.txt"),
                  .link = words("script_link.txt"),
                  .script = script_,
                  .precompiled_header = {}};
  rule.precompiled_header = precompiled_header(places_, rule.compile);
  fs::create_directories(folder_);
  const std::string words_before = text_of(folder_ / "build.ninja"), words_now = ninja_file(rule);
  write_text(folder_ / "build.ninja", words_now);  // its date says when the script was run
  if (words_now == words_before && is_newer_than_its_files(rule.precompiled_header)) return;
  // Ninja compares dates of writing, which moving and copying a file keep: without a program it must build.
  fs::remove(program());
  fs::remove(list_of_files());
  fs::remove(folder_ / "diagnostics");
  const int code = phase(places_.logs(), "compile", typed_.filename().string(), {MOAT_NINJA, "-C", folder_, "program"});
  if (code != 0) fail();
  keep_list_of_files();
  if (!fs::exists(folder_ / "diagnostics")) return;
  const std::string warnings = replaced(text_of(folder_ / "diagnostics"), script_.string(), typed_.string());
  print_text(std::cerr, with_short_lines(warnings));
  remove_unused(places_.scripts());
}

void ScriptBuild::fail() const {
  const fs::path log = places_.logs() / "compile.log";
  const std::string diagnostics = text_of(folder_ / "diagnostics");
  if (diagnostics.empty()) throw Stop{exit_failed, text_of(log) + "The whole log: " + log.string()};
  write_text(log, diagnostics);
  print_text(std::cerr,
             explained(replaced(diagnostics, script_.string(), typed_.string()), typed_.string(), places_.root));
  throw Stop{exit_failed, "All that the compiler said: " + log.string()};
}

}  // namespace moat::launcher
