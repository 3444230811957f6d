// The options of a script: quantities, numbers, texts and motions.
#include <algorithm>
#include <charconv>

#include "app/command_line.hpp"
#include "app/script/script.hpp"
#include "app/script/script_parts.hpp"
#include "base/error.hpp"
#include "base/parse_quantity.hpp"
#include "motions/readers/read_motion.hpp"
#include "motions/readers/record.hpp"

namespace moat {

template <class Q>
Q Script::quantity(const std::string& name, Q preset, const std::string& help) {
  const std::string unit = unit_symbol<Q>();
  const std::string preset_text = to_text(preset.si()) + (unit == "1" ? "" : " " + unit);
  const auto text = parts_->line.look_up(name, preset_text, help, unit == "1" ? "NUMBER" : "[" + unit + "]");
  return text ? parse<Q>(*text, "--" + name) : preset;
}

Length Script::length(const std::string& name, Length preset, const std::string& help) {
  return quantity(name, preset, help);
}
Time Script::time(const std::string& name, Time preset, const std::string& help) {
  return quantity(name, preset, help);
}
Mass Script::mass(const std::string& name, Mass preset, const std::string& help) {
  return quantity(name, preset, help);
}
Force Script::force(const std::string& name, Force preset, const std::string& help) {
  return quantity(name, preset, help);
}
Speed Script::speed(const std::string& name, Speed preset, const std::string& help) {
  return quantity(name, preset, help);
}
Acceleration Script::acceleration(const std::string& name, Acceleration preset, const std::string& help) {
  return quantity(name, preset, help);
}
Stiffness Script::stiffness(const std::string& name, Stiffness preset, const std::string& help) {
  return quantity(name, preset, help);
}
HertzStiffness Script::hertz_stiffness(const std::string& name, HertzStiffness preset, const std::string& help) {
  return quantity(name, preset, help);
}
double Script::number(const std::string& name, double preset, const std::string& help) {
  return quantity(name, Dimensionless{preset}, help);
}
int Script::integer(const std::string& name, int preset, const std::string& help) {
  const auto text = parts_->line.look_up(name, std::to_string(preset), help, "INTEGER");
  if (!text) return preset;
  int value = 0;
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), value);
  if (error != std::errc{} || end != text->data() + text->size())
    throw InputError{"--" + name + ": \"" + *text + "\" is not a whole number. Write digits alone, 5 for example."};
  return value;
}
std::string Script::text(const std::string& name, const std::string& preset, const std::string& help,
                         const std::vector<std::string>& choices) {
  std::string words;
  for (const std::string& choice : choices) words += (words.empty() ? "" : ", ") + choice;
  const std::string given =
      parts_->line.look_up(name, preset, help + (words.empty() ? "" : ": " + words), "TEXT").value_or(preset);
  if (!choices.empty() && std::ranges::find(choices, given) == choices.end())
    throw InputError{"--" + name + ": \"" + given + "\" is not one of " + words + "."};
  return given;
}

namespace {

/// The options about files of records.
struct RecordLine {
  explicit RecordLine(CommandLine& line, const std::string& help)
      : file{line.look_up("record", "", help + ": " + motion_formats(), "FILE")},
        up{line.look_up("record-up", "", "accelerogram of the vertical component, upwards", "FILE")},
        unit{line.look_up("record-unit", "", "unit of records in plain text: g, gal, cm/s^2 ...", "UNIT")},
        step{line.look_up("record-step", "", "time step of plain text without times: 0.01 s", "TIME")},
        columns{line.look_up("record-columns", "", "columns of plain text: time,x or x,y,z or series ...", "WORDS")} {
    if (file) return;
    for (const auto& [name, value] : {std::pair{"unit", &unit}, {"step", &step}, {"columns", &columns}, {"up", &up}})
      if (*value) throw InputError{"--record-" + std::string{name} + ": give it together with --record FILE."};
  }
  [[nodiscard]] TextColumns text() const {
    TextColumns text{.columns = columns.value_or("")};
    if (step) text.step = parse<Time>(*step, "--record-step");
    if (!unit) return text;
    const std::optional<double> known = acceleration_unit(*unit);
    text.unit = known ? Acceleration{*known} : parse<Acceleration>("1 " + *unit, "--record-unit");
    return text;
  }
  /// Calls a function that reads files.
  template <class Read>
  auto reading(Read read) const {
    try {
      return read();
    } catch (const MissingUnit& error) {
      throw InputError{error.problem() + " Give the unit: --record-unit g, or --record-unit cm/s^2."};
    }
  }

  std::optional<std::string> file, up, unit, step, columns;
};

}  // namespace

GroundMotion Script::motion(const GroundMotion& preset) {
  const RecordLine record{parts_->line, "accelerogram"};
  if (!record.file) return preset;
  return record.reading([&] {
    const GroundMotion horizontal = read_motion(*record.file, record.text());
    return record.up ? with_vertical(horizontal, read_motion(*record.up, record.text())) : horizontal;
  });
}

PlanMotion Script::plan_motion(const PlanMotion& preset) {
  const auto second = parts_->line.look_up("record-2", "", "accelerogram of the second component", "FILE"),
             table =
                 parts_->line.look_up("records-table", "", "table of the channels and their components", "FILE.csv");
  const double degrees = number("incidence", preset.incidence / (units::pi / 180.0),
                                "angle in degrees from +x to the first component, counter-clockwise");
  const RecordLine record{parts_->line, "accelerogram of the first component, or of all in a file or folder"};
  if (second && !record.file) throw InputError{"--record and --record-2: give both components, or none."};
  if (table && (!record.file || second))
    throw InputError{"--records-table: give it together with --record FILE or FOLDER, and without --record-2."};
  // The table is looked for where the program runs, also for a folder of records.
  const auto table_file = table ? std::filesystem::current_path() / *table : std::filesystem::path{};
  PlanMotion motion = !record.file ? preset : record.reading([&] {
    if (second) return PlanMotion{read_motion(*record.file, record.text()), read_motion(*second, record.text()), {}};
    return read_record({*record.file}, {.table = table_file, .text = record.text()}).plan();
  });
  motion.incidence = degrees * units::deg;
  if (record.up) motion.vertical = record.reading([&] { return read_motion(*record.up, record.text()); });
  return motion;
}

}  // namespace moat
