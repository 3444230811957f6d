#include "structures/files/bearing_table.hpp"

#include <algorithm>

#include "structures/files/input_table.hpp"

namespace moat {

PlanBearings read_bearings(const std::filesystem::path& file, const BearingTypes& given) {
  const std::vector<BearingType>& types = given.types;
  const Check check{"read_bearings", file.native()};
  std::string list;
  for (auto type = types.begin(); type != types.end(); ++type) {
    check.that(std::ranges::count(types, type->name, &BearingType::name) == 1,
               "type \"" + type->name + "\" is given twice.", "Give every type once.");
    list += (type == types.begin() ? "" : ", ") + type->name;
  }
  const InputTable table{read_text_file(file), {"name", "x [m]", "y [m]", "type"}, {"weight [kN]"}};
  table.require_unique("name");
  std::vector<PlanBearings::Placed> bearings;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const auto type = std::ranges::find(types, table.word(row, "type"), &BearingType::name);
    if (type == types.end())
      table.refuse(row, "type " + quoted(table.word(row, "type")) + " is not given; types are " + list + ".");
    PlanBearings::Placed& bearing = bearings.emplace_back(type->bearing);
    bearing.at = {table.at<Length>(row, "x"), table.at<Length>(row, "y")};
    bearing.name = table.word(row, "name");
    bearing.type = type->name;
    if (table.has("weight")) bearing.weight = table.positive<Force>(row, "weight");
  }
  std::vector<std::string> notes = table.notes();
  for (const BearingType& type : types)
    if (std::ranges::count(bearings, type.name, &PlanBearings::Placed::type) == 0)
      notes.push_back("no bearing of " + file.filename().string() + " has the type " + type.name + ".");
  return {std::move(bearings), std::move(notes)};
}

}  // namespace moat
