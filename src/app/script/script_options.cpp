// The options of a script: quantities, numbers, texts and motions.
#include <charconv>

#include "app/command_line.hpp"
#include "app/script/script.hpp"
#include "app/script/script_parts.hpp"
#include "base/error.hpp"
#include "base/parse_quantity.hpp"
#include "motions/readers/read_motion.hpp"

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
    throw InputError{"--" + name + ": \"" + *text + "\" is not a whole number."};
  return value;
}
std::string Script::text(const std::string& name, const std::string& preset, const std::string& help) {
  return parts_->line.look_up(name, preset, help, "TEXT").value_or(preset);
}

GroundMotion Script::motion(const GroundMotion& preset) {
  const auto file = parts_->line.look_up("record", "", "accelerogram: " + motion_formats(), "FILE");
  const auto unit = parts_->line.look_up("record-unit", "", "unit of a two-column record: g, cm/s^2 ...", "UNIT");
  const auto up = parts_->line.look_up("record-up", "", "accelerogram of the vertical component, upwards", "FILE");
  if (!file) {
    if (unit) throw InputError{"--record-unit: give it together with --record FILE."};
    if (up) throw InputError{"--record-up: give it together with --record FILE."};
    return preset;
  }
  const GroundMotion horizontal = read(*file, unit);
  return up ? with_vertical(horizontal, read(*up, unit)) : horizontal;
}

PlanMotion Script::plan_motion(const PlanMotion& preset) {
  const auto first =
                 parts_->line.look_up("record", "", "accelerogram of the first component: " + motion_formats(), "FILE"),
             second = parts_->line.look_up("record-2", "", "accelerogram of the second component", "FILE"),
             up = parts_->line.look_up("record-up", "", "accelerogram of the vertical component, upwards", "FILE"),
             unit = parts_->line.look_up("record-unit", "", "unit of two-column records: g, cm/s^2 ...", "UNIT");
  const double degrees = number("incidence", preset.incidence / (units::pi / 180.0),
                                "angle in degrees from +x to the first component, counter-clockwise");
  if (first.has_value() != second.has_value())
    throw InputError{"--record and --record-2: give both components, or none."};
  if (unit && !first) throw InputError{"--record-unit: give it together with --record FILE."};
  if (up && !first) throw InputError{"--record-up: give it together with --record and --record-2."};
  PlanMotion motion = first ? PlanMotion{read(*first, unit), read(*second, unit)} : preset;
  motion.incidence = degrees * units::deg;
  if (up) motion.vertical = read(*up, unit);
  return motion;
}

GroundMotion Script::read(const std::string& file, const std::optional<std::string>& unit) const {
  if (unit) return read_motion(file, parse<Acceleration>("1 " + *unit, "--record-unit"));
  try {
    return read_motion(file);
  } catch (const MissingUnit& error) {
    throw InputError{error.problem() + " Give the unit: --record-unit g, or --record-unit cm/s^2."};
  }
}

}  // namespace moat
