// Every text field of results, studies and sheets with texts that try to be more than text.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "app/results.hpp"
#include "design/sheet_page.hpp"
#include "hostile_files.hpp"
#include "moat.hpp"
#include "output/vtk/frame_recorder.hpp"
#include "study/study_report.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using namespace units;
using testing::Hostile;

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

Model model_on_a_line(const std::string& text) {
  const std::string name = as_name(text);
  Model model;
  const Building building =
      add(model, ShearBuilding{.name = name,
                               .storeys = 1,
                               .floor_mass = 500 * tonne,
                               .storey_stiffness = 1 * GN / m,
                               .base_mass = 550 * tonne,
                               .isolation = Isolator<Linear>{.name = name, .law = {.stiffness = 20 * MN / m}}});
  add(model, Moat{.name = name + " wall", .around = building.base, .clearance = 1 * mm, .law = Hertz{1e9 * N / m_3_2}});
  return model;
}

// A building with axial forces on named bearings in a moat of flexible walls, and two towers on a base beside it.
Model model_in_plan(const std::string& text) {
  const std::string name = as_name(text);
  Model model;
  std::vector<PlanBearings::Placed> bearings;
  for (const double x : {-8.0, 8.0})
    for (const double y : {-5.0, 5.0}) {
      PlanBearings::Placed& bearing =
          bearings.emplace_back(PlanPosition{x * m, y * m}, FrictionPendulum{.radius = 2 * m, .friction = 0.05});
      bearing.name = name + std::to_string(bearings.size());
      bearing.type = text;
    }
  const PlanBuildingParts house =
      add(model, PlanBuilding{.name = name,
                              .outline = rectangle(20 * m, 12 * m),
                              .storeys = 1,
                              .floor_mass = 500 * tonne,
                              .mass_offset = PlanPosition{1 * m, 1 * m},
                              .columns = grid(2, 2, StoreyColumn{.stiffness = 100 * MN / m}),
                              .base_mass = 500 * tonne,
                              .bearings = {bearings, {text}},
                              .storey_height = 3 * m,
                              .axial_forces = AxialForces{}});
  add(model, PlanMoat{.name = name + " walls",
                      .around = house.base,
                      .clearance = 1 * mm,
                      .law = LinearElastic{.stiffness = 100 * MN / m},
                      .wall = FlexibleWall{.mass = 10 * tonne, .stiffness = 100 * MN / m}});
  add(model, RotationSpring{.name = name + " twist", .lower = ground, .upper = house.base, .stiffness = 1 * MN * m});
  add(model, PlanarSpring<BiaxialLinear>{.name = name + " spring",
                                         .lower = PlanPoint{house.base},
                                         .upper = PlanPoint{house.floor(1)},
                                         .law = {.stiffness = 1 * MN / m},
                                         .deformation_quantity = text,
                                         .force_quantity = text + " force",
                                         .place = text,
                                         .law_as_given = LawAsGiven{text, {{text, 1.0, text}}}});
  CondensedStructure towers{.stiffness = Eigen::VectorXd::Constant(7, 1e9).asDiagonal(),
                            .mass = Eigen::VectorXd::Constant(7, 5e5).asDiagonal(),
                            .notes = {text},
                            .kept = {{.name = name + " kept", .level = 0}}};
  for (const char* side : {" west", " east"}) {
    const double x = side[1] == 'w' ? 20.0 : 40.0;
    towers.levels.push_back({.name = name + side,
                             .tower = name + side,
                             .height = 3.0,
                             .mass = 5e5,
                             .rotary_inertia = 5e5,
                             .centre_of_mass = {x, 0.0},
                             .outline = rectangle(19.9 * m, 12 * m, {x * m, 0 * m})});
  }
  add(model, Superstructure{.name = name + " towers",
                            .condensed = towers,
                            .base = SuperstructureBase{.mass = 500 * tonne,
                                                       .centre_of_mass = {30 * m, 0 * m},
                                                       .outline = rectangle(40 * m, 12 * m, {30 * m, 0 * m})},
                            .bearings = grid(2, 2, BiaxialLinear{.stiffness = 20 * MN / m})});
  add(model, PlanNeighbours{.name = name + " joint",
                            .first = model.buildings()[1],
                            .second = model.buildings()[2],
                            .law = LinearElastic{.stiffness = 100 * MN / m}});
  return model;
}

TEST_F(Hostile, TextsInTheResultsOfARunStayTexts) {
  int number = 0;
  for (const std::string& text : testing::hostile_strings())
    for (const auto& make : {model_on_a_line, model_in_plan}) {
      SCOPED_TRACE(printable(text.substr(0, 60)));
      const std::string results = "results_" + std::to_string(++number);
      const Model model = make(text);
      const GroundMotion samples{text, 0.01, std::vector<double>(41, 2.0), {text}, {text, text}};
      const GroundMotion motion = model.is_plan() ? PlanMotion{samples, samples, {}, samples} : samples;
      CaseRun run{model, motion, {.title = text}};
      Recorder offered{text};
      run.attach(offered);
      fs::create_directory(folder / results);
      FrameRecorder frames{model, folder / results, 0.1};
      run.attach(frames);
      BearingCheckRecorder checks{CheckRules::none, {{as_name(text) + " " + text, {.displacement_capacity = 1 * m}}}};
      if (model.is_plan()) run.attach(checks);
      run.run();
      CaseResult result = run.result();
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
