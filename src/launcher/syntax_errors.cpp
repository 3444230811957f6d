#include "launcher/syntax_errors.hpp"

#include <algorithm>
#include <string>

#include "launcher/designated_list.hpp"
#include "launcher/list_errors.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

bool is_noise(const Diagnostic& error) { return error.text == "missing template arguments before '{' token"; }
bool is_about_syntax(const Diagnostic& error) { return is_noise(error) || error.text.starts_with("expected "); }

}  // namespace

std::optional<Explanation> missing_bracket(const std::vector<ErrorGroup>& groups) {
  const auto syntax =
      std::ranges::find_if(groups, [](const ErrorGroup& group) { return is_about_syntax(group.front()); });
  if (syntax == groups.end()) return {};
  const std::string source = text_of(syntax->front().file);
  const auto wrong = first_wrong_bracket(source);
  if (!wrong) return {};
  const std::string closing = std::string{"'"} + source[wrong->closing] + "'";
  std::string sentence = "this " + closing + " is one too many";
  if (wrong->opening) {
    const std::string type = list_around(source, *wrong->opening + 1).type;
    sentence = std::string{"the '"} + source[*wrong->opening] + "'" + (type.empty() ? "" : " behind " + type) +
               " in line " + std::to_string(line_at(source, *wrong->opening)) + " is not closed before this " +
               closing + ", or this " + closing + " is one too many";
  }
  return at_offset(syntax->front(), source, wrong->closing, 1, sentence);
}

std::vector<ErrorGroup> causes(std::vector<ErrorGroup> groups, bool bracket_is_missing,
                               const std::filesystem::path& root) {
  const auto is_cause = [&](const ErrorGroup& group) {
    return !is_about_syntax(group.front()) || name_of_a_template(group, root);
  };
  if (bracket_is_missing) {
    std::erase_if(groups, [&](const ErrorGroup& group) { return !is_cause(group); });
  } else if (std::ranges::any_of(groups, is_cause)) {
    std::erase_if(groups, [&](const ErrorGroup& group) { return is_noise(group.front()) && !is_cause(group); });
  }
  return groups;
}

}  // namespace moat::launcher
