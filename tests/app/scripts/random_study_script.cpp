// A study of random models, for ranks of MPI.
#include <moat.hpp>

#include "moat_model.hpp"
#include "random_model.hpp"

using namespace moat;

int main(int argc, char** argv) {
  Script script{argc, argv, "Random models"};
  const int first = script.integer("first", 0, "number of the first model");
  script.study({{.name = "number", .unit = "1", .values = linearly_spaced(0.0, 7.0, 8)}}, [&](const StudyCase& each) {
    const auto plain = testing::random_model(static_cast<std::uint64_t>(first) + each.number());
    return StudyModel{testing::moat_model(plain), testing::moat_motion(plain.motion)};
  });
  return script.finish();
}
