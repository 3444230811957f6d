// The options of a script and the line that sets them.
#pragma once

#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
class ParseError;
}  // namespace CLI

namespace moat {

/// CLI11 parses a whole line at once, but a script reads one value after the other. Each value is read by a parser with
/// this one option, which ignores the rest; at the end a parser with all options checks the line.
class CommandLine {
 public:
  CommandLine(int argc, char** argv, std::string title);
  ~CommandLine();

  /// The text given for an option, if any. Throws InputError for a name that no command line can hold, or that is
  /// taken.
  std::optional<std::string> look_up(const std::string& name, const std::string& preset, const std::string& help,
                                     const std::string& type);
  void add_flag(const std::string& name, bool& value, const std::string& help);
  /// Adds --json, which json_wanted() knows from the start.
  void add_json_flag() { add_flag("json", json_, "print one JSON text; all else goes to standard error"); }

  /// Whether -h or --help stands anywhere, also where an option would take it for its value.
  [[nodiscard]] bool help_wanted() const { return help_wanted_; }
  [[nodiscard]] std::string help() const;
  [[nodiscard]] std::string title() const;
  /// Whether --json stands anywhere.
  [[nodiscard]] bool json_wanted() const { return json_wanted_ && !help_wanted_; }
  /// Name of the program, without folder and extension.
  [[nodiscard]] const std::string& program() const { return program_; }
  /// Returns the arguments given to main().
  [[nodiscard]] const std::vector<std::string>& arguments() const { return arguments_; }
  /// Every option looked up so far and every flag that was given, with its value.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& values() const { return known_; }

  /// Checks the whole line and sets the flags; prints the mistake to standard error and returns false if there is one.
  [[nodiscard]] bool parse();

 private:
  void require_new(const std::string& name) const;

  std::unique_ptr<CLI::App> app_;
  std::string program_ = "script";
  std::vector<std::string> arguments_;
  std::list<std::string> texts_;  // CLI11 keeps references to them
  std::vector<std::pair<std::string, bool*>> flags_;
  std::vector<std::pair<std::string, std::string>> known_;
  bool help_wanted_ = false, json_wanted_ = false;
  bool json_ = false;  // of the flag, for the parser
};

/// Lines for standard error that name the mistake in a line that this parser refused. An unknown option is answered
/// with the one that it resembles; `program` names the owner of the options.
std::string usage_error(const CLI::App& parser, const std::string& program, const CLI::ParseError& error);

/// The main() of the program behind `name`, such as "moat report": reads the line, and returns the exit code of `work`,
/// or 1 with its error printed.
int run_command(CLI::App& parser, const std::string& name, int argc, char** argv, const std::function<int()>& work);

}  // namespace moat
