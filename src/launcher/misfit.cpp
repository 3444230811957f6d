#include "launcher/misfit.hpp"

#include <regex>

#include "launcher/dimension_names.hpp"
#include "launcher/explanation.hpp"
#include "launcher/text.hpp"
#include "launcher/value_dimension.hpp"

namespace moat::launcher {
namespace {

bool has_unit(const std::string& described_type) { return described_type.find('[') != std::string::npos; }

std::string misfit(const std::string& front, const std::string& value, const std::string& type) {
  const std::string given = type_of_product(value), needed = needed_in_words(type);
  if (given.empty()) return {};
  const std::string is = described(given), sentence = front + " is " + needed + ", but " + value + " is " + is;
  if (has_unit(needed)) {
    if (!has_unit(is)) return sentence + unit_hint(needed, value);
    return needed == is ? "" : sentence;
  }
  if (has_unit(is) && (type == "int" || type == "double")) return sentence;
  if (type == "int" && given == "double")
    return front + " is a whole number, but " + value + " has a decimal point" + whole_number_hint(value);
  return {};
}

}  // namespace

std::string type_of_item(const std::string& type) {
  static const std::regex list{R"((?:PerStorey|std::vector)<(.*?) ?>)"};
  std::smatch match;
  const std::string plain = with_dimension_names(type);
  return matches(plain, match, list) ? match[1].str() : plain;
}

std::string misfit_of_field(const NamedField& field, const std::string& type, const std::string& declared) {
  const std::string item = type_of_item(declared), front = "field " + field.name + " of " + type;
  if (item == with_dimension_names(declared)) return misfit(front, field.value, item);
  if (!field.value.starts_with('{')) return misfit(front, field.value, item);
  for (const std::string& each : items_of(field.value))
    if (std::string text = misfit("each value of " + front, each, item); !text.empty()) return text;
  return {};
}

}  // namespace moat::launcher
