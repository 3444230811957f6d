// A script with options and a loop of its own, without run() or study(). "checked": it calls check_options().
#include <cstdio>
#include <moat.hpp>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "A loop"};
  const Length gap = script.length("gap", 10 * cm, "clearance");
  if (script.integer("checked", 1, "whether options are checked before the loop") != 0) script.check_options();
  std::printf("loop with %g\n", gap.si());
  return 0;
}
