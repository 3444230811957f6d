#include "app/script/script_origin.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "base/files_read.hpp"
#include "base/sha256.hpp"
#include "base/text/terminal.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// Returns the hash of the library that this program runs with.
std::string hash_of_library() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&sha256_of_file), &info) == 0 || info.dli_fname == nullptr) return "";
  return sha256_of_file(info.dli_fname).value_or("");
}

}  // namespace

Provenance origin_of_script(const std::vector<std::string>& arguments) {
  Provenance origin = provenance_of_library();
  std::error_code error;
  if (const std::string source = variable("MOAT_SCRIPT"); !source.empty()) {
    origin.script = fs::absolute(source, error).string();
    origin.command_line = "moat run " + shell_word(origin.script);
  } else {
    origin.script = fs::read_symlink("/proc/self/exe", error).string();
    origin.command_line = shell_word(origin.script);
  }
  origin.script_sha256 = sha256_of_file(origin.script).value_or("");
  for (const std::string& argument : arguments) origin.command_line += " " + shell_word(argument);
  return origin;
}

std::string command_to_go_on(const std::vector<std::string>& arguments, int ranks) {
  std::error_code error;
  const std::string launcher = variable("MOAT_LAUNCHER"), source = variable("MOAT_SCRIPT");
  const std::string script = source.empty() ? "" : fs::absolute(source, error).string();
  std::string command = "cd " + shell_word(fs::current_path(error).string()) + " && ";
  if (!launcher.empty() && !script.empty()) {
    command += shell_word(launcher) + " run ";
    if (ranks > 0) command += "--ranks " + std::to_string(ranks) + " ";
    command += shell_word(script);
  } else {
    if (!script.empty()) command += "MOAT_SCRIPT=" + shell_word(script) + " ";
    if (ranks > 0) command += "mpirun -n " + std::to_string(ranks) + " ";
    command += shell_word(fs::read_symlink("/proc/self/exe", error).string());
  }
  for (const std::string& argument : arguments)
    if (argument != "--retry" && argument != "--accept-changes") command += " " + shell_word(argument);
  return command;
}

std::string command_to_resume(const std::vector<std::string>& arguments, const fs::path& folder) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& each = arguments[i];
    if (each == "--out") ++i;
    if (each != "--out" && !each.starts_with("--out=") && each != "--force" && each != "--resume")
      others.push_back(each);
  }
  others.insert(others.end(), {"--out", folder.string(), "--resume"});
  return command_to_go_on(others, 0);
}

StudyIdentity identity_of_script(const CommandLine& line, const Provenance& origin,
                                 const std::set<std::string>& left_out) {
  StudyIdentity identity{{"script", origin.script_sha256},
                         {"program", sha256_of_file("/proc/self/exe").value_or("")},
                         {"library", hash_of_library()}};
  for (const auto& [name, value] : line.values()) {
    if (left_out.contains(name)) continue;
    std::error_code none;
    // A folder may have the name of a number or a choice.
    const bool is_path = fs::is_regular_file(value, none) || (value.find('/') != value.npos && fs::exists(value, none));
    const std::string path = fs::absolute(value, none).lexically_normal().string();
    identity["option --" + name] = is_path ? path : value;
    if (const auto hash = sha256_of_file(path)) identity["file " + path] = *hash;
  }
  for (const FileRead& file : files_read_by_program()) identity["file " + file.path] = file.sha256;
  return identity;
}

}  // namespace moat
