#include "launcher/struct_fields.hpp"

#include <algorithm>
#include <regex>

#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

// Declarations of data members stand alone on their line, indented by two.
std::vector<Field> fields_in(const std::vector<std::string>& lines, const std::string& name) {
  static const std::regex field{
      R"(^  ([A-Za-z][\w:<>, ]*|(?:Required<)?decltype\(.*\)>?) (\w+)((\{.*\}| = .*)?;.*| =)$)"};
  static const std::regex another{R"(\{\}, (\w+)(?=\{\}))"};  // `Length x{}, y{};`
  static const std::regex no_field{R"(^  (using|return|friend|static|typedef) .*)"};
  std::vector<Field> fields;
  bool inside = false;
  for (const std::string& line : lines) {
    std::smatch match;
    if (line.starts_with("struct " + name + " {")) inside = true;
    if (line.starts_with("}")) inside = false;
    if (!inside && !fields.empty()) break;
    if (inside && !matches(line, no_field) && matches(line, match, field)) {
      fields.push_back({match[1], match[2]});
      const std::string values = match[3];
      for (std::sregex_iterator next{values.begin(), values.end(), another}, end; next != end; ++next)
        fields.push_back({match[1], (*next)[1]});
    }
  }
  return fields;
}

// The lines of every header of the library.
std::vector<std::string> lines_of_headers(const fs::path& root) {
  std::string headers;
  for (const char* folder : {"structures", "elements", "materials", "src", "analyses"}) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator{root / folder})
      if (entry.path().extension() == ".hpp") headers += text_of(entry.path());
  }
  return lines_of(headers);
}

// `using NAME = TYPE;`, of a template with arguments for example.
struct Alias {
  std::string name, type;
};

std::vector<Alias> aliases_in(const std::vector<std::string>& lines) {
  static const std::regex alias{R"(^using (\w+) = (\w+(<.*>)?);$)"};
  std::vector<Alias> aliases;
  for (const std::string& line : lines)
    if (std::smatch match; matches(line, match, alias)) aliases.push_back({match[1], match[2]});
  return aliases;
}

std::string without_arguments(const std::string& type) { return type.substr(0, type.find('<')); }

}  // namespace

std::vector<Field> declared_fields(const std::string& name, const fs::path& root) {
  const std::vector<std::string> lines = lines_of_headers(root);
  std::string type = name;
  for (const Alias& alias : aliases_in(lines))
    if (alias.name == name) type = without_arguments(alias.type);
  return fields_in(lines, type);
}

std::vector<std::string> fields_of(const std::string& name, const fs::path& root) {
  std::vector<std::string> names;
  for (const Field& field : declared_fields(name, root)) names.push_back(field.name);
  return names;
}

std::vector<std::string> names_of_types(const fs::path& root) {
  static const std::regex type{R"(^(?:struct|class) (\w+)(?: final)?(?: :.*)? \{$)"};
  const std::vector<std::string> lines = lines_of_headers(root);
  std::vector<std::string> names;
  for (const Alias& alias : aliases_in(lines)) names.push_back(alias.name);
  for (const std::string& line : lines)
    if (std::smatch match; matches(line, match, type)) names.push_back(match[1]);
  return names;
}

std::string concept_of(const std::string& type, const fs::path& root) {
  static const std::regex parameter{R"(^template <(\w+) \w+>$)"};
  std::string before;
  for (const std::string& line : lines_of_headers(root)) {
    std::smatch match;
    if (line == "struct " + type + " {" && matches(before, match, parameter)) return match[1];
    before = line;
  }
  return {};
}

bool is_in_headers(const std::string& word, const fs::path& root) {
  return std::ranges::any_of(lines_of_headers(root), [&](const std::string& line) { return has_word(line, word); });
}

std::string name_in_scripts(const std::string& type, const fs::path& root) {
  const std::string plain = without_arguments(type);
  if (plain == type) return type;
  for (const Alias& alias : aliases_in(lines_of_headers(root)))
    if (alias.type == type) return alias.name;
  return plain;
}

}  // namespace moat::launcher
