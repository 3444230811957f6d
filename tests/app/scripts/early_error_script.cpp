// A script with an error before its Script exists.
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main() {
  Model model;
  add(model, Node{.name = "base", .mass = -1 * kg});
}
