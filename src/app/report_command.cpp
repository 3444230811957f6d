// The program behind `moat report`: the results in a folder on one screen.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <string>

#include "app/results_sheet.hpp"
#include "app/usage_errors.hpp"
#include "base/error.hpp"
#include "base/text/terminal.hpp"

namespace {

// Does not return where the page is opened.
int open_page(const std::filesystem::path& page) {
  const std::string path = std::filesystem::absolute(page).string();
  ::execlp("xdg-open", "xdg-open", path.c_str(), nullptr);
  throw moat::FileError{"there is no program xdg-open. Open " + path + " in a browser."};
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
  return run_command(app, "moat report", argc, argv, [&] {
    const ResultsSheet sheet = read_results(folder);
    print_text(std::cout, json ? json_of(sheet) : text_of(sheet));
    if (open && sheet.page.empty()) throw FileError{folder + ": there is no report.html to open."};
    return open ? open_page(sheet.page) : 0;
  });
}
