#include "launcher/completion.hpp"

#include <algorithm>

#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

std::string options_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return joined(names);
}

std::string case_of(const std::string& command, const std::string& words, bool files) {
  return "    " + command + ")\n      words=\"" + words + "\"\n" + (files ? "      files=yes\n" : "") + "      ;;\n";
}

}  // namespace

std::string bash_completion(const CLI::App& app, const std::vector<CompletionWords>& more) {
  std::vector<std::string> commands;
  std::string cases;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    const std::string name = command->get_name();
    commands.push_back(name);
    const auto extra = std::ranges::find_if(more, [&](const CompletionWords& each) { return each.command == name; });
    std::string words = options_of(*command);
    if (extra != more.end()) words += " " + joined(extra->words);
    cases += case_of(name, words, extra != more.end() && extra->files);
  }
  return R"(# Completion of the command moat for bash. Put this line into ~/.bashrc:
#   source <(moat completion bash)
_moat() {
  local current=${COMP_WORDS[COMP_CWORD]} words= files=
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W ")" +
         joined(commands) + R"(" -- "$current")
    return
  fi
  case ${COMP_WORDS[1]} in
)" + cases +
         R"(  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  if [[ -n $files ]]; then
    local name
    while IFS= read -r name; do
      [[ ${COMP_WORDS[1]} == run && ! -d $name && $name != *.cpp && $COMP_CWORD == 2 ]] || COMPREPLY+=("$name")
    done < <(compgen -f -- "$current")
    compopt -o filenames 2>/dev/null || true
  fi
}
complete -F _moat moat ./moat
)";
}

}  // namespace moat::launcher
