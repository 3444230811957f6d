#include "include_rules.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

namespace moat::architecture {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> roots{"src", "materials", "elements", "structures", "analyses"};

/// The folders that a folder may include besides itself. src/app and src/moat.hpp ("the top") may include everything.
const std::map<std::string, std::set<std::string>> allowed{
    {"src/base", {}},
    {"src/launcher", {"src/base"}},
    {"materials", {"src/base"}},
    {"src/model", {"src/base"}},
    {"elements", {"src/base", "src/model", "materials"}},
    {"structures", {"src/base", "src/model", "src/solvers", "elements", "materials"}},
    {"src/solvers", {"src/base"}},
    {"src/motions", {"src/base"}},
    {"src/output", {"src/base", "src/model", "src/motions", "materials"}},
    {"src/report", {"src/base", "src/motions", "src/output"}},
    {"src/study", {"src/base", "src/output", "src/report"}},
    {"analyses", {"src/base", "src/model", "src/solvers", "src/motions", "src/output", "src/study"}},
    {"src/design",
     {"src/base", "src/model", "src/output", "src/motions", "src/report", "src/study", "materials", "elements",
      "analyses"}},
};
const std::string top = "src/app or src/moat.hpp";

struct Include {
  int line;
  bool quoted;
  std::string name;
};

std::vector<Include> includes_in(const std::string& text) {
  static const std::regex directive{R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])"};
  std::vector<Include> found;
  std::istringstream stream{text};
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, directive)) found.push_back({number, match[1] == "\"", match[2]});
  }
  return found;
}

/// The folder whose rule holds for a file, nothing when no rule is known.
std::optional<std::string> layer_of(const std::string& path) {
  if (path == "src/moat.hpp" || path.starts_with("src/app/")) return top;
  for (const auto& [folder, others] : allowed) {
    if (path.starts_with(folder + "/")) return folder;
  }
  return std::nullopt;
}

/// The file that alone may include a library, and the names of the headers of the library.
const std::map<std::string, std::regex> only_in{
    {"src/output/vtk/vtk_writers.cpp", std::regex{R"(^(SMP/\w+/)?vtk\w*\.h$)"}},
    {"src/solvers/newton.cpp", std::regex{R"(^(trilinos/)?(NOX|Teuchos)\w*\.(H|hpp)$)"}},
    {"src/solvers/factorisation.cpp", std::regex{R"(^(suitesparse/)?(klu|btf|amd|colamd)\.h$)"}},
};

bool is_header(const std::string& path) { return !path.ends_with(".cpp"); }

bool belongs_behind_a_cpp_file(const std::string& include) {
  static const std::regex library{
      R"(^(trilinos/|suitesparse/|vtk-?[0-9.]*/)?)"
      R"((NOX|Teuchos|Epetra|Thyra|Tpetra|Kokkos|Amesos|LOCA|vtk)[A-Za-z0-9_]*\.(h|H|hpp)$|)"
      R"(^(sqlite3|mpi)\.h$|)"
      R"(^(suitesparse/)?(klu|btf|amd|camd|colamd|cs|cholmod|umfpack|SuiteSparse[A-Za-z_]*)\.(h|hpp)$)"};
  return std::regex_search(include, library);
}

bool is_gpl(const std::string& include) {
  static const std::regex part{
      R"(^(suitesparse/)?(cholmod|umfpack|SuiteSparseQR)|^Eigen/(CholmodSupport|UmfPackSupport|SPQRSupport)$)"};
  return std::regex_search(include, part);
}

using Graph = std::map<std::string, std::set<std::string>>;

/// Each circle once, as "a.hpp -> b.hpp -> a.hpp".
std::vector<std::string> circles_in(const Graph& graph) {
  std::vector<std::string> circles, path;
  std::set<std::string> finished;
  const std::function<void(const std::string&)> visit = [&](const std::string& file) {
    const auto seen = std::find(path.begin(), path.end(), file);
    if (seen != path.end()) {
      std::string circle;
      for (auto step = seen; step != path.end(); ++step) circle += *step + " -> ";
      circles.push_back(circle + file);
      return;
    }
    if (finished.contains(file)) return;
    path.push_back(file);
    if (const auto next = graph.find(file); next != graph.end()) {
      for (const std::string& included : next->second) visit(included);
    }
    path.pop_back();
    finished.insert(file);
  };
  for (const auto& [file, others] : graph) visit(file);
  return circles;
}

}  // namespace

std::vector<SourceFile> read_sources(const fs::path& checkout) {
  std::vector<SourceFile> sources;
  for (const std::string& root : roots) {
    for (const auto& entry : fs::recursive_directory_iterator{checkout / root}) {
      const std::string extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".h" && extension != ".cpp") continue;
      std::ostringstream text;
      text << std::ifstream{entry.path()}.rdbuf();
      sources.push_back({fs::relative(entry.path(), checkout).generic_string(), text.str()});
    }
  }
  std::sort(sources.begin(), sources.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return sources;
}

std::vector<std::string> broken_rules(const std::vector<SourceFile>& sources) {
  std::set<std::string> project;
  for (const SourceFile& source : sources) project.insert(source.path);

  // In the order of the compiler: beside the file, then the include folders.
  const auto resolve = [&](const std::string& from, const Include& include) -> std::optional<std::string> {
    std::vector<fs::path> candidates{fs::path{"src"} / include.name, include.name};
    if (include.quoted) candidates.insert(candidates.begin(), fs::path{from}.parent_path() / include.name);
    for (const fs::path& candidate : candidates) {
      if (const std::string path = candidate.lexically_normal().generic_string(); project.contains(path)) return path;
    }
    return std::nullopt;
  };

  std::vector<std::string> broken;
  Graph graph;
  for (const SourceFile& source : sources) {
    const std::optional<std::string> layer = layer_of(source.path);
    if (!layer) broken.push_back(source.path + " lies in a folder that has no rule for its includes");
    for (const Include& include : includes_in(source.text)) {
      const std::string place = source.path + ":" + std::to_string(include.line) + " ";
      if (is_gpl(include.name)) broken.push_back(place + "includes " + include.name + ", which is under the GPL");
      if (is_header(source.path) && belongs_behind_a_cpp_file(include.name)) {
        broken.push_back(place + "includes " + include.name + " in a header; it belongs in a .cpp file");
      }
      for (const auto& [file, library] : only_in)
        if (source.path != file && !is_header(source.path) && std::regex_search(include.name, library))
          broken.push_back(place + "includes " + include.name + ", which belongs in " + file);
      const std::optional<std::string> target = resolve(source.path, include);
      if (!target) {
        if (include.quoted) broken.push_back(place + "includes \"" + include.name + "\", no file of the project");
        continue;
      }
      graph[source.path].insert(*target);
      const std::optional<std::string> other = layer_of(*target);
      if (!layer || !other || *layer == top || *layer == *other) continue;
      if (!allowed.at(*layer).contains(*other)) {
        broken.push_back(place + "includes " + *target + ", but " + *layer + " must not know " + *other);
      }
    }
  }
  for (const std::string& circle : circles_in(graph)) broken.push_back("files include each other: " + circle);
  return broken;
}

}  // namespace moat::architecture
