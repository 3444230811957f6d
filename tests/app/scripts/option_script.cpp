// Prints an option of every kind, then runs a model that is done at once.
#include <moat.hpp>

#include <cstdio>

#include "base/text/terminal.hpp"

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Options"};
  std::printf("length %.17g\n", script.length("length", 10 * cm, "a length").si());
  std::printf("time %.17g\n", script.time("time", 2 * s, "a time").si());
  std::printf("mass %.17g\n", script.mass("mass", 3 * kg, "a mass").si());
  std::printf("push %.17g\n", script.force("push", 4 * kN, "a force").si());
  std::printf("speed %.17g\n", script.speed("speed", 5 * m / s, "a speed").si());
  std::printf("acceleration %.17g\n", script.acceleration("acceleration", 0.5 * g, "an acceleration").si());
  std::printf("stiffness %.17g\n", script.stiffness("stiffness", 7 * kN / m, "a stiffness").si());
  std::printf("hertz %.17g\n", script.hertz_stiffness("hertz", 8 * N / m_3_2, "a Hertz stiffness").si());
  std::printf("number %.17g\n", script.number("number", 0.65, "a plain number"));
  std::printf("integer %d\n", script.integer("integer", 5, "a whole number"));
  std::printf("text %s\n", printable(script.text("text", "none", "any text")).c_str());
  std::fflush(stdout);
  Model model;
  add(model, Node{.name = "body", .mass = 1 * kg, .free = true});
  return script.run(model, script.motion(GroundMotion{"still ground", 0.01, {0.0, 0.0, 0.0}}));
}
