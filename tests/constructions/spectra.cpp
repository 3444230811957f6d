// Spectra, codes and scaled suites.
#include <gtest/gtest.h>

#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

GroundMotion ramp() { return {"ramp", 0.01, {0.0, 1.0, 2.0}}; }

template <class Change>
std::function<void()> table(Change change) {
  return [change] {
    SpectrumTable points{.name = "mine", .periods = {0.1 * s, 1 * s}, .accelerations = {1 * g, 0.5 * g}};
    change(points);
    static_cast<void>(static_cast<TargetSpectrum>(points));
  };
}
std::function<void()> asce(const Asce7Spectrum& spectrum) {
  return [spectrum] { static_cast<void>(spectrum.design()); };
}
std::function<void()> en(const En1998Spectrum& spectrum) {
  return [spectrum] { static_cast<void>(static_cast<TargetSpectrum>(spectrum)); };
}
std::function<void()> gb(const Gb50011Spectrum& spectrum) {
  return [spectrum] { static_cast<void>(static_cast<TargetSpectrum>(spectrum)); };
}
template <class Change>
std::function<void()> suite(Change change) {
  return [change] {
    std::vector<NamedPair> pairs{NamedPair{"one", PlanMotion{ramp(), ramp()}},
                                 NamedPair{"two", PlanMotion{ramp(), ramp()}}};
    SuiteScaling scaling = SuiteScaling::asce_7_16(2 * s, 3 * s);
    change(pairs, scaling);
    static_cast<void>(scale_suite(pairs, Asce7Spectrum{.s_ds = 1, .s_d1 = 0.6, .long_period = 8 * s}.mce_r(), scaling));
  };
}

}  // namespace

Constructions spectra() {
  return {
      {"a spectrum with damping in per cent",
       [] { static_cast<void>(response_spectrum(ramp(), {1 * s}, 5)); },
       {"response_spectrum \"ramp\"", "damping_ratio", "5", ">= 0 and < 1", "Give 5 % as 0.05"}},
      {"a spectrum at a period of an age",
       [] { static_cast<void>(response_spectrum(ramp(), {2000 * s}, 0.05)); },
       {"response_spectrum \"ramp\"", "period", "2000 s", "0 s, or from 0.0001 s to 1000 s",
        "Give 0 s for a rigid oscillator"}},
      {"a mean over no period",
       [] { static_cast<void>(average_spectral_acceleration(ramp(), std::vector<Time>{})); },
       {"average_spectral_acceleration", "there are no", "periods", "Give", "at least one"}},
      {"a range of periods turned over",
       [] { static_cast<void>(periods_between(3 * s, 1 * s)); },
       {"periods_between", "longest", "1 s", "> 3 s", "Check its sign and its unit"}},
      {"a table of one point",
       table([](auto& points) { points.periods.pop_back(); }),
       {"SpectrumTable \"mine\"", "1 periods", "2 accelerations", "at least two periods", "an acceleration for each"}},
      {"a table whose periods fall",
       table([](auto& points) { points.periods[1] = 0.05 * s; }),
       {"SpectrumTable \"mine\"", "period", "0.05 s", "> 0.1 s, the one before", "Sort the table by periods"}},
      {"a table with no acceleration",
       table([](auto& points) { points.accelerations[1] = 0 * g; }),
       {"SpectrumTable \"mine\"", "acceleration at 1 s", "0 m/s^2", "> 0 m/s^2 and finite",
        "Check its sign and its unit"}},
      {"a table before time",
       table([](auto& points) { points.periods[0] = -1 * s; }),
       {"SpectrumTable \"mine\"", "period", "-1 s", ">= 0 s", "Sort the table by periods"}},
      {"a table with a long period and a short end",
       table([](auto& points) { points.long_period = 8 * s; }),
       {"SpectrumTable \"mine\"", "last period", "1 s", ">= 10 s where long_period is given",
        "Leave out long_period, or give the whole table"}},
      {"a table beyond its end",
       [] {
         const TargetSpectrum spectrum =
             SpectrumTable{.name = "mine", .periods = {0.1 * s, 1 * s}, .accelerations = {1 * g, 0.5 * g}};
         static_cast<void>(spectrum.acceleration(2 * s));
       },
       {"TargetSpectrum \"mine\"", "period", "2 s", "from 0.1 s to 1 s", "The table ends there"}},
      {"a target in no file",
       [] { static_cast<void>(read_target_spectrum("no such target.csv", TargetFile{})); },
       {"no such target.csv", "there is", "no such file", "Check", "the path"}},
      {"a code in per cent of g",
       asce({.s_ds = 100, .s_d1 = 60, .long_period = 8 * s}),
       {"Asce7Spectrum", "s_ds", "100", "> 0 and <= 10", "Give a fraction of g"}},
      {"a code with a corner beyond the long period",
       asce({.s_ds = 1, .s_d1 = 0.6, .long_period = 0.5 * s}),
       {"Asce7Spectrum", "long_period", "0.5 s", "> T_S = 0.6 s and finite",
        "Take T_L from the map of the code, 4 to 16 s"}},
      {"a code of a third type",
       en({.ground_acceleration = 0.3 * g, .type = 3, .ground = 'C'}),
       {"En1998Spectrum", "type", "3", "1 or 2", "Give a number in this range"}},
      {"a code on ground F",
       en({.ground_acceleration = 0.3 * g, .ground = 'F'}),
       {"En1998Spectrum", "ground", "is not", "A, B, C, D or E", "Give a shape for ground S1 or S2"}},
      {"a code without ground",
       en({.ground_acceleration = 0.3 * g}),
       {"En1998Spectrum", "ground", "is missing", "Give", ".ground = 'C'"}},
      {"a code of an acceleration in m/s^2 as g",
       en({.ground_acceleration = 3 * g, .ground = 'C'}),
       {"En1998Spectrum", "ground_acceleration", "29.42 m/s^2", "> 0 m/s^2 and <= 19.6133 m/s^2",
        "Give it as 0.3 * g"}},
      {"a code whose corners fall",
       en({.ground_acceleration = 0.3 * g,
           .shape = En1998Shape{.soil_factor = 1.2, .t_b = 0.5 * s, .t_c = 0.4 * s, .t_d = 2 * s}}),
       {"En1998Spectrum", "T_B, T_C, T_D", "0.5, 0.4, 2 s", "increase from above 0 s to at most 4 s",
        "Give the corners of the national annex"}},
      {"a code on soil of no factor",
       en({.ground_acceleration = 0.3 * g,
           .shape = En1998Shape{.soil_factor = 0, .t_b = 0.1 * s, .t_c = 0.4 * s, .t_d = 2 * s}}),
       {"En1998Spectrum", "soil_factor", "0", "> 0 and <= 10", "Give a number in this range"}},
      {"a code of no influence",
       gb({.alpha_max = 0, .characteristic_period = 0.4 * s}),
       {"Gb50011Spectrum", "alpha_max", "0", "> 0 and <= 3", "Give a fraction of g"}},
      {"a code of a slow site",
       gb({.alpha_max = 0.9, .characteristic_period = 2 * s}),
       {"Gb50011Spectrum", "characteristic_period", "2 s", "> 0.1 s and <= 1.2 s", "Check its sign and its unit"}},
      {"a suite with the bounds exchanged",
       suite([](auto&, auto& scaling) { scaling = SuiteScaling::asce_7_16(3 * s, 2 * s); }),
       {"SuiteScaling \"ASCE 7-16\"", "first period", "3 s", "longer than the second, 2 s",
        "T_M of upper bounds is the shorter"}},
      {"a suite of no pair",
       suite([](auto& pairs, auto&) { pairs.clear(); }),
       {"scale_suite \"ASCE 7-16\"", "the suite", "has no records", "Give", "at least one pair"}},
      {"a suite with a name twice",
       suite([](auto& pairs, auto&) { pairs[1].name = "one"; }),
       {"scale_suite \"ASCE 7-16\"", "two records", "the name", "one", "Name them apart"}},
      {"a suite of a pair at rest",
       suite([](auto& pairs, auto&) {
         pairs[0].motion = PlanMotion{still_ground(1 * s), still_ground(1 * s)};
       }),
       {"scale_suite \"ASCE 7-16\"", "pair", "one", "no motion in the range", "Leave it out"}},
      {"a suite that reaches nothing",
       suite([](auto&, auto& scaling) { scaling.fraction = 0; }),
       {"scale_suite \"ASCE 7-16\"", "fraction", "0", "> 0 and finite", "Give a number in this range"}},
      {"the stiffest oscillator follows the ground",
       [] { EXPECT_NEAR(spectral_acceleration(ramp(), 1e-4 * s).si(), 2.0, 1e-2); }},
      {"the softest oscillator stays in space",
       [] {
         const ResponseSpectrum slow = response_spectrum(ramp(), {1000 * s}, 0.0);
         // After the ramp to 2 m/s^2 in 0.02 s the ground moves at 0.02 m/s, for 1000 s/(2 pi) times the velocity.
         EXPECT_NEAR(slow.displacement.at(0), 0.02 * 1000.0 / (2.0 * pi), 1e-4);
       }},
  };
}

}  // namespace moat::constructions
