#include "base/parse_quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "base/units.hpp"
#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

template <class Q>
double si(const char* text) {
  return parse<Q>(text, "--value").si();
}

template <class Q>
std::string refusal(const char* text) {
  return message_of([&] { parse<Q>(text, "--value"); });
}

TEST(ParseQuantity, ReadsANumberWithItsUnit) {
  EXPECT_DOUBLE_EQ(si<Length>("10 cm"), 0.1);
  EXPECT_DOUBLE_EQ(si<Length>("10cm"), 0.1);
  EXPECT_DOUBLE_EQ(si<Length>("  10   cm  "), 0.1);
  EXPECT_DOUBLE_EQ(si<Length>("\t10\tcm\t"), 0.1);
  EXPECT_DOUBLE_EQ(si<Length>("1.5e2 mm"), 0.15);
  EXPECT_DOUBLE_EQ(si<Length>("1.5E+2mm"), 0.15);
  EXPECT_DOUBLE_EQ(si<Length>(".1 m"), 0.1);
  EXPECT_DOUBLE_EQ(si<Length>("0.02km"), 20.0);
  EXPECT_DOUBLE_EQ(si<Length>("+10 cm"), 0.1);
  EXPECT_DOUBLE_EQ(si<Length>("-10 cm"), -0.1);
  EXPECT_EQ(si<Length>("0 m"), 0.0);
}

TEST(ParseQuantity, KnowsTheUnitsOfTheHeader) {
  EXPECT_DOUBLE_EQ(si<Time>("2.5 ms"), 0.0025);
  EXPECT_DOUBLE_EQ(si<Time>("2 min"), 120.0);
  EXPECT_DOUBLE_EQ(si<Mass>("550 tonne"), 550e3);
  EXPECT_DOUBLE_EQ(si<Mass>("550 t"), 550e3);
  EXPECT_DOUBLE_EQ(si<Mass>("3 kg"), 3.0);
  EXPECT_DOUBLE_EQ(si<Force>("1.93 MN"), 1.93e6);
  EXPECT_DOUBLE_EQ(si<Force>("2 kN"), 2e3);
  EXPECT_DOUBLE_EQ(si<Force>("2 GN"), 2e9);
  EXPECT_DOUBLE_EQ(si<Energy>("2 J"), 2.0);
  EXPECT_DOUBLE_EQ(si<Energy>("2 kJ"), 2e3);
  EXPECT_DOUBLE_EQ(si<Energy>("2 MJ"), 2e6);
  EXPECT_DOUBLE_EQ(si<Frequency>("2 Hz"), 2.0);
  EXPECT_DOUBLE_EQ(si<Acceleration>("0.4g"), 0.4 * 9.80665);
}

TEST(ParseQuantity, ReadsUnitsThatAreMadeOfOthers) {
  EXPECT_DOUBLE_EQ(si<Stiffness>("1.93 MN/cm"), 1.93e8);
  EXPECT_DOUBLE_EQ(si<Stiffness>("1e9 N / m"), 1e9);
  EXPECT_DOUBLE_EQ(si<DampingCoefficient>("3 kN s/m"), 3e3);
  EXPECT_DOUBLE_EQ(si<DampingCoefficient>("3 kN*s/m"), 3e3);
  EXPECT_DOUBLE_EQ(si<DampingCoefficient>("3 kN s m^-1"), 3e3);
  EXPECT_DOUBLE_EQ(si<Acceleration>("981 cm/s^2"), 9.81);
  EXPECT_DOUBLE_EQ(si<Acceleration>("981 cm/s/s"), 9.81);
  EXPECT_DOUBLE_EQ(si<Speed>("36 km/min"), 600.0);
  EXPECT_DOUBLE_EQ(si<HertzStiffness>("2.95e9 N/m^1.5"), 2.95e9);
  EXPECT_DOUBLE_EQ(si<HertzStiffness>("1 kN/mm^1.5"), 1e3 / std::pow(1e-3, 1.5));
  EXPECT_DOUBLE_EQ(si<Force>("2 kg m/s^2"), 2.0);
  EXPECT_DOUBLE_EQ(si<Frequency>("5 s^-1"), 5.0);
  EXPECT_DOUBLE_EQ(si<Frequency>("5 1/s"), 5.0);
  EXPECT_DOUBLE_EQ(si<Frequency>("5/s"), 5.0);
  EXPECT_DOUBLE_EQ(si<Length>("10*cm"), 0.1);
  // A slash divides by all that follows.
  EXPECT_DOUBLE_EQ(si<Acceleration>("981 cm/s s"), 9.81);
  EXPECT_DOUBLE_EQ(si<Acceleration>("981 cm/s*s"), 9.81);
}

TEST(ParseQuantity, WithoutDimensionTakesNoUnit) {
  EXPECT_DOUBLE_EQ(si<Dimensionless>("0.65"), 0.65);
  EXPECT_DOUBLE_EQ(si<Dimensionless>(" -1e-3 "), -1e-3);
  EXPECT_EQ(refusal<Dimensionless>("nan"), "--value: \"nan\" is not a number. Write a plain number, 0.5 for example.");
  for (const char* text : {"5 cm", "30deg"})
    EXPECT_EQ(refusal<Dimensionless>(text),
              "--value: \"" + std::string{text} + "\" has a unit, but it must be a plain number.");
  EXPECT_EQ(refusal<Dimensionless>("5%"), "--value: \"5%\" is in percent. Write it as a plain number: 0.05.");
  EXPECT_EQ(refusal<Acceleration>("40%"),
            "--value: \"40%\" is in percent, but it must be in m/s^2 or multiples of it.");
  EXPECT_EQ(refusal<Dimensionless>("7 %"), "--value: \"7 %\" is in percent. Write it as a plain number: 0.07.");
  // Centimetres per metre would be a factor of 0.01 that nobody sees.
  EXPECT_EQ(refusal<Dimensionless>("5 cm/m"), "--value: \"5 cm/m\" has a unit, but it must be a plain number.");
}

TEST(ParseQuantity, RefusesANumberWithoutUnit) {
  EXPECT_EQ(refusal<Length>("12"), "--value: \"12\" has no unit. Write \"12 cm\" or \"12 m\".");
  EXPECT_EQ(refusal<Length>("-3e2 "), "--value: \"-3e2 \" has no unit. Write \"-3e2 cm\" or \"-3e2 m\".");
  EXPECT_EQ(refusal<Acceleration>("0.4"), "--value: \"0.4\" has no unit. Write \"0.4 g\" or \"0.4 m/s^2\".");
  EXPECT_EQ(refusal<Stiffness>("5"), "--value: \"5\" has no unit. Write \"5 MN/m\" or \"5 N/m\".");
  EXPECT_EQ(refusal<Frequency>("5"), "--value: \"5\" has no unit. Write \"5 1/s\".");
}

TEST(ParseQuantity, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"", " ", "cm", "ten cm", "- 5 cm", "+-5 cm", "++5 cm", "nan m", "inf m", "-inf m", ",5 m", "--5 m", "/s"})
    EXPECT_EQ(refusal<Length>(text),
              "--value: \"" + std::string{text} +
                  "\" does not start with a number. Write a number with its unit, in m for example.");
}

TEST(ParseQuantity, RefusesAValueBeyondTheLargestNumber) {
  for (const char* text : {"1e308 km", "1e999 m", "-1e400 cm", "1e400", "+1e309 furlong"})
    EXPECT_EQ(refusal<Length>(text), "--value: \"" + std::string{text} + "\" is too large. Check its exponent.");
  EXPECT_EQ(refusal<Dimensionless>("1e400"), "--value: \"1e400\" is too large. Check its exponent.");
}

TEST(ParseQuantity, RefusesAQuantityBeyondEveryBuilding) {
  for (const char* text : {"1e308 m", "-1e16 m", "1.1e17 cm"})
    EXPECT_EQ(refusal<Length>(text),
              "--value: \"" + std::string{text} + "\" is too large: at most 1e+15 m. Check its unit.");
  EXPECT_EQ(si<Length>("1e15 m"), 1e15);
  EXPECT_EQ(si<Dimensionless>("1e300"), 1e300);
}

TEST(ParseQuantity, RefusesAValueBelowTheSmallestNumber) {
  for (const char* text : {"1e-400 m", "-1e-999 cm"})
    EXPECT_EQ(refusal<Length>(text), "--value: \"" + std::string{text} + "\" is too small; zero is 0.");
  EXPECT_GT(si<Length>("1e-300 m"), 0.0);
}

TEST(ParseQuantity, RefusesAnUnknownUnitByName) {
  for (const auto& [text, unit] :
       {std::pair{"12 furlong", "furlong"}, {"0x10 m", "x10"}, {"12 cm 3", "3"}, {"1e m", "e"}, {"12 ^2", ""}})
    EXPECT_EQ(
        refusal<Length>(text),
        "--value: \"" + std::string{text} + "\" has an unknown unit \"" + unit +
            "\". Known are m mm cm km s ms min kg t tonne N kN MN GN J kJ MJ Hz and g (gravity), joined by / or a "
            "blank, with powers as in N/m^1.5.");
}

TEST(ParseQuantity, SuggestsTheUnitWithTheseLetters) {
  for (const auto& [text, unit] :
       {std::pair{"12 CM", "\"CM\". Did you mean cm?"}, {"12 kN/M", "\"M\". Did you mean m?"}})
    EXPECT_NE(refusal<Length>(text).find(" has an unknown unit " + std::string{unit} + " Known are m "),
              std::string::npos)
        << refusal<Length>(text);
}

TEST(ParseQuantity, RefusesAnotherDimensionAndNamesBoth) {
  EXPECT_EQ(refusal<Length>("12 kg"), "--value: \"12 kg\" is in kg, but it must be in m or multiples of it.");
  EXPECT_EQ(refusal<Length>("12 cm^2"), "--value: \"12 cm^2\" is in m^2, but it must be in m or multiples of it.");
  EXPECT_EQ(refusal<HertzStiffness>("3e9 N/m"),
            "--value: \"3e9 N/m\" is in N/m, but it must be in N/m^1.5 or multiples of it.");
  // g is gravity, not gram.
  EXPECT_EQ(refusal<Mass>("5 g"), "--value: \"5 g\" is in m/s^2, but it must be in kg or multiples of it.");
  EXPECT_EQ(refusal<Length>("1 cm/cm"), "--value: \"1 cm/cm\" is in 1, but it must be in m or multiples of it.");
}

TEST(ParseQuantity, RefusesPowersThatAreNotHalves) {
  for (const auto& [text, factor] : {std::pair{"1 m^1.3", "m^1.3"},
                                     {"1 m^", "m^"},
                                     {"1 m^two", "m^two"},
                                     {"1 m^2x", "m^2x"},
                                     {"1 m^1e9", "m^1e9"},
                                     {"1 m^nan", "m^nan"},
                                     {"1 N^0.5", "N^0.5"}})
    EXPECT_EQ(refusal<Length>(text), "--value: \"" + std::string{text} +
                                         "\" has a power that is not a whole or half number: \"" + factor + "\".");
}

TEST(ParseQuantity, SaysHowDecimalsAreWritten) {
  EXPECT_EQ(refusal<Length>("1,5 cm"), "--value: \"1,5 cm\" has a decimal comma. Write decimals with a point: 1.5.");
}

TEST(ParseQuantity, RefusesSignsThatJoinNothing) {
  for (const char* text : {"10 cm/", "10 /", "10 cm//s", "10 cm*", "10 cm**s", "10 cm / / s", "10 cm/*s"})
    EXPECT_EQ(refusal<Length>(text),
              "--value: \"" + std::string{text} + "\" has a / or * that joins nothing in its unit.");
}

TEST(ParseQuantity, TakesTextsOfAMegabyte) {
  constexpr std::size_t megabyte = 1'000'000;
  EXPECT_DOUBLE_EQ(parse<Length>("2" + std::string(megabyte, ' ') + "m", "--value").si(), 2.0);
  EXPECT_DOUBLE_EQ(parse<Length>("2." + std::string(megabyte, '0') + " m", "--value").si(), 2.0);
  for (const char* piece : {"1", "m", "m ", "m/", "/", "^", "m^1 ", "e", "kg ", "%", ","}) {
    std::string text = "1 ";
    while (text.size() < megabyte) text += piece;
    EXPECT_THROW((void)parse<Length>(text, "--value"), InputError) << piece;
  }
}

}  // namespace
}  // namespace moat
