#include "launcher/list_errors.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <regex>
#include <string_view>
#include <utility>

#include "launcher/designated_list.hpp"
#include "launcher/dimension_names.hpp"
#include "launcher/misfit.hpp"
#include "launcher/struct_fields.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

// The first field that the type does not have, or that stands in the wrong place.
std::optional<Explanation> wrong_field(const Diagnostic& place, const std::string& source, const DesignatedList& list,
                                       const std::string& type, const std::filesystem::path& root) {
  const std::vector<std::string> fields = fields_of(type, root);
  if (fields.empty()) return {};
  auto last = fields.begin();
  for (const NamedField& each : list.fields) {
    const auto found = std::ranges::find(fields, each.name);
    if (found == fields.end()) return at_field(place, source, each, no_such_field(type, each.name, fields));
    if (found < last) return at_field(place, source, each, wrong_place(type, each.name, fields));
    last = found;
  }
  return {};
}

// Also in lists inside the list: `{.transient = {.step = 0.01}}`.
std::optional<Explanation> wrong_value(const Diagnostic& place, const std::string& source, const DesignatedList& list,
                                       const std::string& type, const std::filesystem::path& root) {
  if (auto wrong = wrong_field(place, source, list, type, root)) return wrong;
  const std::vector<Field> fields = declared_fields(type, root);
  for (const NamedField& each : list.fields) {
    const auto field = std::ranges::find(fields, each.name, &Field::name);
    if (field == fields.end()) continue;
    if (const std::string text = misfit_of_field(each, type, field->type); !text.empty())
      return at_field(place, source, each, text);
    if (!each.value.starts_with('{')) continue;
    const DesignatedList inside = list_around(source, source.find('{', each.offset) + 1);
    if (auto wrong = wrong_value(place, source, inside, field->type, root)) return wrong;
  }
  return {};
}

// The value of a list that is wrong, or the types that its fields need.
std::optional<Explanation> reason_in_list(const Diagnostic& place, const std::string& source,
                                          const DesignatedList& list, const std::string& type,
                                          const std::filesystem::path& root) {
  const std::vector<Field> fields = declared_fields(type, root);
  if (fields.empty() || list.fields.empty()) return {};
  if (auto wrong = wrong_value(place, source, list, type, root)) return wrong;
  std::vector<std::string> needs;
  for (const NamedField& each : list.fields)
    needs.push_back(each.name + " is " + needed_in_words(std::ranges::find(fields, each.name, &Field::name)->type));
  return at_field(place, source, list.fields.front(),
                  "a value does not fit its field of " + type + ": " + joined(needs, ", "));
}

// "field law of Moat needs the name of a type in front of the braces, as in .law = HertzDamp{...}"
std::string type_missing(const NamedField& field, const std::string& type, const std::string& needed) {
  static const std::array<std::pair<std::string_view, std::string_view>, 6> examples{
      {{"ImpactLaw", "HertzDamp"},
       {"ForceLaw", "Linear"},
       {"PlanarLaw", "BiaxialBilinear"},
       {"Isolation", "LeadRubberBearing"},
       {"StoreyLaw", "YieldingStorey"},
       {"Friction", "VelocityDependent"}}};
  std::string example;
  for (const auto& [of, name] : examples)
    if (of == needed) example = ", as in ." + field.name + " = " + std::string{name} + "{...}";
  return "field " + field.name + (type.empty() ? "" : " of " + type) +
         " needs the name of a type in front of the braces" + example;
}

// The type of a list that the compiler tried for an argument in braces. Of several, the one with the most of its names.
std::string type_of_argument(const ErrorGroup& group, const DesignatedList& list, const std::filesystem::path& root) {
  static const std::regex tried{
      R"(\s*no known conversion for argument \d+ from '<brace-enclosed initializer list>' to '(?:const )?([^'&]*)&?')"};
  std::string best;
  std::ptrdiff_t most = -1;
  for (const Diagnostic& each : group) {
    std::smatch match;
    const std::string text = without_second_names(each.text);
    if (!matches(text, match, tried)) continue;
    const std::string type = plain_name(match[1], root);
    const std::vector<std::string> fields = fields_of(type, root);
    const auto named = std::ranges::count_if(
        list.fields, [&](const NamedField& field) { return std::ranges::find(fields, field.name) != fields.end(); });
    if (!fields.empty() && named > most) {
      most = named;
      best = type;
    }
  }
  return best;
}

}  // namespace

std::string field_not_deduced(const ErrorGroup& group) {
  static const std::regex parameter{R"(\s*couldn't deduce template parameter '(\w+)')"};
  if (!group.front().text.starts_with("class template argument deduction failed")) return {};
  for (const Diagnostic& each : group)
    if (std::smatch match; matches(each.text, match, parameter)) return lower_case(match[1]);
  return {};
}

std::optional<Explanation> wrong_field_of_template(const ErrorGroup& group, const std::filesystem::path& root) {
  const Diagnostic& place = group.front();
  if (!place.text.starts_with("class template argument deduction failed")) return {};
  const std::string source = text_of(place.file);
  const DesignatedList list = list_around(source, offset_of(source, place.line, place.column));
  return wrong_field(place, source, list, list.type, root);
}

std::optional<Explanation> name_of_a_template(const ErrorGroup& group, const std::filesystem::path& root) {
  const Diagnostic& place = group.front();
  const bool at_brace = place.text == "missing template arguments before '{' token";
  if (!at_brace && !place.text.ends_with("used without template arguments")) return {};
  const std::string source = text_of(place.file);
  const DesignatedList list = list_around(source, offset_of(source, place.line, place.column) + (at_brace ? 1 : 0));
  const std::vector<Field> fields = declared_fields(list.type, root);
  for (const NamedField& each : list.fields) {
    const std::string front = list.type + "::";
    const auto field = std::ranges::find(fields, each.name, &Field::name);
    if (!each.value.starts_with(front) || field == fields.end()) continue;
    return at_field(place, source, each,
                    "field " + each.name + " of " + list.type + " is " + described(field->type) + "; write " +
                        field->type + "::" + each.value.substr(front.size()) + ", not " + each.value);
  }
  return {};
}

std::optional<Explanation> list_in_a_call(const ErrorGroup& group, const std::filesystem::path& root) {
  static const std::string braces = "'<brace-enclosed initializer list>'";
  static const std::array<std::regex, 3> texts{
      std::regex{"invalid initialization of reference of type '(?:const )?([^'&]*)&?' from expression of type " +
                 braces},
      std::regex{"could not convert '.*' from " + braces + " to '([^']*)'"},
      std::regex{"cannot convert " + braces + " to '(?:const )?([^'&]*)&?'.*"}};
  const Diagnostic& place = group.front();
  const std::string text = without_second_names(place.text);
  std::smatch match;
  if (std::ranges::none_of(texts, [&](const std::regex& each) { return matches(text, match, each); })) return {};
  const std::string type = plain_name(match[1], root);
  const std::string source = text_of(place.file);
  const DesignatedList list = list_in_call(source, offset_of(source, place.line, place.column));
  return reason_in_list(place, source, list, type, root);
}

bool names_field(const Diagnostic& place, const std::string& field) {
  const std::string source = text_of(place.file);
  const DesignatedList list = list_around(source, offset_of(source, place.line, place.column));
  return std::ranges::find(list.fields, field, &NamedField::name) != list.fields.end();
}

std::optional<Explanation> list_in_overloaded_call(const ErrorGroup& group, const std::filesystem::path& root) {
  const Diagnostic& place = group.front();
  if (!place.text.starts_with("no matching function for call to '")) return {};
  const std::string source = text_of(place.file);
  const DesignatedList list = list_in_call(source, offset_of(source, place.line, place.column));
  return reason_in_list(place, source, list, type_of_argument(group, list, root), root);
}

std::optional<Explanation> list_without_type(const ErrorGroup& group, const std::filesystem::path& root) {
  static const std::regex no_aggregate{
      R"(designated initializers cannot be used with a non-aggregate type '(?:.*[<:])?(\w+)[ >]*')"};
  const Diagnostic& place = group.front();
  const std::string text = with_dimension_names(without_second_names(place.text));
  const std::string not_deduced = field_not_deduced(group);
  std::smatch match;
  if (!matches(text, match, no_aggregate) && not_deduced.empty()) return {};
  const std::string source = text_of(place.file);
  const DesignatedList list = list_around(source, offset_of(source, place.line, place.column));
  const std::vector<Field> fields = declared_fields(list.type, root);
  for (const NamedField& each : list.fields) {
    const auto field = std::ranges::find(fields, each.name, &Field::name);
    if (!each.value.starts_with('{') || field == fields.end()) continue;
    const bool is_deduced = each.name == not_deduced;
    if (!is_deduced && (match.empty() || field->type.find(match[1]) == std::string::npos)) continue;
    return at_field(place, source, each,
                    type_missing(each, list.type, is_deduced ? concept_of(list.type, root) : match[1].str()));
  }
  return {};
}

std::optional<Explanation> list_for_storeys(const ErrorGroup& group, const std::filesystem::path& root) {
  static const std::regex braces{
      R"(could not convert '\{.*\}' from '<brace-enclosed initializer list>' to '(PerStorey<.*>)')"};
  const Diagnostic& place = group.front();
  const std::string text = with_dimension_names(without_second_names(place.text));
  std::smatch match;
  if (!matches(text, match, braces)) return {};
  const std::string source = text_of(place.file), item = type_of_item(match[1]);
  const DesignatedList list = list_around(source, offset_of(source, place.line, place.column));
  if (auto wrong = wrong_value(place, source, list, list.type, root)) return wrong;
  const std::vector<Field> fields = declared_fields(list.type, root);
  for (const NamedField& each : list.fields) {
    const auto field = std::ranges::find(fields, each.name, &Field::name);
    if (field == fields.end() || type_of_item(field->type) != item || !each.value.starts_with('{')) continue;
    return at_field(
        place, source, each,
        "a value does not fit: each value of field " + each.name + " of " + list.type + " is " + needed_in_words(item));
  }
  return {};
}

}  // namespace moat::launcher
