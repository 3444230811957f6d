// Every text field of results, studies and sheets with texts that try to be more than text.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/results.hpp"
#include "base/text/terminal.hpp"
#include "base/text/utf8_text.hpp"
#include "design/sheet_page.hpp"
#include "hostile_strings.hpp"
#include "in_folder.hpp"
#include "moat.hpp"
#include "output/vtk/frame_recorder.hpp"
#include "study/study_report.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using namespace units;
using testing::read_file;

struct Recorder final : QuantityRecorder {
  explicit Recorder(std::string text) : name{std::move(text)} {}
  std::vector<OfferedQuantity> quantities() const override { return {{name, name, name}}; }
  void sample(const StepView& view, std::span<double> values) const override { values[0] = view.ground_acceleration.x; }
  std::string name;
};

// A node refuses some of the texts; the same ones behind a letter are in order.
std::string as_name(const std::string& text) {
  const bool is_formula = !text.empty() && std::string{"=+-@"}.find(text.front()) != std::string::npos;
  return (is_formula ? "a" : "") + (is_utf8(text) ? text : as_utf8(text));
}

class Hostile : public testing::InFolder {
 protected:
  // Whether the text runs, or leaves its field, in any file of the folder.
  void expect_harmless_files(const fs::path& in, const std::string& text) const {
    for (const auto& entry : fs::recursive_directory_iterator{folder}) {
      const fs::path path = fs::relative(entry.path(), folder);
      EXPECT_EQ(*path.begin(), in) << path << " lies outside";
      EXPECT_NE(path.filename(), "pwned") << path;
      EXPECT_EQ(printable(path.string()), path.string());
      if (!entry.is_regular_file()) continue;
      SCOPED_TRACE(path);
      const std::string kind = path.extension(), content = read_file(entry.path());
      if (kind == ".db") continue;
      EXPECT_TRUE(is_utf8(content));
      if (kind == ".csv") expect_harmless_table(content);
      EXPECT_TRUE(kind != ".json" || nlohmann::json::accept(content));
      if (kind != ".html" && kind != ".svg" && kind != ".vtu" && kind != ".vtt" && kind != ".pvd") continue;
      if (text.find('<') != std::string::npos) {
        if (const std::size_t at = content.find(text); at != std::string::npos)
          ADD_FAILURE() << "not escaped: " << printable(content.substr(at - std::min<std::size_t>(at, 60), 120));
      }
      for (const char* mark : {"\xE2\x80\xAE", "\xE2\x81\xA7", "\xEF\xBF\xBE", "\xEF\xBF\xBF", "\x1b"})
        EXPECT_EQ(content.find(mark), std::string::npos) << printable(mark);
      EXPECT_EQ(content.find('\0'), std::string::npos);
      if (kind == ".html" || content.find("encoding=\"appended\"") != std::string::npos ||
          content.find("encoding=\"raw\"") != std::string::npos)
        continue;
      std::istringstream stream{content};
      boost::property_tree::ptree tree;
      EXPECT_NO_THROW(boost::property_tree::read_xml(stream, tree));
    }
  }
  // As many fields in every row, and no formula.
  static void expect_harmless_table(const std::string& content) {
    std::vector<std::string> fields{""};
    std::size_t columns = 0;
    bool in_quotes = false;
    const auto end_row = [&] {
      if (columns == 0) columns = fields.size();
      EXPECT_EQ(fields.size(), columns) << printable(fields.front());
      for (const std::string& field : fields) {
        EXPECT_TRUE(field.empty() || std::string{"=@\t\r"}.find(field.front()) == std::string::npos) << field;
        EXPECT_FALSE((field.starts_with('+') || field.starts_with('-')) && field.find('|') != std::string::npos)
            << field;
      }
      fields = {""};
    };
    for (const char c : content) {
      if (c == '"')
        in_quotes = !in_quotes;
      else if (c == ',' && !in_quotes)
        fields.emplace_back();
      else if (c == '\n' && !in_quotes)
        end_row();
      else
        fields.back() += c;
    }
    EXPECT_FALSE(in_quotes);
  }
};

TEST_F(Hostile, TextsInTheResultsOfARunStayTexts) {
  int number = 0;
  for (const std::string& text : testing::hostile_strings()) {
    SCOPED_TRACE(printable(text.substr(0, 60)));
    const std::string name = as_name(text), results = "results_" + std::to_string(++number);
    Model model;
    const Building building =
        add(model, ShearBuilding{.name = name,
                                 .storeys = 1,
                                 .floor_mass = 500 * tonne,
                                 .storey_stiffness = 1 * GN / m,
                                 .base_mass = 550 * tonne,
                                 .isolation = Isolator<Linear>{.name = name, .law = {.stiffness = 20 * MN / m}}});
    add(model,
        Moat{.name = name + " wall", .around = building.base, .clearance = 1 * mm, .law = Hertz{1e9 * N / m_3_2}});
    std::vector<double> samples(41, 2.0);
    const GroundMotion motion{text, 0.01, samples, {text}, {text, text}};
    CaseRun run{model, motion, {.title = text}};
    Recorder offered{text};
    run.attach(offered);
    fs::create_directory(folder / results);
    FrameRecorder frames{model, folder / results, 0.1};
    run.attach(frames);
    run.run();
    CaseResult result = run.take_result();
    result.provenance.command_line = text;
    result.provenance.script = text;
    result.provenance.options = {{text, text}};
    result.warnings.push_back(text);
    result.assumptions.push_back(text);
    write_results(result, folder / results);
    expect_harmless_files(results, text);
    const std::string shown = printable(terminal_summary(result));
    EXPECT_TRUE(std::ranges::none_of(shown, [](char c) { return (c >= 0 && c < ' ' && c != '\n') || c == 0x7F; }));
    EXPECT_EQ(shown.find("\xE2\x80\xAE"), std::string::npos);
    fs::remove_all(folder / results);
  }
}

TEST_F(Hostile, TextsInAStudyStayTexts) {
  for (const std::string& text : testing::hostile_strings()) {
    SCOPED_TRACE(printable(text.substr(0, 60)));
    const StudyCases cases{StudyAxis{.name = "a" + text, .unit = text, .values = {0, 1}, .labels = {text, text + "2"}}};
    const StudySession session{.title = text, .command_line = text, .engine = text};
    const CaseOutcome done{
        .state = CaseState::done, .results = {{text, text, text, 1.0}}, .files = {FileRead{text, text}}},
        failed{.state = CaseState::failed, .reason = text};
    fs::create_directory(folder / "study");
    {
      StudyStore store{folder / "study/study.db", cases, {{text, text}}, session, StudyChanges::accept};
      store.write(0, done);
      store.write(1, failed);
      store.end_session("finished");
    }
    // The tables hold the text itself, and nothing that it asks for.
    const StoredStudy stored = read_study(folder / "study/study.db");
    EXPECT_EQ(stored.title, text);
    EXPECT_EQ(stored.result.cases().axes()[0].labels, cases.axes()[0].labels);
    EXPECT_EQ(stored.result.outcome(0).results.at(0).where, text);
    EXPECT_EQ(stored.result.outcome(1).reason, text);
    const Chart chart{.title = text, .x_label = text, .y_label = text, .series = {{text, {0.0, 1.0}, {0.0, 1.0}}}};
    const HeatMap map{text, text, text, text, {text}, {text}, {{1.0}}};
    write_study_report({.title = text,
                        .answers = {text},
                        .pictures = {{text, svg_text({chart})}, {text + "map", svg_text(map)}},
                        .tables = {{text, table_of(chart)}},
                        .studies = {{.name = "study", .result = stored.result}}},
                       folder / "study");
    write_csv(stored.result, folder / "study/study.csv");
    expect_harmless_files("study", text);
    fs::remove_all(folder / "study");
  }
}

TEST_F(Hostile, TextsOnASheetStayTexts) {
  for (const std::string& text : testing::hostile_strings()) {
    SCOPED_TRACE(printable(text.substr(0, 60)));
    const SheetLine line{.symbol = text,
                         .formula = text,
                         .clause = text,
                         .values = {1.0, 2.0, 3.0},
                         .unit = text,
                         .numbers = text,
                         .is_kept = false,
                         .verdict = text};
    fs::create_directory(folder / "sheet");
    write_design_sheets(
        {DesignSheet{.name = text, .code = text, .given = {{text, 1.0, text}}, .lines = {line}, .notes = {text}}},
        folder / "sheet/sheet.html");
    expect_harmless_files("sheet", text);
    fs::remove_all(folder / "sheet");
  }
}

}  // namespace
}  // namespace moat
