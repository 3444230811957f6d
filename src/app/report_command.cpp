// The program behind `moat report`: the results in a folder on one screen.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "app/results_sheet.hpp"
#include "app/usage_errors.hpp"
#include "base/error.hpp"

namespace {

// Does not return where the page is opened.
int open_page(const std::filesystem::path& page) {
  const std::string path = std::filesystem::absolute(page).string();
  ::execlp("xdg-open", "xdg-open", path.c_str(), nullptr);
  std::fprintf(stderr, "moat: error: there is no program xdg-open. Open %s in a browser.\n", path.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace moat;
  CLI::App app{"Shows the results in a folder on one screen", "moat report"};
  std::string folder;
  bool json = false, open = false;
  app.add_option("DIR", folder, "a folder of results, such as results/01_moat_wall")->required();
  app.add_flag("--json", json, "print JSON, all numbers in SI units");
  app.add_flag("--open", open, "open report.html too, with xdg-open");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {
    return app.exit(wish);
  } catch (const CLI::ParseError& error) {
    std::fputs(usage_error(app, "moat report", error).c_str(), stderr);
    return 2;
  }
  try {
    const ResultsSheet sheet = read_results(folder);
    std::fputs((json ? json_of(sheet) : text_of(sheet)).c_str(), stdout);
    std::fflush(stdout);
    if (open && sheet.page.empty()) throw FileError{folder + ": there is no report.html to open."};
    if (open) return open_page(sheet.page);
  } catch (const Error& error) {
    std::fprintf(stderr, "moat: error: %s\n", error.what());
    return 1;
  }
  return 0;
}
