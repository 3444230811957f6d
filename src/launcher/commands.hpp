// The commands of moat. Each throws Stop for wrong usage and where something does not build.
#pragma once

#include <filesystem>

#include "launcher/places.hpp"
#include "launcher/process.hpp"

namespace moat::launcher {

/// Brings the library and the script's program up to date, and becomes that program, or mpirun with so many `ranks` of
/// it where they are not 0. The first word is the script, the others are its options.
[[noreturn]] void run_script(const Places& places, int ranks, Command words);

/// Runs a job of several processes to its end and hands on its exit code.
///
/// mpirun kills its processes within two seconds of SIGINT or SIGTERM. Therefore the first of these signals, or SIGHUP,
/// reaches it as SIGUSR1, at which studies end in order; after it the exit code is 128 + the signal, or 0 where the job
/// had reached its end. The second one ends the job at once. The job ends too where this process is killed.
[[noreturn]] void become_job(const Command& command);

/// Writes a script to start from, examples/starter.cpp with the new name in it.
void new_script(const Places& places, const std::filesystem::path& typed);

/// Writes a folder with a project for CMake from examples/project and examples/starter.cpp.
void new_project(const Places& places, const std::filesystem::path& folder);

/// Becomes the program of a command that needs the library: motion, report, study.
[[noreturn]] void become_library_program(const Places& places, const std::string& command, const Command& words);

/// Builds the benchmark that the first word names and becomes it; the other words are its options.
[[noreturn]] void run_benchmark(const Places& places, const Command& words);

/// Builds the tests and hands over to the bootstrap script, which runs them with these words for CTest. With `all`
/// nothing may be skipped: more packages are installed, and a skipped test is a failure.
void run_tests(const Places& places, bool all, const Command& words);

/// Builds the headers that checks need and hands over to the bootstrap script, which runs those of these names, or all.
void run_checks(const Places& places, const Command& names);

/// Has the bootstrap script build the fuzz targets and run one of them.
void run_fuzzer(const Places& places, const std::string& target, int seconds);

}  // namespace moat::launcher
