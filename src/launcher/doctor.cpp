#include "launcher/doctor.hpp"

#include <sys/utsname.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "base/terminal.hpp"
#include "launcher/process.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

void print(const std::string& name, const std::string& value) {
  std::printf("%-26s %s\n", name.c_str(), printable(value).c_str());
}

std::string first_line_of(const Command& command) {
  const std::vector<std::string> lines = lines_of(output_of(command).text);
  return lines.empty() ? "missing" : lines.front();
}

std::string operating_system() {
  const std::string key = "PRETTY_NAME=\"";
  for (const std::string& line : lines_of(text_of("/etc/os-release")))
    if (line.starts_with(key)) return line.substr(key.size(), line.size() - key.size() - 1);
  return "unknown";
}

std::string processor() {
  utsname name{};
  ::uname(&name);
  return std::string{name.machine} + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores";
}

void print_machine(const Places& places) {
  print("operating system", operating_system());
  print("processor", processor());
  print("compiler", first_line_of({"c++", "--version"}));
  print("CMake", first_line_of({"cmake", "--version"}));
  print("Ninja", first_line_of({MOAT_NINJA, "--version"}));
  print("library", places.build.string() + (places.build_is_ours() ? "" : " (cannot be written: used as it is)"));
  print("scripts, logs", places.work.string());
  const char* records = std::getenv("MOAT_RECORDS");
  print("recorded motions", records == nullptr ? "MOAT_RECORDS is not set" : records);
}

std::vector<std::string> packages_of(const Places& places, const std::string& list) {
  std::vector<std::string> packages;
  for (const std::string& line : lines_of(text_of(places.root / "cmake" / "packages" / (list + ".txt"))))
    if (!line.starts_with('#')) packages.push_back(line);
  return packages;
}

// Of installed packages.
std::map<std::string, std::string> versions_of(const std::vector<std::string>& packages) {
  Command query{"dpkg-query", "-W", "-f=${db:Status-Status} ${Package} ${Version}\n"};
  query.insert(query.end(), packages.begin(), packages.end());
  std::map<std::string, std::string> versions;
  for (const std::string& line : lines_of(output_of(query).text)) {
    const std::size_t first = line.find(' '), second = line.find(' ', first + 1);
    if (line.starts_with("installed ")) versions[line.substr(first + 1, second - first - 1)] = line.substr(second + 1);
  }
  return versions;
}

}  // namespace

int doctor(const Places& places) {
  print_machine(places);
  if (places.installed()) {
    std::puts("moat is installed as a package: apt looks after the packages that it needs.");
    return 0;
  }
  if (output_of({"dpkg-query", "--version"}).exit_code != 0) {
    std::puts(
        "This is not Debian: packages cannot be looked up. moat needs the counterparts of these Debian packages:");
    for (const char* list : {"run", "test"}) std::puts(joined(packages_of(places, list)).c_str());
    return exit_failed;
  }
  struct List {
    const char *name, *only_for;
  };
  std::vector<std::string> missing;
  for (const List& list :
       {List{"run", ""}, List{"test", ""}, List{"all", " (only for ./moat test --all)"},
        List{"mpi", " (only for ./moat run --ranks)"}, List{"bench", " (only for ./moat bench performance)"},
        List{"check", " (only for ./moat check)"}}) {
    const std::vector<std::string> packages = packages_of(places, list.name);
    const std::map<std::string, std::string> versions = versions_of(packages);
    for (const std::string& package : packages) {
      const auto version = versions.find(package);
      print(package, version == versions.end() ? std::string{"missing"} + list.only_for : version->second);
      if (version == versions.end() && *list.only_for == '\0') missing.push_back(package);
    }
  }
  if (missing.empty()) return 0;
  std::printf("\nInstall missing packages with\n  apt-get install --no-install-recommends %s\n",
              joined(missing).c_str());
  return exit_failed;
}

}  // namespace moat::launcher
