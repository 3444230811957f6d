// Properties that hold in random cases.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace moat::testing {

/// The parameters of RapidCheck that a run is given by RC_PARAMS, with a seed that is fixed unless it names one.
inline const std::string& given_parameters() {
  static const std::string given = [] {
    const char* value = std::getenv("RC_PARAMS");
    std::string parameters = value == nullptr ? "" : value;
    if (parameters.find("seed=") == std::string::npos) parameters += " seed=20261128";
    setenv("RC_PARAMS", parameters.c_str(), 1);
    return parameters;
  }();
  return given;
}

/// Checks a property in so many random cases. RC_PARAMS="max_success=1000 seed=7" changes number and seed. A failure
/// shows the smallest case in which the property fails, and the RC_PARAMS that repeat it.
template <class Property>
void for_random_cases(int cases, Property property) {
  using namespace rc::detail;
  const bool number_is_given = given_parameters().find("max_success=") != std::string::npos;
  TestParams parameters = configuration().testParams;
  if (!number_is_given) parameters.maxSuccess = cases;
  const ::testing::TestInfo& test = *::testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string{test.test_suite_name()} + "." + test.name();
  const TestResult result = checkTestable(property, TestMetadata{name, name}, parameters);
  if (result.template is<SuccessResult>()) return;
  std::ostringstream message;
  printResultMessage(result, message);
  ADD_FAILURE() << message.str() << "\nRC_PARAMS=\"seed=" << parameters.seed << " max_success=" << parameters.maxSuccess
                << "\"";
}

/// A generator of things that `draw` makes from a number below a million; `smaller` lists simpler ones for a failure.
template <class Draw, class Smaller>
auto drawn_by(Draw draw, Smaller smaller) {
  using Value = decltype(draw(std::uint64_t{}));
  return rc::Gen<Value>{[draw, smaller](const rc::Random& random, int) {
    rc::Random source = random;
    return rc::shrinkable::shrinkRecur(draw(source.next() % 1000000), [smaller](const Value& value) {
      return rc::seq::fromContainer(smaller(value));
    });
  }};
}

/// A seed for RandomDraws.
inline rc::Gen<std::uint64_t> seeds() {
  return drawn_by([](std::uint64_t seed) { return seed; }, [](std::uint64_t) { return std::vector<std::uint64_t>{}; });
}

/// A number in a range, drawn again as it is.
inline rc::Gen<double> any_number(double low, double high) {
  return rc::gen::map(rc::gen::noShrink(rc::gen::inRange(0, 1 << 30)),
                      [low, high](int part) { return low + (high - low) * part / static_cast<double>(1 << 30); });
}

}  // namespace moat::testing
