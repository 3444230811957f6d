// Compiles an input script with Ninja.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "launcher/places.hpp"

namespace moat::launcher {

/// The build file for one script: text for Ninja, with the program's name, `program`, as its one target.
///
/// The compiler reports the files that the script includes, and Ninja keeps the list. A change of the compiler's
/// words counts as a change as well. Diagnostics go to the file `diagnostics`.
struct ScriptRule {
  /// The compiler with its options, and the arguments behind the name of the script.
  std::vector<std::string> compile, link;
  std::filesystem::path script;
  /// A newer one makes the program out of date. Empty: there is none.
  std::filesystem::path precompiled_header;
};
std::string ninja_file(const ScriptRule& rule);

/// A script and the folder that its program is kept in: <work>/scripts/<name>-<hash of its path>.
class ScriptBuild {
 public:
  /// `typed` is the script's name as the user gave it. Throws Stop for a name with a control character, or a
  /// name that is too long.
  ScriptBuild(const Places& places, const std::filesystem::path& typed);

  /// Compiles if the script, a file it includes or the library's headers have changed. Warnings and errors go to
  /// standard error, explained by compile_errors.hpp. Throws Stop if the script does not compile.
  void bring_up_to_date() const;

  [[nodiscard]] std::filesystem::path program() const { return folder_ / "program"; }
  [[nodiscard]] std::filesystem::path lock_file() const { return folder_ / "lock"; }

 private:
  // Whether the program is whole and no file that it was made of has changed since.
  [[nodiscard]] bool is_newer_than_its_files(const std::filesystem::path& precompiled_header) const;
  // The files that a program was made of, and at its end the hash of the program, which damage changes: a power cut for
  // example. It exists where the compilation came to its end, and saves the next start a call of Ninja.
  [[nodiscard]] std::filesystem::path list_of_files() const { return folder_ / "files"; }
  void keep_list_of_files() const;
  [[noreturn]] void fail() const;

  Places places_;
  std::filesystem::path typed_, script_, folder_;
};

}  // namespace moat::launcher
