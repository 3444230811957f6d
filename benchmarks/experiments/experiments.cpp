// moat beside measured tests and published buildings: writes the tables of docs/verification/experiments.md. Called by
// ./moat bench experiments.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>

#include "app/command_line.hpp"
#include "base/error.hpp"
#include "documentation_section.hpp"
#include "experiments/sections.hpp"
#include "peers/opensees.hpp"

namespace moat::experiments {
namespace {

struct Part {
  std::string name, folder;  // its section of the document, and the folder of its data
  std::string (*compare)(const Folders&);
};

void run(const Folders& folders, bool write_docs) {
  if (write_docs && !peers::OpenSees::find(folders.out / "opensees"))
    throw InputError{"--write-docs needs OpenSees (OPENSEES): without it the yielding building would lose a column."};
  for (const auto& [name, folder, compare] : {Part{"buffalo", "buffalo", buffalo}, Part{"kharaz", "kharaz", kharaz},
                                              Part{"yielding building", "smart_base_isolated", yielding_building},
                                              Part{"benchmark building", "smart_base_isolated", benchmark_building}}) {
    if (folders.data.empty() || !std::filesystem::is_directory(folders.data / folder)) {
      std::cout << name << ": skipped. "
                << (folders.data.empty() ? "MOAT_EXPERIMENTS is not set."
                                         : (folders.data / folder).string() + " is not a folder.")
                << "\n\n";
      continue;
    }
    const std::string text = compare(folders);
    std::cout << "### " << name << "\n\n" << text << std::endl;
    const std::filesystem::path file = folders.out / (name + ".md");
    std::ofstream output{file};
    output << text;
    if (!output.flush()) throw FileError{file.string() + ": cannot be written."};
    if (write_docs) replace_section(MOAT_VERIFICATION, "experiments, " + name, text);
  }
  std::cout << "Tables and pictures: " << folders.out.string() << "\n";
}

}  // namespace
}  // namespace moat::experiments

int main(int argc, char** argv) {
  CLI::App app{"moat beside measured tests and published buildings", "moat bench experiments"};
  app.footer(
      "The data are in the folder that MOAT_EXPERIMENTS names: buffalo/*.csv, kharaz/oblique_impact.csv and\n"
      "smart_base_isolated/. A part without its data is skipped.");
  moat::experiments::Folders folders{.data = {}, .out = "results/experiments"};
  bool write_docs = false;
  app.add_option("--out", folders.out, "folder for tables and pictures")->capture_default_str();
  app.add_flag("--write-docs", write_docs, "also bring docs/verification/experiments.md up to date");
  return moat::run_command(app, "moat bench experiments", argc, argv, [&] {
    if (const char* data = std::getenv("MOAT_EXPERIMENTS")) folders.data = data;
    std::filesystem::create_directories(folders.out);
    moat::experiments::run(folders, write_docs);
    return 0;
  });
}
