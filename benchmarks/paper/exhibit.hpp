// The output of a script of the benchmark: text, tables, figures, checks and findings, for the page and the docs.
#pragma once

#include <moat.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "output/charts/chart.hpp"

namespace moat::paper {

struct ShownTable {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

enum class Verdict { holds, partly, fails };

/// One statement of the paper, tested.
struct Finding {
  std::string source;     ///< "4.3.1", "conclusion 2"
  std::string claim;      ///< in short, as the paper puts it
  std::string criterion;  ///< the computed number that decides
  std::string found;      ///< numbers
  Verdict verdict;
};

struct ShownFigure {
  std::string name;  ///< of the SVG file, without ending
  std::string caption;
  std::vector<Chart> charts;
  int panel_height = 300;
  int columns = 1;
};

/// Collects the output of a script and writes it to <folder>/<id>.json, beside the figures and tables of numbers.
class Exhibit {
 public:
  Exhibit(std::filesystem::path folder, std::string id, std::string title, bool coarse);
  ~Exhibit();
  Exhibit(const Exhibit&) = delete;
  Exhibit& operator=(const Exhibit&) = delete;

  /// True if few points are enough, because only the page itself is being tested.
  [[nodiscard]] bool coarse() const { return coarse_; }
  [[nodiscard]] const std::string& id() const { return id_; }

  void text(const std::string& paragraph);
  void table(const ShownTable& table);
  void figure(const ShownFigure& figure);
  /// Writes <name>.csv and names it on the page.
  void numbers(const std::string& name, const Table& table);
  /// Something that must hold.
  void assert_that(bool held, const std::string& what);
  /// So many numbers were put beside the paper's without a bound.
  void report(std::size_t count);
  void finding(const Finding& finding);
  /// Nothing of this was computed.
  void skip(const std::string& reason);

  /// Writes the JSON file. True if all that was asserted held.
  bool write() const;

 private:
  struct Content;
  std::filesystem::path folder_;
  std::string id_;
  bool coarse_;
  std::unique_ptr<Content> content_;
};

/// The main() of a script: reads --out FOLDER and --coarse, shows, writes. Exit code 0 if all that was asserted held,
/// 1 if not or after an error, which is printed on standard error; 2 for wrong usage.
int run_exhibit(int argc, char** argv, const std::string& id, const std::string& title,
                const std::function<void(Exhibit&)>& show);

/// "12.35" for 12.3456 and 2 decimals.
std::string fixed(double value, int decimals);
/// "1.032": computed over printed.
std::string ratio(double computed, double printed);

}  // namespace moat::paper
