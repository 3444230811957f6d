// What was measured, for people and for programs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/chart.hpp"

namespace moat::performance {

/// Of repeated measurements; low and high are quartiles.
struct Spread {
  double median = 0.0, low = 0.0, high = 0.0;
  int count = 1;
};

/// Of something that was measured or counted once.
inline Spread single(double value) { return {value, value, value, 1}; }

struct Target {
  double bound = 0.0;
  bool at_most = true;  ///< or at least
};

struct Figure {
  std::string name;  ///< "equal accuracy, GBZ000, moat adaptive at 0.1 %"
  Spread value;
  std::string unit;  ///< empty for a ratio
  std::optional<Target> target = {};
  std::string detail = {};  ///< what else a reader may want to know, in brackets

  /// Whether the median keeps to the target, if there is one.
  [[nodiscard]] bool held() const;
};

/// Prints every line at once and keeps it, section by section.
class Record {
 public:
  /// What follows belongs to this section. `name` is what --only and the markers in docs/performance.md call it.
  void section(const std::string& name, const std::string& title);
  /// Prints `name  value  unit  (spread)` and whether the target was held.
  void add(Figure figure);
  /// What a reader has to know: "Octave is not installed: left out."
  void note(const std::string& sentence);
  /// An SVG that write() puts beside the figures.
  void chart(const std::string& file_name, const std::string& svg);
  /// Draws charts as svg_text does and keeps their points beside the figures as well.
  void chart(const std::string& file_name, const std::vector<Chart>& charts, int width = 1000, int height = 420,
             int columns = 1);

  [[nodiscard]] int targets() const;
  [[nodiscard]] int missed() const;
  /// FOLDER/performance.json and the charts. Throws FileError.
  void write(const std::filesystem::path& folder) const;
  /// Brings the sections that were run up to date in a Markdown file, and the charts in `images` beside it.
  /// Throws FileError.
  void write_documentation(const std::filesystem::path& document) const;

 private:
  struct Drawing {
    std::string file_name, svg;
    std::vector<Chart> charts;
  };
  struct Section {
    std::string name, title;
    std::vector<Figure> figures;
    std::vector<std::string> notes;
    std::vector<Drawing> drawings;
  };

  [[nodiscard]] static std::string markdown(const Section& section);

  std::vector<Section> sections_;
};

}  // namespace moat::performance
