#include "app/script/script_identity.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <map>

#include "app/script/script_study_options.hpp"
#include "base/files_read.hpp"
#include "base/sha256.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

/// Returns the hash of the library that this program runs with.
std::string hash_of_library() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&sha256_of_file), &info) == 0 || info.dli_fname == nullptr) return "";
  return sha256_of_file(info.dli_fname).value_or("");
}

}  // namespace

StudyIdentity identity_of_script(const CommandLine& line, const Provenance& origin) {
  std::map<std::string, std::string> identity{{"script", origin.script_sha256},
                                              {"program", sha256_of_file("/proc/self/exe").value_or("")},
                                              {"library", hash_of_library()}};
  for (const auto& [name, value] : line.values()) {
    if (!ScriptStudyOptions::has_influence(name)) continue;
    std::error_code none;
    const bool is_path = fs::exists(value, none);
    const std::string path = fs::absolute(value, none).lexically_normal().string();
    identity["option --" + name] = is_path ? path : value;
    if (const auto hash = sha256_of_file(path)) identity["file " + path] = *hash;
  }
  for (const FileRead& file : files_read_by_program()) identity["file " + file.path] = file.sha256;
  return {identity.begin(), identity.end()};
}

}  // namespace moat
