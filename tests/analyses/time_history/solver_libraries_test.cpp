// Every Newton step of an implicit step is NOX's, and every factorisation and solution is KLU's. This program takes the
// place of their functions, counts the calls, and hands them on.

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <suitesparse/klu.h>

#include "moat.hpp"
#include "paper_building.hpp"

namespace {

struct Calls {
  long nox_solves = 0, nox_iterations = 0, klu_analyses = 0, klu_factorisations = 0, klu_refactorisations = 0,
       klu_solutions = 0;
} calls;

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

// NOX::Solver::LineSearchBased::reset(initial guess) and step(), by their names in the library.
void _ZN3NOX6Solver15LineSearchBased5resetERKNS_8Abstract6VectorE(void* solver, const void* start) {
  ++calls.nox_solves;
  static auto* const original =
      next<void(void*, const void*)>("_ZN3NOX6Solver15LineSearchBased5resetERKNS_8Abstract6VectorE");
  original(solver, start);
}
int _ZN3NOX6Solver15LineSearchBased4stepEv(void* solver) {
  ++calls.nox_iterations;
  static auto* const original = next<int(void*)>("_ZN3NOX6Solver15LineSearchBased4stepEv");
  return original(solver);
}
klu_symbolic* klu_analyze(int size, int* starts, int* rows, klu_common* common) {
  ++calls.klu_analyses;
  static auto* const original = next<decltype(klu_analyze)>("klu_analyze");
  return original(size, starts, rows, common);
}
klu_numeric* klu_factor(int* starts, int* rows, double* values, klu_symbolic* symbolic, klu_common* common) {
  ++calls.klu_factorisations;
  static auto* const original = next<decltype(klu_factor)>("klu_factor");
  return original(starts, rows, values, symbolic, common);
}
int klu_refactor(int* starts, int* rows, double* values, klu_symbolic* symbolic, klu_numeric* numeric,
                 klu_common* common) {
  ++calls.klu_refactorisations;
  static auto* const original = next<decltype(klu_refactor)>("klu_refactor");
  return original(starts, rows, values, symbolic, numeric, common);
}
int klu_solve(klu_symbolic* symbolic, klu_numeric* numeric, int size, int columns, double* values, klu_common* common) {
  ++calls.klu_solutions;
  static auto* const original = next<decltype(klu_solve)>("klu_solve");
  return original(symbolic, numeric, size, columns, values, common);
}

}  // extern "C"

namespace moat {
namespace {

using namespace units;

TEST(SolverLibraries, SolveEveryStepOfABuildingThatPounds) {
  Model model = testing::pounding_building();
  const GroundMotion motion = near_fault_pulse({.pulse_period = 1.3 * s}).scaled_to_pga(0.4 * g);
  Transient transient{model, motion, {}};
  calls = {};
  transient.run();
  const SolverStatistics statistics = transient.statistics();
  ASSERT_GT(statistics.accepted_steps, 1000);
  // Steps are solved again for events, and none without an iteration.
  EXPECT_GE(calls.nox_solves, statistics.accepted_steps);
  EXPECT_GE(calls.nox_iterations, calls.nox_solves);
  EXPECT_EQ(statistics.newton_iterations, calls.nox_iterations);
  EXPECT_EQ(calls.klu_solutions, calls.nox_iterations);
  EXPECT_EQ(statistics.factorisations, calls.klu_refactorisations + 1);
  EXPECT_GT(calls.klu_refactorisations, 100);
  // The pattern is analysed once, and its first pivots serve to the end.
  EXPECT_LE(calls.klu_analyses, 1);
  EXPECT_LE(calls.klu_factorisations, 2);
}

}  // namespace
}  // namespace moat
