// The program behind `moat motion`: the numbers of accelerograms.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "app/motion_sheet.hpp"
#include "app/usage_errors.hpp"
#include "base/error.hpp"
#include "base/parse_quantity.hpp"
#include "base/text/terminal.hpp"
#include "motions/readers/read_motion.hpp"
#include "output/files/csv_writer.hpp"

namespace {

using namespace moat;

struct Options {
  std::vector<std::string> files;
  std::string unit, folder;
  double damping = 0.05;
  bool json = false;
};

GroundMotion read(const std::string& file, const Options& options) {
  if (!options.unit.empty()) return read_motion(file, parse<Acceleration>("1 " + options.unit, "--unit"));
  try {
    return read_motion(file);
  } catch (const MissingUnit& error) {
    throw InputError{error.problem() + " Give the unit: --unit g, or --unit cm/s^2."};
  }
}

void show(const Options& options) {
  std::vector<MotionSheet> sheets;
  for (const std::string& file : options.files) sheets.push_back(sheet_of(read(file, options), options.damping));
  print_text(std::cout, options.json ? json_of(sheets) : text_of(sheets));
  if (options.folder.empty()) return;
  const std::filesystem::path folder{options.folder};
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError{folder.string() + ": cannot be created (" + error.message() + ")."};
  write_svg(spectrum_chart(sheets), folder / "spectrum.svg");
  write_csv(spectrum_table(sheets), folder / "spectrum.csv");
  print_text(std::cerr,
             "moat: wrote " + (folder / "spectrum.svg").string() + " and " + (folder / "spectrum.csv").string() + "\n");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Shows peaks, intensity, duration, pulse period and spectrum of accelerograms", "moat motion"};
  Options options;
  app.add_option("FILE", options.files, motion_formats())->required();
  app.add_option("--unit", options.unit, "unit of two-column files: g, cm/s^2 ...");
  app.add_option("--damping", options.damping, "damping ratio of the spectrum")->capture_default_str();
  app.add_option("--out", options.folder, "folder for spectrum.svg and spectrum.csv");
  app.add_flag("--json", options.json, "print JSON, all numbers in SI units");
  return run_command(app, "moat motion", argc, argv, [&] {
    show(options);
    return 0;
  });
}
