#include "launcher/compile_errors.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <regex>

#include "base/nearest_name.hpp"
#include "launcher/compiler_output.hpp"
#include "launcher/dimension_names.hpp"
#include "launcher/explanation.hpp"
#include "launcher/link_errors.hpp"
#include "launcher/list_errors.hpp"
#include "launcher/struct_fields.hpp"
#include "launcher/syntax_errors.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

std::string wrong_type(const Diagnostic& diagnostic, const std::string& is, const std::string& needed) {
  const std::string expression = diagnostic.underlined();
  const std::string wanted = needed_in_words(needed);
  const bool unit_missing = described(is) == "a number without unit" && wanted.find('[') != std::string::npos;
  const bool is_quotable = expression.size() >= 2 && expression.size() <= 50;
  const bool has_fraction = wanted == "a whole number" && is == "double";
  return (is_quotable ? expression : "this") + " is " +
         (has_fraction ? "a number with a decimal point" : described(is)) + ", but " + wanted + " is needed here" +
         (unit_missing ? unit_hint(wanted, is_quotable ? expression : "") : "") +
         (has_fraction ? whole_number_hint(expression) : "");
}

// The text of a struct of the script, of the type "Rubber" or "{anonymous}::Rubber", up to the brace in the first
// column that ends it; empty if the script has no such struct.
std::string struct_in(const std::string& script, const std::string& type) {
  const std::size_t scope = type.rfind("::");
  const std::string name = scope == std::string::npos ? type : type.substr(scope + 2);
  for (const std::string keyword : {"struct ", "class "})
    for (std::size_t begin = script.find(keyword + name); begin != std::string::npos;
         begin = script.find(keyword + name, begin + 1))
      if (const std::string text = script.substr(begin, script.find("\n}", begin) - begin); has_word(text, name))
        return text;
  return "";
}

// "; the law lacks dissipation_rate ..." for a law of the script, of type `given`, in the place of an isolation; empty
// where nothing is missing, or where no part of a law is there.
std::string functions_missing(const Diagnostic& place, const std::string& given, const std::string& needed) {
  if (needed.find("Isolation") == std::string::npos) return "";
  const std::string law = struct_in(text_of(place.file), given);
  constexpr std::array parts{"State", "evaluate", "stored_energy", "dissipation_rate", "linear_stiffness"};
  std::vector<std::string> missing;
  for (const char* part : parts)
    if (!has_word(law, part)) missing.emplace_back(part);
  if (missing.empty() || missing.size() == parts.size()) return "";
  return "; the law lacks " + joined(missing, ", ") + " (docs/guide.md, \"Laws and elements of your own\")";
}

std::string concept_words(const std::string& name) {
  if (name == "ImpactLaw") return "an impact law, such as HertzDamp";
  if (name == "ForceLaw") return "a force law (docs/guide.md, \"Laws and elements of your own\")";
  return described(name);
}

// "; did you mean 'HertzDamp'?" The compiler's own suggestion may be a function of C that nobody means: modfl for
// model.
std::string known_name_like(const std::string& name, const std::string& suggestion, const Diagnostic& place,
                            const fs::path& root) {
  std::string known = suggestion;
  const bool is_known = suggestion.find("::") != std::string::npos || has_word(text_of(place.file), suggestion) ||
                        is_in_headers(suggestion, root);
  if (!is_known)
    known = std::isupper(static_cast<unsigned char>(name.front())) != 0 ? nearest_name(names_of_types(root), name) : "";
  return known.empty() ? "" : "; did you mean '" + known + "'?";
}

Explanation at_value(const std::smatch& match, const Diagnostic& place, const fs::path& /*root*/) {
  return at(place, wrong_type(place, match[1], match[2]) + functions_missing(place, match[1], match[2]));
}

using Rule = Explanation (*)(const std::smatch&, const Diagnostic&, const fs::path& root);
struct Pattern {
  std::regex text;
  Rule explain;
};

// The first that fits any diagnostic of a group explains it.
const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> all{
      {std::regex{R"(designator order for field '(.*)::(\w+)' does not match declaration order.*)"},
       [](const std::smatch& match, const Diagnostic& place, const fs::path& root) {
         const std::string type = plain_name(match[1], root);
         return at_field(place, match[2], wrong_place(type, match[2], fields_of(type, root)));
       }},
      {std::regex{R"('(.*)' has no non-static data member named '(\w+)')"},
       [](const std::smatch& match, const Diagnostic& place, const fs::path& root) {
         const std::string type = plain_name(match[1], root);
         return at_field(place, match[2], no_such_field(type, match[2], fields_of(type, root)));
       }},
      {std::regex{R"(missing initializer for member '(.*)::(\w+)'.*)"},
       [](const std::smatch& match, const Diagnostic& place, const fs::path& root) {
         return at(place, "field " + match[2].str() + " of " + plain_name(match[1], root) + " is missing");
       }},
      {std::regex{R"(\s*cannot convert '.*' \(type '(.*)'\) to type '(.*)')"}, at_value},
      {std::regex{R"(could not convert '.*' from '(.*)' to '(.*)')"}, at_value},
      {std::regex{R"(cannot convert '([^<'][^']*)' to '(?:const )?([^'&]*)&*'.*)"}, at_value},
      {std::regex{R"(conversion from '(.*)' to non-scalar type '([^']*)'.* requested)"}, at_value},
      {std::regex{R"('(\w+)' (was not declared in this scope|does not name a type)(?:; did you mean '(.*)'\?)?)"},
       [](const std::smatch& match, const Diagnostic& place, const fs::path& root) {
         return at(place,
                   "'" + match[1].str() + "' " + match[2].str() + known_name_like(match[1], match[3], place, root));
       }},
      {std::regex{R"(no matching function for call to '(?:moat::)?Script::run\(.*)"},
       [](const std::smatch&, const Diagnostic& place, const fs::path&) {
         return at(
             place,
             "this call of Script::run does not fit: it takes the model, the motion (of a file: "
             "read_motion(\"record.AT2\")), then options by their names, as in {.step = 1 * ms}, and observers by "
             "their addresses, as in {&drift}");
       }},
      {std::regex{R"(use of deleted function '.*Required<T>::Required\(\) \[with T = (.*)\]')"},
       [](const std::smatch& match, const Diagnostic& place, const fs::path&) {
         return at(place, "a required field is missing: " + described(match[1]));
       }},
  };
  return all;
}

// `Moat{...}` without a law, or with something else in its place.
std::optional<Explanation> failed_deduction(const ErrorGroup& group, const fs::path& root) {
  static const std::regex call{R"(no matching function for call to '(\w+)\(.*)"};
  static const std::regex concepts{R"(.*required for the satisfaction of '(\w+)<\w+>' \[with \w+ = (.*)\])"};
  const std::string missing = field_not_deduced(group);
  std::string type;
  for (const Diagnostic& each : group) {
    std::smatch match;
    if (matches(each.text, match, call)) type = match[1];
    if (!type.empty() && !missing.empty() && !names_field(group.front(), missing))
      return at(group.front(), "field " + missing + " of " + type + " is missing");
    for (const std::string& line : each.before)
      if (matches(line, match, concepts) && !type.empty())
        return at(group.front(),
                  type + " needs " + concept_words(match[1]) + "; " + plain_name(match[2], root) + " is none");
  }
  return {};
}

// An object of a type that lacks a function of its interface.
std::optional<Explanation> function_of_interface_missing(const ErrorGroup& group) {
  static const std::regex abstract{R"(.*abstract (?:class )?type '(.*)')"};
  static const std::regex function{R"(\s*'virtual .*?(\w+)::(\w+)\(.*)"};
  std::smatch match;
  const std::string text = with_dimension_names(group.front().text);
  if (!matches(text, match, abstract)) return {};
  const std::string type = match[1];
  std::string interface;
  std::vector<std::string> missing;
  for (const Diagnostic& each : group)
    if (matches(each.text, match, function)) {
      interface = match[1];
      missing.push_back(match[2]);
    }
  if (missing.empty()) return {};
  return at(group.front(), type + " lacks " + joined(missing, " and ") + "() of " + interface +
                               "; a function with other parameters, or without const, is another one");
}

std::optional<Explanation> explanation_of(const ErrorGroup& group, const fs::path& root) {
  if (auto known = function_of_interface_missing(group)) return known;
  for (const auto rule :
       {name_of_a_template, list_in_a_call, list_in_overloaded_call, list_without_type, list_for_storeys})
    if (auto known = rule(group, root)) return known;
  for (const Pattern& pattern : patterns())
    for (const Diagnostic& each : group) {
      const std::string text = without_second_names(each.text);
      std::smatch match;
      if (matches(text, match, pattern.text)) return pattern.explain(match, each, root);
    }
  if (auto known = failed_deduction(group, root)) return known;
  return wrong_field_of_template(group, root);
}

// With names of dimensions, and without a second name that is the same then.
std::string in_words(const std::string& text) {
  static const std::regex same{R"('([^']*)' \{aka '(?:const )?\1'\})"};
  return replaced(with_dimension_names(text), same, "'$1'");
}

// In the compiler's words. An error inside a header says by "required from here" which line of the script it is about.
std::string quoted(const Diagnostic& error, const std::string& script) {
  std::string text;
  if (error.file != script)
    for (const std::string& line : error.before) text += in_words(line) + "\n";
  return text + error.file + ":" + std::to_string(error.line) + ": " + in_words(error.text) + "\n" + snippet_of(error);
}

std::string message_of(const Explanation& explanation) {
  return explanation.file + ":" + std::to_string(explanation.line) + ": " + explanation.sentence + "\n" +
         explanation.snippet;
}

}  // namespace

std::string explained(const std::string& output, const std::string& script, const fs::path& root) {
  constexpr std::size_t most_errors = 5;
  const std::vector<ErrorGroup> all = error_groups(output, script);
  if (all.empty()) return with_short_lines(link_explanation(output, script) + output);
  const auto bracket = missing_bracket(all);
  const std::vector<ErrorGroup> groups = causes(all, bracket.has_value(), root);
  std::string text = bracket ? message_of(*bracket) : "";
  for (std::size_t i = 0; i < std::min(most_errors, groups.size()); ++i) {
    if (const auto known = explanation_of(groups[i], root))
      text += message_of(*known);
    else
      text += quoted(groups[i].front(), script);
  }
  if (groups.size() > most_errors) text += "... and " + std::to_string(groups.size() - most_errors) + " more errors\n";
  return with_short_lines(text);
}

}  // namespace moat::launcher
