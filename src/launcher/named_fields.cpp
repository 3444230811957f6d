#include "launcher/compile_errors.hpp"

#include <algorithm>
#include <regex>

#include "base/text/nearest_name.hpp"
#include "launcher/dimension_words.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

struct Field {
  std::string type, name;
  bool is_required = false;
};

// `.name = value` in a list; without a name another item.
struct Item {
  std::string name, value;
  std::size_t offset;
};

int nesting(char c) { return (c == '{' || c == '(' || c == '[') - (c == '}' || c == ')' || c == ']'); }

// The fields of `struct NAME {`, or of the struct that `using NAME =` names, in their order. Their declarations stand
// alone on their line, indented by two.
std::vector<Field> fields_of(const std::string& name, const std::string& headers) {
  static const std::regex field{R"(^  (?!(?:using|return|friend|static|typedef) )([A-Za-z][\w:<>, ]*|)"
                                R"((?:Required<)?decltype\(.*\)>?) (\w+)((\{.*\}| = .*)?;.*| =)$)"};
  static const std::regex another{R"(\{\}, (\w+)(?=\{\}))"};  // `Length x{}, y{};`
  if (const std::size_t alias = headers.find("\nusing " + name + " = "); !name.empty() && alias != std::string::npos) {
    const std::size_t type = alias + name.size() + std::string_view{"\nusing  = "}.size();
    return fields_of(headers.substr(type, headers.find_first_of("<;", type) - type), headers);
  }
  const std::size_t begin = headers.find("\nstruct " + name + " {\n");
  if (begin == std::string::npos) return {};
  std::vector<Field> fields;
  for (const std::string& line : lines_of(headers.substr(begin, headers.find("\n}", begin) - begin))) {
    std::smatch match;
    if (line.size() > longest_line || !std::regex_match(line, match, field)) continue;
    const std::string type = match[1], rest = match[3];
    const bool is_needed = rest.starts_with(';') && (type == "Law" || type.starts_with("PerStorey<"));
    fields.push_back({type, match[2], is_needed || type.starts_with("Required<")});
    for (std::sregex_iterator next{rest.begin(), rest.end(), another}, end; next != end; ++next)
      fields.push_back({type, (*next)[1]});
  }
  return fields;
}

// The struct of `Moat{`, `Moat west{` or `Moat west = {`.
std::string type_before(const std::string& code, std::size_t brace) {
  static const std::regex type{R"(\b(?!return\b)(\w+)(<[^;{}]*>)?(\s+\w+)?(\s*=)?\s*$)"};
  const std::size_t begin = brace == 0 ? 0 : code.find_last_of(";{}(),", brace - 1) + 1;
  const std::string front = code.substr(begin, brace - begin);
  std::smatch match;
  return front.size() <= longest_line && std::regex_search(front, match, type) ? match[1].str() : "";
}

// The items of the list whose brace opens at an offset, up to the first without a name.
std::vector<Item> items_at(const std::string& source, const std::string& code, std::size_t brace) {
  std::vector<Item> items;
  int depth = 0;
  for (std::size_t i = brace, begin = brace + 1; i < code.size(); ++i) {
    depth += nesting(code[i]);
    if (depth > 1 || (depth == 1 && code[i] != ',')) continue;
    const std::size_t point = code.find_first_not_of(" \t\r\n", begin);
    const std::size_t equal = code[point] == '.' ? code.find('=', point) : code.size();
    if (point < i && equal > i) return {Item{"", "", point}};
    if (point < i)
      items.push_back({trimmed(code.substr(point + 1, equal - point - 1)),
                       trimmed(source.substr(equal + 1, i - equal - 1)), point});
    if (depth == 0) break;
    begin = i + 1;
  }
  return items;
}

std::optional<Mistake> mistake_in_list(const std::string& source, const std::string& code, std::size_t brace,
                                       const std::string& type, const std::string& headers) {
  const std::vector<Field> fields = fields_of(type, headers);
  const std::vector<Item> items = items_at(source, code, brace);
  if (fields.empty() || std::ranges::any_of(items, [](const Item& item) { return item.name.empty(); })) return {};
  std::vector<std::string> names;
  for (const Field& field : fields) names.push_back(field.name);
  auto last = fields.begin();
  for (const auto& [name, value, offset] : items) {
    const auto field = std::ranges::find(fields, name, &Field::name);
    if (field == fields.end()) {
      const std::string nearest = nearest_name(names, name);
      const std::string hint = nearest.empty() ? "it has " + joined(names, ", ") : "did you mean " + nearest + "?";
      return Mistake{offset, type + " has no field " + name + "; " + hint};
    }
    const std::string front = "field " + name + " of " + type;
    if (field < last) return Mistake{offset, front + " stands in the wrong place; the order is " + joined(names, ", ")};
    last = field;
    const bool is_list = field->type == "std::vector<double>" && value.starts_with('{');
    const std::string one = is_list ? trimmed(value.substr(1, value.find_first_of(",}") - 1)) : value;
    const std::string text =
        misfit(one, dimension_of_value(one, code), is_list ? std::string{number} : dimension_of_type(field->type));
    if (!text.empty()) return Mistake{offset, front + ": " + text};
    if (value.starts_with('{'))
      if (auto inside = mistake_in_list(source, code, code.find('{', offset), field->type, headers)) return inside;
  }
  for (const Field& field : fields)
    if (field.is_required && std::ranges::find(items, field.name, &Item::name) == items.end())
      return Mistake{brace, "field " + field.name + " of " + type + " is missing"};
  return {};
}

}  // namespace

std::string code_of(const std::string& source) {
  std::string code = source;
  for (std::size_t i = 0; i < code.size(); ++i) {
    std::size_t begin = i, end = i;
    if (code[i] == '"' && i > 0 && code[i - 1] == 'R') return "";
    if (code.compare(i, 2, "//") == 0) {
      end = source.find('\n', i);
    } else if (code.compare(i, 2, "/*") == 0) {
      end = source.find("*/", i + 2);
    } else if (code[i] == '"' ||
               (code[i] == '\'' && (i == 0 || std::string_view{"0123456789"}.find(code[i - 1]) == std::string::npos))) {
      for (end = ++begin; end < code.size() && code[end] != code[i] && code[end] != '\n'; ++end)
        if (code[end] == '\\') ++end;
    }
    end = std::min(end, code.size());
    for (; begin < end; ++begin)
      if (code[begin] != '\n') code[begin] = ' ';
    i = end;
  }
  std::string open;
  for (const char c : code) {
    if (nesting(c) > 0) open += c;
    if (nesting(c) >= 0) continue;
    if (open.empty() || (c - open.back() + 1) / 2 != 1) return "";  // counterparts are 1 or 2 apart in ASCII
    open.pop_back();
  }
  return code;
}

std::optional<Mistake> mistake_in_fields(const std::string& source, std::size_t offset, const std::string& argument,
                                         const std::filesystem::path& root) {
  const std::string code = code_of(source);
  if (offset >= code.size()) return {};
  std::string headers;
  for (const std::string& folder : lines_of(replaced(MOAT_LIBRARY_FOLDERS, " ", "\n")))
    if (is_directory(root / folder))
      for (const auto& entry : std::filesystem::recursive_directory_iterator{root / folder})
        if (entry.path().extension() == ".hpp") headers += text_of(entry.path());
  int depth = 0;
  std::vector<std::size_t> arguments;
  for (std::size_t i = offset; code[offset] == '(' && i < code.size() && (i == offset || depth > 0); ++i) {
    depth += nesting(code[i]);
    if (code[i] == '{' && depth == 2) arguments.push_back(i);
  }
  if (arguments.size() == 1)
    if (auto mistake = mistake_in_list(source, code, arguments.front(), argument, headers)) return mistake;
  depth = 0;
  int lists = 10;  // Deeper ones are no lists of fields; each is compared with all headers.
  for (std::size_t i = offset; i-- > 0 && lists > 0;) {
    depth += nesting(code[i]);
    if (depth <= 0) continue;
    depth = 0;
    if (code[i] != '{') continue;
    --lists;
    if (auto mistake = mistake_in_list(source, code, i, type_before(code, i), headers)) return mistake;
  }
  return {};
}

}  // namespace moat::launcher
