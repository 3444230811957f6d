#include "performance/vector_code.hpp"

#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "performance/command_output.hpp"

namespace moat::performance {
namespace {

const std::string sources = MOAT_SOURCES;

// Whose loops count, from the root of the sources.
const std::string file = "elements/link_block.hpp";

// The member function that a line is in: the last one before it whose head begins at most two blanks from the margin.
std::vector<std::string> functions_of_lines() {
  std::ifstream stream{sources + "/" + file};
  const std::regex head{R"(^ {0,2}[A-Za-z].*[ :]([A-Za-z_]+)\(.*)"};
  std::vector<std::string> names(1);  // lines count from 1
  for (std::string line; std::getline(stream, line);) {
    std::smatch match;
    names.push_back(std::regex_match(line, match, head) ? match[1].str() : names.back());
  }
  return names;
}

// Loops that became vector code, from what the compiler says about its optimisations.
struct Loops {
  std::map<std::string, std::set<int>> lines;  // by function
  std::set<int> bytes;                         // of a vector

  [[nodiscard]] int count() const {
    int sum = 0;
    for (const auto& [function, list] : lines) sum += static_cast<int>(list.size());
    return sum;
  }
};

Loops loops_in(const std::string& messages) {
  const std::vector<std::string> functions = functions_of_lines();
  const std::regex vectorised{file + R"(:(\d+):\d+: optimized: +loop vectorized using (\d+) byte vectors)"};
  Loops loops;
  for (std::sregex_iterator match{messages.begin(), messages.end(), vectorised}, end; match != end; ++match) {
    const auto line = std::stoul((*match)[1].str());
    loops.lines[functions.at(line)].insert(static_cast<int>(line));
    loops.bytes.insert(std::stoi((*match)[2].str()));
  }
  return loops;
}

std::string describe(const Loops& loops) {
  std::string text;
  for (const auto& [function, lines] : loops.lines) {
    text += (text.empty() ? "" : "; ") + function + " at line";
    for (const int line : lines) text += " " + std::to_string(line);
  }
  for (const int bytes : loops.bytes) text += "; vectors of " + std::to_string(bytes) + " bytes";
  return text;
}

// All at once. Returns what the compiler says of each.
std::vector<std::string> compile(const std::vector<std::string>& laws) {
  const std::string separator = "end of what the compiler says";
  std::string command = "cd '" + sources + "' || exit 1; folder=$(mktemp -d) || exit 1; ";
  for (const std::string& law : laws)
    command += "{ '" MOAT_CXX_COMPILER "' -std=c++20 " MOAT_COMPILE_FLAGS " -fPIC -I. -Isrc " MOAT_EIGEN_INCLUDE
               " -fopt-info-vec-optimized -DLAW=" +
               law +
               " -c benchmarks/performance/vector_code/link_block.cpp -o /dev/null || echo failed; } >\"$folder/" +
               law + "\" 2>&1 & ";
  command += "wait; ";
  for (const std::string& law : laws) command += "cat \"$folder/" + law + "\"; echo '" + separator + "'; ";
  command += "rm -r \"$folder\"";
  std::string output = output_of(command);
  std::vector<std::string> parts;
  for (std::size_t at; (at = output.find(separator)) != std::string::npos; output.erase(0, at + separator.size()))
    parts.push_back(output.substr(0, at));
  if (parts.size() != laws.size()) throw Error{"The shell could not run the compiler: " + command};
  return parts;
}

}  // namespace

void vector_code(Record& record, const Options&) {
  record.section("vector-code", "Loops over elements that the compiler turns into vector code");
  if (std::system("command -v '" MOAT_CXX_COMPILER "' >/dev/null 2>&1") != 0) {
    record.note("The compiler " MOAT_CXX_COMPILER " is not installed any more: left out.");
    return;
  }
  const std::vector<std::string> laws{"Linear", "Viscous", "Bilinear"}, messages = compile(laws);
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const std::string name = "LinkBlock<" + laws[i] + ">";
    if (messages[i].find("failed") != std::string::npos) {
      record.note("The compiler refused " + name + ": left out.");
      continue;
    }
    const Loops loops = loops_in(messages[i]);
    record.add({"vector code, loops of " + name, single(loops.count()), "", {}, describe(loops)});
  }
  record.note(
      "By g++ -fopt-info-vec-optimized with the flags users get; lines of " + file +
      ". What reads through indices (deformations from nodes, sums into forces and matrices) stays scalar: these "
      "flags allow no gather and no scatter.");
}

}  // namespace moat::performance
