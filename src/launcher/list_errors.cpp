#include "launcher/list_errors.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <regex>

#include "launcher/designated_list.hpp"
#include "launcher/dimension_names.hpp"
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

bool has_unit(const std::string& described_type) { return described_type.find('[') != std::string::npos; }

// "field pulse_period of NearFaultPulse is a time [s], but 1.3 is a number without unit; give it a unit, as in 1.3 * s"
std::string unit_missing(const NamedField& field, const std::string& type, const std::string& needed) {
  return "field " + field.name + " of " + type + " is " + needed + ", but " + field.value +
         " is a number without unit" + unit_hint(needed, field.value);
}

// Also in lists inside the list: `{.transient = {.step = 0.01}}`.
std::optional<Explanation> wrong_value(const Diagnostic& place, const std::string& source, const DesignatedList& list,
                                       const std::string& type, const std::filesystem::path& root) {
  static const std::regex number{R"([-+]?[0-9][0-9.']*(e[-+]?[0-9]+)?|[-+]?\.[0-9]+)"};
  if (auto wrong = wrong_field(place, source, list, type, root)) return wrong;
  const std::vector<Field> fields = declared_fields(type, root);
  for (const NamedField& each : list.fields) {
    const auto field = std::ranges::find(fields, each.name, &Field::name);
    if (field == fields.end()) continue;
    const std::string needed = described(field->type);
    if (has_unit(needed) && std::regex_match(each.value, number))
      return at_field(place, source, each, unit_missing(each, type, needed));
    if (!each.value.starts_with('{')) continue;
    const DesignatedList inside = list_around(source, source.find('{', each.offset) + 1);
    if (auto wrong = wrong_value(place, source, inside, field->type, root)) return wrong;
  }
  return {};
}

}  // namespace

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
  if (std::ranges::none_of(texts, [&](const std::regex& each) { return std::regex_match(text, match, each); }))
    return {};
  const std::string type = plain_name(match[1], root);
  const std::vector<Field> fields = declared_fields(type, root);
  const std::string source = text_of(place.file);
  const DesignatedList list = list_in_call(source, offset_of(source, place.line, place.column));
  if (fields.empty() || list.fields.empty()) return {};
  if (auto wrong = wrong_value(place, source, list, type, root)) return wrong;
  std::vector<std::string> needs;
  for (const NamedField& each : list.fields)
    needs.push_back(each.name + " is " + described(std::ranges::find(fields, each.name, &Field::name)->type));
  return at_field(place, source, list.fields.front(),
                  "a value does not fit its field of " + type + ": " + joined(needs, ", "));
}

}  // namespace moat::launcher
