#include "launcher/script_build.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "base/text/terminal.hpp"
#include "launcher/compile_errors.hpp"
#include "launcher/process.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

std::string hash_of(const std::string& bytes) {
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016zx", std::hash<std::string>{}(bytes));
  return hash;
}

// <moat.hpp>, precompiled: in a checkout with the library. An installed package has none: it is made at the first
// script, and again after the package or the compiler was installed again; `compile` then gets its folder in front of
// its own. Empty where the compiler makes none.
fs::path precompiled_header(const Places& places, Command& compile) {
  const fs::path of_library = places.build / "script_header" / "moat.hpp.gch";
  if (fs::exists(of_library)) return of_library;
  if (!places.installed()) return {};
  const fs::path folder = places.work / "script_header", header = folder / "moat.hpp.gch", made = folder / "made";
  const auto lock = lock_of(folder / "lock");
  const fs::path launcher = places.build / "bin" / "moat", compiler = compile.front();
  if (std::max(time_of_change(launcher), time_of_change(compiler)) > time_of_change(header)) {
    write_text(folder / "moat.hpp", "#include \"" + (places.root / "src" / "moat.hpp").string() + "\"\n");
    Command command = compile;
    command.insert(command.end(), {"-x", "c++-header", folder / "moat.hpp", "-o", made});
    required_phase(places.log("header"), "header", "moat.hpp, once for all scripts", command);
    fs::rename(made, header);
  }
  compile.insert(compile.begin() + 1, {"-isystem", folder});
  return header;
}

// The files that a script includes, from a rule for make with a line for each: "my\ law.hpp:".
std::vector<fs::path> included_files(const std::string& rule) {
  std::vector<fs::path> files;
  for (const std::string& line : lines_of(rule))
    if (line.ends_with(':'))
      files.emplace_back(
          replaced(replaced(replaced(line.substr(0, line.size() - 1), "\\ ", " "), "\\#", "#"), "$$", "$"));
  return files;
}

}  // namespace

fs::path program_of_script(const Places& places, const fs::path& typed) {
  const fs::path script = fs::canonical(typed),
                 folder = places.work / "scripts" / (script.stem().string().substr(0, 200) + "-" + hash_of(script));
  static std::shared_ptr<void> lock;
  lock.reset();
  lock = lock_of(folder / "lock");
  fs::last_write_time(folder, fs::file_time_type::clock::now());  // when the script was run
  // An installed package can be moved: its words name places by {root}.
  const auto words = [&](const char* file) {
    return lines_of(replaced(text_of(places.build / file), "{root}", places.root.string()));
  };
  Command compile = words("script_compile.txt");
  const fs::path header = precompiled_header(places, compile);
  const fs::path program = folder / "program", made = folder / "made", rule = folder / "rule", hash = folder / "hash";
  compile.insert(compile.end(), {script, "-o", made, "-MMD", "-MP", "-MF", rule});
  for (const std::string& word : words("script_link.txt")) compile.push_back(word);
  compile.insert(compile.begin(), {"env", "LC_ALL=C.UTF-8"});

  // The hash exists where a compilation came to its end, and differs for a damaged program: after a power cut for
  // example.
  const auto hash_now = [&] { return hash_of(joined(compile, "\n") + text_of(rule) + text_of(program)); };
  std::vector<fs::path> files = included_files(text_of(rule));
  files.push_back(script);
  if (!header.empty()) files.push_back(header);
  const bool is_newest = std::ranges::all_of(files, [&, made_at = time_of_change(program)](const fs::path& file) {
    return fs::exists(file) && time_of_change(file) < made_at;
  });
  if (is_newest && text_of(hash) == hash_now()) return program;

  for (const fs::path& file : {hash, program}) fs::remove(file);  // the old program must not run
  const fs::path log = folder / "compile.log";
  const int code = phase(log, "compile", typed.filename().string(), compile);
  const std::string output = replaced(text_of(log), script.string(), typed.string());
  print_text(std::cerr, code == 0 ? with_short_lines(output) : explained(output, places.root));
  if (code != 0) throw Stop{exit_failed, "All that the compiler said: " + log.string()};
  fs::rename(made, program);
  write_text(hash, hash_now());
  run({"find", places.work / "scripts", "-mindepth", "1", "-maxdepth", "1", "-mtime", "+14", "-exec", "rm", "-r", "{}",
       "+"});
  return program;
}

}  // namespace moat::launcher
