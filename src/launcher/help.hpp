// The texts of the help: one sentence for each command, and examples and explanations after its options.
#pragma once

namespace moat::launcher::help {

inline constexpr char moat[] =
    "moat computes how base-isolated buildings move in an earthquake and how they hit their moat wall.";
inline constexpr char after_moat[] = R"(
Start here:
  ./moat run examples/01_moat_wall.cpp            the first tour; it ends by naming the folder of its results
  ./moat run examples/01_moat_wall.cpp --help     the options of that script

  ./moat new tower.cpp                            a script of your own to change
  ./moat motion record.AT2                        peaks, duration and spectrum of an accelerogram
  ./moat report results/01_moat_wall              the results in a folder on one screen

Exit code: 0 done; 1 failed: bad input, or a build that stops; 2 wrong usage; 3 packages that cannot be installed, or a
step that did not converge.

Every command explains itself: ./moat run --help. Progress goes to standard error. Compiled scripts and logs are kept
in build/, or in ~/.cache/moat (XDG_CACHE_HOME) where that cannot be written; ./moat doctor shows where.)";

struct Command {
  const char *name, *description, *footer;
};

inline constexpr Command commands[] = {
    {"run", "Compile and run an input script", R"(
./moat run [--ranks N] SCRIPT.cpp [options of the script]

Compiles an input script, which is a C++ program that includes <moat.hpp>, and runs it. The first time it also
installs the Debian packages that are missing and builds the library; an unchanged script starts at once.

  ./moat run examples/01_moat_wall.cpp                  run the first tour
  ./moat run examples/01_moat_wall.cpp --help           the options of the script, not of moat
  ./moat run examples/01_moat_wall.cpp --gap "15 cm"    everything after the script's name goes to the script
  cd ~/study && ~/moat/moat run tower.cpp               a script may lie anywhere; results land where you are
  ./moat run --ranks 4 study.cpp                        a study on four processes of MPI, which may be on many nodes
  ./moat run tower.cpp --json | jq .impacts             for programs: standard output holds JSON and nothing else

A script may include files beside it: #include "my_law.hpp". It is compiled again when it, such a file or the
library has changed. The compiled programs in build/scripts/ may be deleted at any time.

Options of most scripts, which its own --help explains: --out, --force, --step, --tolerance, --integrator, --end,
--frame-interval, --checkpoint, --resume, --check, --sensitivity, --no-sensitivity, --quiet, --json, --record,
--record-2, --record-up, --record-unit, --record-step, --record-columns, --records-table, --incidence; of studies
--threads, --case, --cases, --retry, --accept-changes.

Exit code: that of the script; 1 when building fails, 2 for wrong usage, 3 when packages cannot be installed.)"},
    {"new", "Start a script of your own", R"(
Writes a short script for you to change; "tower" means tower.cpp. An existing file is never overwritten.

  ./moat new ~/study/tower.cpp && ./moat run ~/study/tower.cpp
  ./moat new tower --project                      a folder with CMakeLists.txt, tower.cpp and README.md, for programs
                                                  of your own that use the library

Exit code: 0 done, 2 a name that cannot be used.)"},
    {"test", "Build and run the tests", R"(
./moat test [--all] [options of ctest]

Installs missing packages, builds the library with its tests, runs them, and gives the reasons of those that were
skipped. Exit code: that of ctest.

  ./moat test                                     all tests
  ./moat test -R Gap                              those whose name matches Gap
  MOAT_RECORDS=~/records ./moat test              with recorded ground motions

Recorded accelerograms may not be redistributed and are not part of moat: tests that need them look for the files
in the folder that the environment variable MOAT_RECORDS names, and are skipped when it is not set.

With --all nothing may be skipped: it installs the programs that some tests need (cmake/packages/all.txt), demands
MOAT_RECORDS, and fails when a test was skipped: MOAT_FORMATS and MOAT_EXPERIMENTS name folders for tests, OPENSEES a
program (CONTRIBUTING.md).)"},
    {"bench", "Compute the benchmarks: the paper, accuracy, experiments, isolators, performance, OpenSees", R"(
./moat bench paper [--out FOLDER] [--write-docs] [--coarse]
./moat bench accuracy [--out FOLDER] [--write-docs] [--only-random] [--models N] [--seed N] [--threads N] [--csv FILE]
./moat bench experiments [--out FOLDER] [--write-docs]
./moat bench isolators [--write-docs]
./moat bench performance [--out FOLDER] [--write-docs] [--only SECTION] [--rounds N] [--quick]
./moat bench peers [--out FOLDER] [--write-docs] [--rounds N]

paper: every table and figure of Zhao, Liu & Li (2017) beside the printed numbers, on a page to open from disk,
results/paper/index.html. accuracy: error of the peaks against the number of steps, and errors over 200 random models
against an independent reference, in about two minutes of processor time. experiments: measured tests and published
buildings, from the folder that MOAT_EXPERIMENTS names. isolators: bearings whose lead or sliding surface heats, beside
a published test and another program. performance: ratios taken in one run, each with its spread, in under ten minutes;
it installs the libraries compared with moat (cmake/packages/bench.txt). peers: moat beside OpenSees, the program that
OPENSEES names or the one on the path. --write-docs brings the tables of docs up to date.

  MOAT_RECORDS=~/records ./moat bench paper       without recorded motions: Table 1 and a synthetic pulse
  ./moat bench paper --help                       its options, from the program itself, which is built first

Exit code: of paper 0 if all that is asserted holds, else 1; of the others 0 when they ran. 1 when building fails, 2 for
wrong usage, 3 when packages cannot be installed.)"},
    {"motion", "Show peaks, duration, pulse period and spectrum of accelerograms", R"(
./moat motion FILE... [--unit g] [--step 0.01s] [--columns x,y] [--damping 0.05] [--out FOLDER] [--json]

Shows for every channel of every file PGA, PGV, PGD, Arias intensity, significant duration (5 to 95 %), the period of
its pulse (at the largest pseudo-velocity with 5 % damping), and one table of pseudo-accelerations. It reads files of PEER, K-NET,
KiK-net, AFAD, ESM, CWA, GeoNet, COSMOS, CSMIP, SMC, BHRC, RENADIC and UNAM, and columns of plain text.

  ./moat motion RSN1108_KOBE_KBU000.AT2           one record
  ./moat motion records/*.AT2 --out spectra       all of them; also spectra/spectrum.svg and spectrum.csv
  ./moat motion columns.txt --unit gal            plain text does not say its unit
  ./moat motion record.V2 --json                  for programs, all numbers in SI units

Exit code: 0 done, 1 a file that cannot be read, 2 wrong usage.)"},
    {"report", "Show the results in a folder on one screen", R"(
Shows title, motion, the largest peak of every quantity, the smallest clearance left, impacts and warnings of a run; of
studies their progress and failures.

  ./moat report results/01_moat_wall              the results of the first tour
  ./moat report results/01_moat_wall --open       and its page in the browser, by xdg-open
  ./moat report results/01_moat_wall --json       for programs, all numbers in SI units

Exit code: 0 done, 1 no results there or no browser, 2 wrong usage.)"},
    {"study", "Show, export or merge the files of studies", R"(
A script with script.study() keeps its cases in a file, results/<script>/study.db, and goes on from it when it is run
again. Give this folder, or such a file, which may be read while the script computes.

  ./moat study show results/10_gap_study               progress, failures, slowest cases
  ./moat study export results/10_gap_study             one row per case as CSV, for pandas, R and MATLAB; --out FILE
  ./moat study merge all.db part_*.db                  cases that --case and --cases computed, in one file

Exit code: 0 done, 1 a file that cannot be read, or studies that differ, 2 wrong usage.)"},
    {"check", "Check the code: format, mistakes, sanitizers and more", R"(
For those who change moat. Runs checks one after the other, goes on when one fails, and exits with 1 if one did.

  format       clang-format finds nothing to change
  shell        shellcheck finds nothing in the shell scripts
  package      a program builds and runs with the installed package
  cppcheck     cppcheck finds nothing in the library (cmake/cppcheck.txt)
  tidy         clang-tidy finds nothing in the library, and compiles each source alone (.clang-tidy)
  sanitizers   all tests pass with a library that has the address and undefined-behaviour sanitizers, and reach 90 %
               of its lines and 95 % of those of the parsers (build/asan)
  threads      studies of four threads pass with the thread sanitizer (build/tsan)
  fuzz         10,000 damaged inputs of every reader end in a result or a refusal (build/fuzz)
  faults       runs and studies that are killed, stopped or lack disk leave whole files; 4 minutes
  mutants      the tests see deliberate mistakes in a copy of the code (tests/mutation)

  ./moat check format shell                       two of them, in a minute)"},
    {"fuzz", "Try damaged inputs on one of the readers", R"(
./moat fuzz TARGET [SECONDS]

For those who change moat. Builds the readers with sanitizers and lets libFuzzer change valid inputs (build/fuzz/corpus)
for 60 seconds, or as long as given. An input that ends in more than a refusal is kept in build/fuzz/found. With
MOAT_FORMATS and MOAT_RECORDS, folders of records, these files are inputs too.

  record  record_table  matrix  sap2000  table  spectrum  quantity  command_line  checkpoint  study_file  compile_errors

  ./moat fuzz record 600                          files of all networks, for ten minutes

Exit code: 0 nothing found, 1 an input was kept, 2 wrong usage.)"},
    {"completion", "Print a script that completes this command line in bash", R"(
  source <(./moat completion bash)                put this line, with the whole path of moat, into ~/.bashrc)"},
    {"doctor", "Show installed and missing packages", R"(
Shows machine, compiler, the folders that moat uses, and the version of every package that moat or one of its commands
needs. It names the command that installs missing packages, and changes nothing.

Exit code: 0 moat can run, 1 something that it needs is missing.)"},
};

/// The words that it offers stand in the help of the commands: options, checks, and the words behind bench and study.
inline constexpr char bash_completion[] =
    R"bash(# Completion of the command moat for bash. In ~/.bashrc: source <(moat completion bash)
_moat() {
  local moat=${COMP_WORDS[0]/#\~/$HOME} command= current=${COMP_WORDS[COMP_CWORD]} name
  ((COMP_CWORD == 1)) || command=${COMP_WORDS[1]}
  mapfile -t COMPREPLY < <(compgen -W "$("$moat" $command --help 2>/dev/null |
    grep -oE -- '--[a-z][a-z-]*|^  [a-z]+ |moat (bench|study) [a-z]+' | grep -oE -- '[a-z-]+ *$' | sort -u)" -- "$current")
  [[ $command =~ ^(run|motion|report|study)$ ]] || return 0
  while IFS= read -r name; do
    [[ $command == run && ! -d $name && $name != *.cpp && $COMP_CWORD == 2 ]] || COMPREPLY+=("$name")
  done < <(compgen -f -- "$current")
  compopt -o filenames 2>/dev/null || true
}
complete -F _moat moat ./moat
)bash";

}  // namespace moat::launcher::help
