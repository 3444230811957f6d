#include "launcher/compile_errors.hpp"

#include <optional>
#include <regex>

#include "launcher/compiler_output.hpp"
#include "launcher/dimension_names.hpp"
#include "launcher/struct_fields.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

// A sentence, and the diagnostic whose line of the source shows the place.
struct Explanation {
  std::string sentence;
  const Diagnostic* place;
};

// "moat::Moat<moat::HertzDamp>" -> "Moat"
std::string plain_name(const std::string& type) {
  const std::string name = with_dimension_names(type);
  return name.substr(0, name.find('<'));
}

std::string fields_in_order(const std::string& type, const fs::path& root) {
  const std::vector<std::string> fields = fields_of(type, root);
  return fields.empty() ? "" : ": " + joined(fields, ", ");
}

std::string wrong_type(const Diagnostic& diagnostic, const std::string& is, const std::string& needed) {
  static const std::regex standard{R"(std::optional<(.*)>)"};
  const std::string expression = diagnostic.underlined();
  const std::string wanted = described(std::regex_replace(needed, standard, "$1"));
  const bool unit_missing = described(is) == "a number without unit" && wanted.find('[') != std::string::npos;
  return (expression.size() < 2 || expression.size() > 50 ? "this" : expression) + " is " + described(is) + ", but " +
         wanted + " is needed here" + (unit_missing ? "; give it a unit, as in 10 * cm" : "");
}

std::string concept_words(const std::string& name) {
  if (name == "ImpactLaw") return "an impact law, such as HertzDamp";
  if (name == "ForceLaw") return "a force law (docs/guide.md, \"Laws and elements of your own\")";
  return described(name);
}

using Rule = std::optional<std::string> (*)(const std::smatch&, const Diagnostic&, const fs::path& root);
struct Pattern {
  std::regex text;
  Rule sentence;
};

// The first that fits any diagnostic of a group explains it.
const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> all{
      {std::regex{R"(designator order for field '(.*)::(\w+)' does not match declaration order.*)"},
       [](const std::smatch& match, const Diagnostic&, const fs::path& root) -> std::optional<std::string> {
         const std::string type = plain_name(match[1]);
         return "field " + match[2].str() + " of " + type + " stands in the wrong place; the order is" +
                (fields_in_order(type, root).empty() ? " that of the struct" : fields_in_order(type, root));
       }},
      {std::regex{R"('(.*)' has no non-static data member named '(\w+)')"},
       [](const std::smatch& match, const Diagnostic&, const fs::path& root) -> std::optional<std::string> {
         const std::string type = plain_name(match[1]);
         const std::vector<std::string> fields = fields_of(type, root);
         const std::string nearest = nearest_field(fields, match[2]);
         return type + " has no field " + match[2].str() +
                (nearest.empty() ? fields.empty() ? "" : "; it has " + joined(fields, ", ")
                                 : "; did you mean " + nearest + "?");
       }},
      {std::regex{R"(missing initializer for member '(.*)::(\w+)'.*)"},
       [](const std::smatch& match, const Diagnostic&, const fs::path&) -> std::optional<std::string> {
         return "field " + match[2].str() + " of " + plain_name(match[1]) + " is missing";
       }},
      {std::regex{R"(\s*cannot convert '.*' \(type '(.*)'\) to type '(.*)')"},
       [](const std::smatch& match, const Diagnostic& diagnostic, const fs::path&) -> std::optional<std::string> {
         return wrong_type(diagnostic, match[1], match[2]);
       }},
      {std::regex{R"(could not convert '.*' from '(.*)' to '(.*)')"},
       [](const std::smatch& match, const Diagnostic& diagnostic, const fs::path&) -> std::optional<std::string> {
         return wrong_type(diagnostic, match[1], match[2]);
       }},
  };
  return all;
}

// `Moat{...}` without a law, or with something else in its place.
std::optional<Explanation> failed_deduction(const ErrorGroup& group) {
  static const std::regex call{R"(no matching function for call to '(\w+)\(.*)"};
  static const std::regex missing{R"(\s*couldn't deduce template parameter '(\w+)')"};
  static const std::regex concepts{R"(.*required for the satisfaction of '(\w+)<\w+>' \[with \w+ = (.*)\])"};
  std::string type;
  for (const Diagnostic& each : group) {
    std::smatch match;
    if (std::regex_match(each.text, match, call)) type = match[1];
    if (std::regex_match(each.text, match, missing) && !type.empty())
      return Explanation{"field " + std::string(1, static_cast<char>(std::tolower(match[1].str().front()))) +
                             match[1].str().substr(1) + " of " + type + " is missing",
                         &group.front()};
    for (const std::string& line : each.before)
      if (std::regex_match(line, match, concepts) && !type.empty())
        return Explanation{type + " needs " + concept_words(match[1]) + "; " + plain_name(match[2]) + " is none",
                           &group.front()};
  }
  return {};
}

std::optional<Explanation> explanation_of(const ErrorGroup& group, const fs::path& root) {
  for (const Pattern& pattern : patterns())
    for (const Diagnostic& each : group) {
      std::smatch match;
      if (!std::regex_match(each.text, match, pattern.text)) continue;
      if (const auto sentence = pattern.sentence(match, each, root)) return Explanation{*sentence, &each};
    }
  return failed_deduction(group);
}

std::string snippet_of(const Diagnostic& place) {
  constexpr std::size_t source_and_marks = 2;
  std::string text;
  for (std::size_t i = 0; i < std::min(source_and_marks, place.snippet.size()); ++i) text += place.snippet[i] + "\n";
  return text;
}

// In the compiler's words. An error inside a header says by "required from here" which line of the script it is about.
std::string quoted(const Diagnostic& error, const std::string& script) {
  std::string text;
  if (error.file != script)
    for (const std::string& line : error.before) text += with_dimension_names(line) + "\n";
  return text + error.file + ":" + std::to_string(error.line) + ": " + with_dimension_names(error.text) + "\n" +
         snippet_of(error);
}

}  // namespace

std::string explained(const std::string& output, const std::string& script, const fs::path& root) {
  constexpr std::size_t most_errors = 5;
  const std::vector<ErrorGroup> groups = error_groups(output, script);
  if (groups.empty()) return output;  // from the linker, for example
  std::string text;
  for (std::size_t i = 0; i < std::min(most_errors, groups.size()); ++i) {
    const auto explanation = explanation_of(groups[i], root);
    if (explanation)
      text += explanation->place->file + ":" + std::to_string(explanation->place->line) + ": " + explanation->sentence +
              "\n" + snippet_of(*explanation->place);
    else
      text += quoted(groups[i].front(), script);
  }
  if (groups.size() > most_errors) text += "... and " + std::to_string(groups.size() - most_errors) + " more errors\n";
  return text;
}

}  // namespace moat::launcher
