// The figures of a run, for people and for programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace moat::performance {

/// The spread of repeated measurements; low and high are quartiles.
struct Spread {
  double median = 0.0, low = 0.0, high = 0.0;
  int count = 1;
};

/// Returns the spread of a value that was measured or counted once.
inline Spread single(double value) { return {value, value, value, 1}; }

inline Spread scaled(Spread value, double factor) {
  return {value.median * factor, value.low * factor, value.high * factor, value.count};
}

struct Target {
  double bound = 0.0;
  bool at_most = true;  ///< or at least
};

struct Figure {
  std::string name;  ///< "equal accuracy, GBZ000, moat adaptive at 0.1 %"
  Spread value;
  std::string unit = {};  ///< empty for a ratio
  std::optional<Target> target = {};
  std::string detail = {};  ///< in brackets behind the value

  /// Whether the median keeps to the target, if there is one.
  [[nodiscard]] bool held() const;
};

/// Processor, number of cores, compiler and flags.
std::string machine();
/// Three digits.
std::string short_text(double value);
/// Without its unit; "**missed**" behind it where a target is.
std::string cell(const Figure& figure);
/// "at most 3"
std::string text(const Target& target);

/// A table of docs/performance.md.
class Table {
 public:
  explicit Table(std::vector<std::string> header) : header_{std::move(header)} {}
  /// Into the row that begins with `row`, made when first named.
  void put(const std::string& row, const std::string& column, const std::string& text);
  [[nodiscard]] std::string markdown() const;

 private:
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

/// Prints every figure at once and keeps it, section by section. All figures go into performance.json; the document
/// gets tables and notes.
class Record {
 public:
  /// The following belongs to this section. `name` stands in --only and in the markers of docs/performance.md.
  void section(const std::string& name);
  /// Prints `name  value  unit  (spread)` and whether the target was held.
  const Figure& add(Figure figure);
  /// Something a reader has to know: "OpenSees is not installed: it is left out."
  void note(const std::string& sentence);
  void table(const Table& table);

  [[nodiscard]] int targets() const;
  [[nodiscard]] int missed() const;
  /// FOLDER/performance.json. Throws FileError.
  void write(const std::filesystem::path& folder) const;
  /// Brings the sections that were run up to date in a Markdown file; each ends with the machine and the commit it was
  /// measured on. Throws FileError.
  void write_documentation(const std::filesystem::path& document) const;

 private:
  struct Section {
    std::string name;
    std::vector<Figure> figures;
    std::vector<std::string> tables, notes;
  };

  std::vector<Section> sections_;
};

}  // namespace moat::performance
