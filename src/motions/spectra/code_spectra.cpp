#include "motions/spectra/code_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "base/units.hpp"
#include "motions/response_spectrum.hpp"

namespace moat {
namespace {

TargetSpectrum asce_7(const Asce7Spectrum& parameters, const char* name, double factor) {
  const double s_ds = parameters.s_ds, s_d1 = parameters.s_d1, t_l = parameters.long_period.si();
  const double t_s = s_d1 / s_ds, t_0 = 0.2 * t_s;
  const Check check{"Asce7Spectrum", ""};
  constexpr double largest = 10.0, shortest_corner = 0.05, longest_corner = 3.0;
  for (const auto& [parameter, value] : {std::pair{"s_ds", s_ds}, {"s_d1", s_d1}})
    check.above_up_to(parameter, value, 0.0, largest, "1", "Give a fraction of g.");
  check.between("T_S = s_d1 / s_ds", t_s, shortest_corner, longest_corner, "s", "Give fractions of g.");
  check.that(t_l > t_s && std::isfinite(t_l), "long_period", t_l, "s", "> T_S = " + to_text(t_s) + " s and finite",
             "Take T_L from the map of the code, 4 to 16 s.");
  return {
      .name = name,
      .source = "ASCE/SEI 7-22 11.4.5.2, recalled, not read in the code; branches as in public scripts of ASCE 7-10",
      .longest = Time{std::numeric_limits<double>::infinity()},
      .corners = {Time{t_0}, Time{t_s}, Time{t_l}},
      .value = [=](double t) {
        const double falling = s_d1 / t * std::min(1.0, t_l / t);
        return factor * standard_gravity * (t < t_0 ? s_ds * (0.4 + 0.6 * t / t_0) : t < t_s ? s_ds : falling);
      }};
}

// S, and corners in s.
struct ShapeOfEn1998 {
  double soil_factor, t_b, t_c, t_d;
};

constexpr ShapeOfEn1998 vertical_shape{1.0, 0.05, 0.15, 1.0};
constexpr ShapeOfEn1998 recommended_shapes[2][5]{
    {{1.0, 0.15, 0.4, 2.0}, {1.2, 0.15, 0.5, 2.0}, {1.15, 0.2, 0.6, 2.0}, {1.35, 0.2, 0.8, 2.0}, {1.4, 0.15, 0.5, 2.0}},
    {{1.0, 0.05, 0.25, 1.2},
     {1.35, 0.05, 0.25, 1.2},
     {1.5, 0.1, 0.25, 1.2},
     {1.8, 0.1, 0.3, 1.2},
     {1.6, 0.05, 0.25, 1.2}}};
constexpr double ends_of_last_branch[]{4.5, 5.0, 6.0, 6.0, 6.0};  // T_E of annex A, s

}  // namespace

TargetSpectrum Asce7Spectrum::design() const { return asce_7(*this, "ASCE 7 design", 1.0); }

TargetSpectrum Asce7Spectrum::mce_r() const { return asce_7(*this, "ASCE 7 MCE_R", 1.5); }

Asce7Spectrum asce_7_parameters(const TargetSpectrum& spectrum, SpectrumLevel level, Speed shear_wave_velocity,
                                Time long_period) {
  Check{"asce_7_parameters", spectrum.name}.positive("shear_wave_velocity", shear_wave_velocity);
  constexpr double share = 0.9, step = 1e-3, at_1_s = 1.0, first = 0.2, last = 5.0;
  constexpr Speed stiff_soil = 442.0 * (units::m / units::s);
  const double last_of_s_m1 = shear_wave_velocity > stiff_soil ? 2.0 : last;
  const auto acceleration = [&](double t) { return spectrum.acceleration(Time{t}).si() / standard_gravity; };
  double short_periods = 0.0, one_second = acceleration(at_1_s);
  const auto read = [&](double t) {
    if (t < first || t > last) return;
    short_periods = std::max(short_periods, share * acceleration(t));
    if (t >= at_1_s && t <= last_of_s_m1) one_second = std::max(one_second, share * t * acceleration(t));
  };
  for (const Time corner : spectrum.corners) read(corner.si());
  for (const double end : {first, last_of_s_m1, last}) read(end);
  for (double t = first; t < last; t += step) read(t);
  const double of_design = level == SpectrumLevel::design ? 1.0 : 2.0 / 3.0;
  return {.s_ds = of_design * short_periods, .s_d1 = of_design * one_second, .long_period = long_period};
}

En1998Spectrum::operator TargetSpectrum() const {
  constexpr double end = 4.0, end_of_annex = 10.0, largest = 2.0, largest_soil_factor = 10.0, least_eta = 0.55;
  const double on_rock = ground_acceleration.si();
  const Check check{"En1998Spectrum", ""};
  check_damping_ratio(check, damping_ratio);
  check.above_up_to("ground_acceleration", on_rock, 0.0, largest * standard_gravity, "m/s^2", "Give it as 0.3 * g.");
  check.that(type == 1 || type == 2, "type", type, "1", "1 or 2");
  check.that(!ground || (*ground >= 'A' && *ground <= 'E'), "its ground is not A, B, C, D or E.",
             "Give a shape for ground S1 or S2.");
  check.that(ground || vertical || (shape && !beyond_4_s), "the ground is missing.", "Give .ground = 'C'.");
  check.that(!vertical || (!shape && !beyond_4_s), "a vertical spectrum has neither shape nor annex A.",
             "Leave out shape and beyond_4_s.");
  const int row = ground ? *ground - 'A' : 0;
  const auto [soil_factor, t_b, t_c, t_d] =
      shape      ? ShapeOfEn1998{shape->soil_factor, shape->t_b.si(), shape->t_c.si(), shape->t_d.si()}
      : vertical ? vertical_shape
                 : recommended_shapes[type - 1][row];
  check.above_up_to("soil_factor", soil_factor, 0.0, largest_soil_factor, "1");
  check.that(0.0 < t_b && t_b < t_c && t_c < t_d && t_d <= end,
             "T_B, T_C, T_D = " + to_text(t_b) + ", " + to_text(t_c) + ", " + to_text(t_d) +
                 " s do not increase from above 0 s to at most 4 s.",
             "Give the corners of the national annex in their order.");
  const double eta = std::max(least_eta, std::sqrt(10.0 / (5.0 + 100.0 * damping_ratio)));
  const double plateau = (vertical ? 3.0 : 2.5) * eta, t_e = beyond_4_s ? ends_of_last_branch[row] : end;
  const double at_0 = soil_factor * on_rock * (!vertical ? 1.0 : type == 1 ? 0.9 : 0.45);
  const std::string type_text = " type " + std::to_string(type);
  return {.name = "EN 1998-1" + (vertical ? " vertical" + type_text
                                 : shape  ? ", own shape"
                                          : type_text + ", ground " + *ground),
          .source = std::string{vertical ? "EN 1998-1:2004 3.2.2.3" : "EN 1998-1:2004 3.2.2.2"} +
                    (shape ? ", parameters of the user" : ", recommended values, as in ROB-Seismology/rshalib") +
                    (beyond_4_s ? "; beyond 4 s by the informative annex A, recalled, not read in the code" : ""),
          .damping_ratio = damping_ratio,
          .longest = Time{beyond_4_s ? end_of_annex : end},
          .corners = {Time{t_b}, Time{t_c}, Time{t_d}, Time{t_e}},
          .value =
              [=, t_b = t_b, t_c = t_c, t_d = t_d](double t) {
                if (t < t_b) return at_0 * (1.0 + t / t_b * (plateau - 1.0));
                if (t <= t_e) return at_0 * plateau * std::min(1.0, t_c / t) * std::min(1.0, t_d / t);
                const double frequency = 2.0 * std::numbers::pi / t;
                return frequency * frequency * 0.025 * at_0 * t_c * t_d *
                       (plateau + (t - t_e) / (end_of_annex - t_e) * (1.0 - plateau));
              },
          .advice = beyond_4_s || vertical ? "" : "Set beyond_4_s, which takes annex A, to 10 s."};
}

Gb50011Spectrum::operator TargetSpectrum() const {
  constexpr double first = 0.1, end = 6.0, rigid = 0.45, least_eta_2 = 0.55, largest = 3.0;
  const double z = damping_ratio, t_g = characteristic_period.si(), scale = alpha_max * standard_gravity;
  const Check check{"Gb50011Spectrum", ""};
  check_damping_ratio(check, z);
  check.above_up_to("alpha_max", alpha_max, 0.0, largest, "1", "Give a fraction of g.");
  check.above_up_to("characteristic_period", t_g, first, 0.2 * end, "s");
  const double gamma = 0.9 + (0.05 - z) / (0.3 + 6.0 * z);
  const double eta_1 = std::max(0.0, 0.02 + (0.05 - z) / (4.0 + 32.0 * z));
  const double eta_2 = std::max(least_eta_2, 1.0 + (0.05 - z) / (0.08 + 1.6 * z));
  const double end_of_power = isolation ? end : 5.0 * t_g;
  return {.name = isolation ? "GB 50011, isolation" : "GB 50011",
          .source = std::string{"GB 50011-2010 (2016) 5.1.5, as in a public module"} +
                    (isolation ? "; power to 6 s by GB/T 51408, recalled, not read in the code" : ""),
          .damping_ratio = z,
          .longest = Time{end},
          .corners = {Time{first}, Time{t_g}, Time{end_of_power}},
          .value = [=](double t) {
            if (t < first) return scale * (rigid + (eta_2 - rigid) * t / first);
            if (t <= end_of_power) return scale * eta_2 * std::min(1.0, std::pow(t_g / t, gamma));
            return scale * (eta_2 * std::pow(0.2, gamma) - eta_1 * (t - end_of_power));
          }};
}

}  // namespace moat
