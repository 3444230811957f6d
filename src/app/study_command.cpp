// The program behind `moat study`: reads the files of studies.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "base/text/terminal.hpp"
#include "study/file/store.hpp"
#include "study/study_report.hpp"
#include "study/study_text.hpp"

int main(int argc, char** argv) {
  using namespace moat;
  CLI::App app{"Reads and merges studies, the .db files in results folders", "moat study"};
  app.require_subcommand(1);
  app.footer(
      "moat study show results/10_gap_study                     progress, failures, slowest cases\n"
      "moat study export results/10_gap_study                   one row per case as CSV, for pandas, R and MATLAB\n"
      "moat study merge all.db part_1.db part_2.db              parts that --case and --cases computed, in one file\n"
      "A study may be read while it is computed. Merge all parts into the file that the script uses, and run the\n"
      "script again: it finds every case there and goes on to its answers.");
  std::string file, out;
  std::vector<std::string> parts;
  CLI::App* const show = app.add_subcommand("show", "Print progress, failures and slowest cases");
  show->add_option("FILE", file, "a study, or the folder of its results")->required();
  CLI::App* const csv = app.add_subcommand("export", "Write one row per case as CSV");
  csv->add_option("FILE", file, "a study, or the folder of its results")->required();
  csv->add_option("--out", out, "the file to write; by default the study's name with .csv");
  CLI::App* const merge = app.add_subcommand("merge", "Put the cases of parts into one study");
  merge->add_option("INTO", file, "the study to make or to add to")->required();
  merge->add_option("PART", parts, "studies")->required();
  return run_command(app, "moat study", argc, argv, [&] {
    if (!*merge && std::filesystem::is_directory(file)) file = std::filesystem::path{file} / "study.db";
    if (*csv) {
      std::filesystem::path path{out};
      if (out.empty()) require_own(path = std::filesystem::path{file}.replace_extension(".csv"));
      write_csv(read_study(file).result, path);
      print_text(std::cout, path.string() + "\n");
      return 0;
    }
    if (*merge) merge_studies(file, {parts.begin(), parts.end()});
    print_text(std::cout, description_of(read_study(file)));
    return 0;
  });
}
