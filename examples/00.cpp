#include <moat.hpp>
#include <cstdio>
int main() { std::printf("%g m\n", (10 * moat::units::cm).si()); }
