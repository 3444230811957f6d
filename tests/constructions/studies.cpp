// Studies, suites and their answers.
#include <gtest/gtest.h>

#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

std::function<void()> axes(const std::vector<StudyAxis>& axes) {
  return [axes] { StudyCases{axes}; };
}
std::function<void()> random(const RandomVariable& variable, int count = 5) {
  return [=] { static_cast<void>(random_samples({variable}, count, 1)); };
}
std::function<void()> study(const StudyOptions& options) {
  return [options] {
    const StudyCases cases{StudyAxis{.name = "gap", .unit = "cm", .values = {1, 2}}};
    static_cast<void>(run_study(
        cases, [](const StudyCase&) { return StudyRecord{}; }, options));
  };
}
std::function<void()> hunt(const HuntAndFill& options) {
  return [options] { static_cast<void>(hunt_and_fill([](double level) { return level; }, options)); };
}
std::function<void()> gap(const GapSearch& search) {
  return [search] { static_cast<void>(smallest_gap([](Length gap) { return gap - 0.1 * m; }, search)); };
}
std::function<void()> fit(const std::vector<KnownInterval>& intervals, double confidence = 0.95) {
  return [=] { LognormalFit(intervals, confidence, "gaps"); };
}
std::function<void()> bounds(const PropertyBounds& bounds) {
  return [bounds] { check_factors(bounds); };
}
template <class Change>
std::function<void()> suite(Change change) {
  return [change] {
    std::vector<GroundMotion> motions{{"one", 0.01, {0.0, 1.0}}, {"two", 0.01, {0.0, 1.0}}};
    SuiteOptions options{};
    change(motions, options);
    Suite(SuiteRecords{motions}, options);
  };
}

}  // namespace

Constructions studies() {
  const StudyAxis axis{.name = "gap", .unit = "cm", .values = {1, 2}};
  const auto other = [axis](auto change) {
    StudyAxis changed = axis;
    change(changed);
    return axes({changed});
  };
  return {
      {"a study of nothing", axes({}), {"Study", "there is", "no axis", "Give at least", "one StudyAxis"}},
      {"an axis of no value",
       other([](auto& a) { a.values.clear(); }),
       {"StudyAxis \"gap\"", "there are", "no values", "Give", "at least one"}},
      {"an axis of no name",
       other([](auto& a) { a.name = ""; }),
       {"StudyAxis", "it has", "no name", "Give it one", "for example"}},
      {"an axis called as a column",
       other([](auto& a) { a.name = "state"; }),
       {"StudyAxis", "state", "tables of studies", "a column of this name", "Give it another name"}},
      {"an axis of no number",
       other([](auto& a) { a.values[1] = not_a_number; }),
       {"StudyAxis \"gap\"", "a value", "nan cm", "a finite number", "division by zero"}},
      {"an axis with a label too few",
       other([](auto& a) { a.labels = {"one"}; }),
       {"StudyAxis \"gap\"", "labels and values", "differ", "Give one label", "for every value, or none"}},
      {"an axis with a label twice",
       other([](auto& a) {
         a.labels = {"one", "one"};
       }),
       {"StudyAxis \"gap\"", "label", "one", "appears twice", "Give every value a label of its own"}},
      {"an axis twice",
       axes({axis, axis}),
       {"StudyAxis \"gap\"", "name", "appears twice", "Give every axis", "a name of its own"}},
      {"a list of axes of other lengths",
       [axis] {
         static_cast<void>(StudyCases::list({axis, StudyAxis{.name = "mass", .unit = "t", .values = {1, 2, 3}}}));
       },
       {"StudyAxis \"mass\"", "3", "values", "has 2", "give them equally many"}},
      {"a study of 1e12 cases",
       [] {
         std::vector<StudyAxis> many;
         for (const char* name : {"a", "b", "c"}) many.push_back({name, "cm", linearly_spaced(0, 1, 10000)});
         StudyCases{many};
       },
       {"Study", "number of cases", "1e+12", "<= 1e9", "Give the axes fewer values"}},
      {"one value at equal distances",
       [] { static_cast<void>(linearly_spaced(0, 1, 1)); },
       {"linearly_spaced", "count", "1", ">= 2", "Give a number in this range"}},
      {"values at equal ratios from nothing",
       [] { static_cast<void>(logarithmically_spaced(0, 1, 3)); },
       {"logarithmically_spaced", "first", "0", "> 0 and finite", "Give a number in this range"}},
      {"a value of an axis that is not there",
       [axis] {
         const StudyCases cases{axis};
         static_cast<void>(StudyCase{cases, 0}.value("gpa"));
       },
       {"The study", "axis", "gpa", "Its axes are", "gap"}},
      {"a result that is not there",
       [] {
         static_cast<void>(value_of({NamedNumber{"displacement", "base", "m", 1.0}}, "displacment", "base"));
       },
       {"There is no result", "displacment", "base", "Give quantity and place", "as the table of results writes them"}},
      {"a uniform draw turned over",
       random({"k", "N/m", UniformDistribution{.low = 2, .high = 1}}),
       {"RandomVariable \"k\"", "low", "is not below", "high", "Give the lower end first"}},
      {"a normal draw of no width",
       random({"k", "N/m", NormalDistribution{.mean = 1, .standard_deviation = 0}}),
       {"RandomVariable \"k\"", "standard_deviation", "0 N/m", "> 0 N/m and finite", "Check its sign and its unit"}},
      {"a lognormal draw below nothing",
       random({"k", "N/m", LognormalDistribution{.median = -1, .dispersion = 0.3}}),
       {"RandomVariable \"k\"", "median", "-1 N/m", "> 0 N/m and finite", "Check its sign and its unit"}},
      {"a lognormal draw of no dispersion",
       random({"k", "N/m", LognormalDistribution{.median = 1, .dispersion = 0}}),
       {"RandomVariable \"k\"", "dispersion", "0", "> 0 and finite", "Give a number in this range"}},
      {"no draw",
       random({"k", "N/m", UniformDistribution{.low = 1, .high = 2}}, 0),
       {"random_samples", "count", "0", ">= 1", "Give a number in this range"}},
      {"a study on no thread",
       study({.threads = -1}),
       {"StudyOptions", "threads", "-1", ">= 0", "0 takes one thread per core"}},
      {"a hunt that begins at rest",
       hunt({.first_level = 0, .response_limit = 1}),
       {"HuntAndFill", "first_level", "0 level", "> 0 level and finite", "Check its sign and its unit"}},
      {"a hunt that does not move",
       hunt({.first_step = 0, .response_limit = 1}),
       {"HuntAndFill", "first_step", "0 level", "> 0 level and finite", "Check its sign and its unit"}},
      {"a hunt that slows down",
       hunt({.step_increment = -1, .response_limit = 1}),
       {"HuntAndFill", "step_increment", "-1 level", ">= 0 level and finite", "Check its sign and its unit"}},
      {"a hunt without limit",
       hunt({}),
       {"HuntAndFill", "response_limit", "0 response", "> 0 response and finite", "Check its sign and its unit"}},
      {"a hunt that ends before it begins",
       hunt({.response_limit = 1, .largest_level = 0.01}),
       {"HuntAndFill", "largest_level", "0.01 level", ">= first_level", "Check its sign and its unit"}},
      {"a hunt that fills less than nothing",
       hunt({.response_limit = 1, .fill = -1}),
       {"HuntAndFill", "fill", "-1", ">= 0", "Give a number in this range"}},
      {"a search from no gap",
       gap({.first = 0 * m}),
       {"GapSearch", "first", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a search that ends before it begins",
       gap({.largest = 1 * cm}),
       {"GapSearch", "largest", "0.01 m", ">= first", "Check its sign and its unit"}},
      {"a search for the exact gap",
       gap({.accuracy = 0 * m}),
       {"GapSearch", "accuracy", "0 m", "> 0 m and finite", "Check its sign and its unit"}},
      {"a fit of gaps that are turned over",
       fit({KnownInterval{2.0, 1.0}}),
       {"LognormalFit \"gaps\"", "up_to", "1 the values' unit", "> 0 and >= above", "Check its sign and its unit"}},
      {"a fit of gaps below nothing",
       fit({KnownInterval{-1.0, 1.0}}),
       {"LognormalFit \"gaps\"", "above", "-1 the values' unit", ">= 0 the values' unit and finite",
        "Check its sign and its unit"}},
      {"a fit of a gap that counts for nothing",
       fit({KnownInterval{1.0, 2.0, 0.0}}),
       {"LognormalFit \"gaps\"", "count", "0", "> 0 and finite", "Give a number in this range"}},
      {"a fit of gaps that are all alike",
       fit({{1.0, 2.0}, {1.0, 2.0}}),
       {"LognormalFit \"gaps\"", "one value splits all data", "dispersion", "zero", "or more records"}},
      {"a fit that is certain",
       fit({{1.0, 1.0}, {2.0, 2.0}}, 1.0),
       {"LognormalFit \"gaps\"", "confidence", "1", "> 0 and < 1", "Give a number in this range"}},
      {"more events than trials",
       [] { static_cast<void>(binomial_bounds(3, 2)); },
       {"binomial_bounds", "events", "3", ">= 0 and <= trials", "Give a number in this range"}},
      {"a lower bound above the nominal",
       bounds({.lower = PropertyFactors{1.2, 0.9}, .upper = {1.3, 1.2}}),
       {"PropertyBounds", "lower.strength", "1.2", "> 0 and <= 1", "Give a number in this range"}},
      {"an upper bound below the nominal",
       bounds({.lower = {0.8, 0.9}, .upper = {1.3, 0.9}}),
       {"PropertyBounds", "upper.stiffness", "0.9", "from 1 to 10", "The nominal properties lie between the bounds"}},
      {"a suite without record",
       suite([](auto& motions, auto&) { motions.clear(); }),
       {"Suite", "there are", "no records", "Give", "at least one"}},
      {"a suite with a record twice",
       suite([](auto& motions, auto&) { motions[1] = motions[0]; }),
       {"StudyAxis \"record\"", "label", "one", "appears twice", "Give every value a label of its own"}},
      {"a suite with an eccentricity of the whole plan",
       suite([](auto&, auto& options) { options.eccentricity = 0.5; }),
       {"Suite", "eccentricity", "0.5", ">= 0 and < 0.5", "5 % is 0.05"}},
      {"a suite on a line in directions",
       suite([](auto&, auto& options) { options.directions = {30 * deg}; }),
       {"Suite", "directions", "are given", "of motions on a line", "Give pairs of components"}},
      {"an incidence in steps that do not close",
       [] {
         Model model;
         add(model, Diaphragm{.name = "floor", .mass = 1 * kg, .size = {1 * m, 1 * m}, .free = true});
         static_cast<void>(incidence_study(model, PlanMotion{still_ground(1 * s), still_ground(1 * s)}, 7 * deg));
       },
       {"incidence_study", "step", "7 deg", "a whole part of 360 deg", "Give, for example, 15 * deg"}},
      {"an accidental eccentricity of nothing",
       [] { static_cast<void>(eccentricity_study([](PlanVector) { return Model{}; }, still_ground(1 * s), 0.0)); },
       {"eccentricity_study", "share", "0", "> 0 and < 0.5", "5 % is 0.05"}},
      {"a smallest gap of 0", [] { EXPECT_LT(smallest_gap([](Length gap) { return gap; }).gap.si(), 1.1e-5); }},
      {"a smallest gap beyond all", [] { EXPECT_TRUE(smallest_gap([](Length gap) { return gap - 20 * m; }).beyond); }},
  };
}

Constructions charts() {
  const auto chart = [](auto change) {
    return [change] {
      Chart drawn{.title = "Pounding",
                  .x_label = "gap [cm]",
                  .y_label = "force [kN]",
                  .series = {Series{.name = "base", .x = {1.0, 2.0}, .y = {0.0, 1.0}}}};
      int width = 400;
      change(drawn, width);
      static_cast<void>(svg_text({drawn}, width));
    };
  };
  const auto map = [](auto change) {
    return [change] {
      HeatMap drawn{"Drift", "gap [cm]", "record", "drift [cm]", {"10", "20"}, {"KBU000"}, {{1.0, 2.0}}};
      change(drawn);
      static_cast<void>(svg_text(drawn));
    };
  };
  return {
      {"no chart",
       [] { static_cast<void>(svg_text(std::vector<Chart>{})); },
       {"Chart", "there is", "no chart", "Give", "at least one"}},
      {"a chart of a stamp",
       chart([](Chart&, int& width) { width = 20; }),
       {"Chart \"Pounding\"", "width", "20 pixels", ">= 200 pixels for every column", "Check its sign and its unit"}},
      {"a chart of no point",
       chart([](Chart& all, int&) { all.series.clear(); }),
       {"Chart \"Pounding\"", "there is no point to draw", "Give at least one series", "point", "inside the x range"}},
      {"a series of other lengths",
       chart([](Chart& all, int&) { all.series[0].x.pop_back(); }),
       {"Series \"base\"", "x and y", "different lengths", "Give", "one y for every x"}},
      {"a series with a hole",
       chart([](Chart& all, int&) { all.series[0].y[1] = not_a_number; }),
       {"Series \"base\"", "y of chart \"Pounding\"", "nan", "a finite number", "division by zero"}},
      {"a chart of logarithms of nothing",
       chart([](Chart& all, int&) { all.logarithmic_y = true; }),
       {"Series \"base\"", "y of chart \"Pounding\"", "0", "> 0 and finite", "The y axis is logarithmic"}},
      {"a chart from zero of less",
       chart([](Chart& all, int&) {
         all.y_from_zero = true;
         all.series[0].y[1] = -1;
       }),
       {"Series \"base\"", "y of chart \"Pounding\"", "-1", ">= 0 and finite", "The y axis starts from zero"}},
      {"a chart turned over",
       chart([](Chart& all, int&) {
         all.x_range = {2.0, 1.0};
       }),
       {"Chart \"Pounding\"", "x range", "ends before it starts", "Give", "its lower end first"}},
      {"a chart in a unit of nothing",
       chart([](Chart& all, int&) {
         all.second_unit = SecondUnit{"g", 0.0};
       }),
       {"SecondUnit \"g\"", "per_first", "0", "> 0 and finite", "Give a number in this range"}},
      {"a map with a column too few",
       map([](HeatMap& all) { all.x_values.pop_back(); }),
       {"HeatMap \"Drift\"", "columns and of x_values", "differ", "Give", "one name for every column"}},
      {"a map of nothing",
       map([](HeatMap& all) {
         all.values = {{not_a_number, not_a_number}};
       }),
       {"HeatMap \"Drift\"", "there is", "no value to draw", "Give at least one", "finite"}},
  };
}

}  // namespace moat::constructions
