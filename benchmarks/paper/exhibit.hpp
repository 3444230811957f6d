// The output for a table or figure of the paper: text, tables, figures, checks and findings, for the page and the docs.
#pragma once

#include <moat.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "base/text/number_format.hpp"
#include "output/charts/chart.hpp"

namespace moat::paper {

using Cells = std::vector<std::string>;

struct ShownTable {
  std::string caption;
  Cells header;
  std::vector<Cells> rows;
};

enum class Verdict { holds, partly, fails };

/// One statement of the paper, tested.
struct Finding {
  std::string source;     ///< "4.3.1", "conclusion 2"
  std::string claim;      ///< in short, as the paper puts it
  std::string criterion;  ///< the computed number that decides
  std::string found;      ///< numbers
  Verdict verdict;
  std::string in_short{};  ///< takes the place of `found` in the documentation, where it is given
};

struct ShownFigure {
  std::string name;  ///< of the SVG file, without ending
  std::string caption;
  std::vector<Chart> charts;
  int panel_height = 300;
  int columns = 1;
};

/// Something that must hold.
struct Assertion {
  bool held;
  std::string text;
};

/// Writes figures and tables of numbers as files at once, and keeps all else for the page.
struct Exhibit {
  std::filesystem::path folder{};
  std::string id{}, title{};
  std::string source{};  ///< of the code, in this folder, without ending
  bool coarse = false;   ///< few points are enough, because only the page itself is being tested

  std::vector<Assertion> assertions{};
  std::size_t reported = 0;  ///< numbers that were put beside the paper's without a bound
  std::vector<Finding> findings{};
  std::string skipped{};      ///< why nothing of this was computed
  std::string failure{};      ///< the error with which it ended
  std::string as_html{};      ///< texts, tables and figures
  std::string as_markdown{};  ///< tables of the documentation

  void text(const std::string& paragraph);
  void table(const ShownTable& table);
  /// Shows a table on the page and in the documentation.
  void documented_table(const ShownTable& table);
  void figure(const ShownFigure& figure);
  /// Writes <name>.csv and names it on the page.
  void numbers(const std::string& name, const Table& table);
  void assert_that(bool held, const std::string& what);
  void report(std::size_t count) { reported += count; }
  void finding(const Finding& finding) { findings.push_back(finding); }

  /// Number of assertions that held.
  [[nodiscard]] std::size_t held() const;
  /// "30 asserted, 30 held."
  [[nodiscard]] std::string counts() const;
  /// Its section of the page.
  [[nodiscard]] std::string html() const;
  /// Its section of the documentation; empty where it has no documented table and all assertions held.
  [[nodiscard]] std::string markdown() const;
};

/// A table as HTML, escaped, and as Markdown.
std::string html_table(const ShownTable& table);
std::string markdown_table(const ShownTable& table);
/// "holds", "partly", "does not hold".
std::string name_of(Verdict verdict);

/// "1.032": computed over printed.
std::string ratio(double computed, double printed);

struct Totals {
  std::size_t asserted = 0, held = 0, reported = 0, skipped = 0;
  /// "289 asserted, 289 held, 220 reported"
  [[nodiscard]] std::string in_words() const;
};

Totals totals_of(const std::vector<Exhibit>& exhibits);

/// Writes <folder>/index.html, with all figures inside. Throws FileError.
void write_page(const std::filesystem::path& folder, const std::vector<Exhibit>& exhibits);

/// The documented tables, checks and findings in short as Markdown, with headings of third level.
std::string documentation(const std::vector<Exhibit>& exhibits);

// The tables and figures; those but table1 and pulse need the records.
void show_table1(Exhibit& exhibit);
void show_table2(Exhibit& exhibit);
void show_table3_fig6(Exhibit& exhibit);
void show_fig4(Exhibit& exhibit);
void show_fig5(Exhibit& exhibit);
void show_fig7(Exhibit& exhibit);
void show_fig8(Exhibit& exhibit);
void show_fig9(Exhibit& exhibit);
void show_fig10(Exhibit& exhibit);
void show_fig11(Exhibit& exhibit);
void show_pulse(Exhibit& exhibit);

}  // namespace moat::paper
