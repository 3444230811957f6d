#include "app/script_origin.hpp"

#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "base/sha256.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

// So that a shell reads it as one word.
std::string shell_word(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return text + "'";
}

}  // namespace

Provenance origin_of_script(const std::vector<std::string>& arguments) {
  Provenance origin = provenance_of_library();
  std::error_code error;
  const char* source = std::getenv("MOAT_SCRIPT");
  if (source != nullptr && *source != '\0') {
    const fs::path path = fs::absolute(source, error);
    origin.script = path.string();
    origin.script_sha256 = sha256_of_file(path).value_or("");
    origin.command_line = "moat run " + shell_word(origin.script);
  } else {
    origin.script = fs::read_symlink("/proc/self/exe", error).string();
    origin.command_line = shell_word(origin.script);
  }
  for (const std::string& argument : arguments) origin.command_line += " " + shell_word(argument);
  return origin;
}

}  // namespace moat
