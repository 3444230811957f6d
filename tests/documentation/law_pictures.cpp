#include "law_pictures.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "impact_cases.hpp"
#include "moat.hpp"
#include "small_models.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

constexpr int width = 1000, panel_height = 230, columns = 3;

template <class Law>
Chart impact_of() {
  constexpr double time_step = 0.25e-3, millimetres = 1e3, meganewtons = 1e-6;
  constexpr std::size_t samples = 800;
  constexpr bool is_linear = requires(Law law) { law.stiffness = 1 * N / m; };
  const Model model = body_before_wall(impact_law<Law>(is_linear ? 1.8e9 : 1e10, 0.65), 5e5, 1.0, 1e-3);
  const CaseResult result = run_case(model, GroundMotion{"rest", time_step, std::vector<double>(samples, 0.0)},
                                     {.error_bars = ErrorBarMode::never});
  Chart chart{std::string{Law::name}, "indentation [mm]", "force [MN]", {Series{}}};
  const auto indentation = result.histories.values("indentation", "wall"),
             force = result.histories.values("impact_force", "wall");
  for (std::size_t i = 0; i < indentation.size(); ++i) {
    if (indentation[i] < 0.0) continue;
    chart.series[0].x.push_back(millimetres * indentation[i]);
    chart.series[0].y.push_back(meganewtons * force[i]);
  }
  return chart;
}

// Laws under weight carry 1 MN.
template <class Law>
auto acting() {
  if constexpr (ForceLaw<Law>)
    return Law::typical();
  else
    return Law::typical().carrying(1 * MN);
}

template <class Law>
Chart loops_of() {
  constexpr double frequency = 0.5, slowest = 1e-3, centimetres = 1e2, kilonewtons = 1e-3;
  constexpr int cycles = 3, pieces = 120;
  const bool is_soil = Law::name == "HyperbolicBackfill",
             is_storey = Law::name == "BaberNoori" || Law::name == "ImkBilinear" || Law::name == "YieldingStorey";
  const double amplitude = is_soil || is_storey ? 0.1 : 0.3, omega = 2.0 * std::numbers::pi * frequency;
  LawPath path{acting<Law>(), LawPath<decltype(acting<Law>())>::mean_of_ends};
  Chart chart{std::string{Law::name}, "deformation [cm]", "force [kN]", {Series{}}};
  for (int i = 1; i <= cycles * pieces; ++i) {
    const double phase = 2.0 * std::numbers::pi * i / pieces;
    const double size = amplitude * std::ceil(static_cast<double>(i) / pieces) / cycles;
    path.move(size * std::sin(phase), std::max(omega * size * std::abs(std::cos(phase)), slowest));
    chart.series[0].x.push_back(centimetres * path.deformation());
    chart.series[0].y.push_back(kilonewtons * path.force());
  }
  return chart;
}

template <class Laws, class ChartOf>
std::string picture_of(ChartOf chart_of) {
  std::vector<Chart> charts;
  Laws::for_each([&]<class Law>() { charts.push_back(chart_of.template operator()<Law>()); });
  return svg_text(charts, width, panel_height, columns) + "\n";
}

}  // namespace

std::string impact_law_picture() {
  return picture_of<AllImpactLaws>([]<class Law>() { return impact_of<Law>(); });
}

std::string spring_law_picture() {
  return picture_of<AllSpringLaws>([]<class Law>() { return loops_of<Law>(); });
}

}  // namespace moat::testing
