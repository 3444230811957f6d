#include "output/recorders/floor_spectra.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/check.hpp"
#include "base/units.hpp"
#include "model/building.hpp"
#include "motions/motion_measures.hpp"
#include "motions/oscillators.hpp"

namespace moat {
namespace {

std::vector<Time> periods_of_floor_spectra() {
  std::vector<Time> periods = spaced_periods(20 * units::ms, 10 * units::s, 100);
  for (Time& period : periods) {
    const double digits = std::pow(10.0, 2.0 - std::floor(std::log10(period.si())));
    period = std::round(period.si() * digits) / digits * units::s;
  }
  return periods;
}

FloorSpectraOptions checked(FloorSpectraOptions options) {
  const Check check{"FloorSpectra", ""};
  check.that(!options.dampings.empty(), "dampings is empty.", "Leave it out for 5 %.");
  for (const double ratio : options.dampings)
    check.that(ratio >= 0.0 && ratio < 1.0, "dampings", ratio, "1", ">= 0 and < 1", "Give 5 % as 0.05.");
  if (options.periods.empty()) options.periods = periods_of_floor_spectra();
  for (const Time period : options.periods) check.between("periods", period.si(), 1e-3, 1e3, "s");
  check.that(std::ranges::adjacent_find(options.periods, std::greater_equal{}) == options.periods.end(),
             "periods do not ascend.", "Give each once, the shortest first.");
  return options;
}

// Each once.
std::vector<NodeId> bases_and_tops_of(const Model& model) {
  constexpr std::size_t most_buildings = 3;
  const std::vector<Building> buildings = all_buildings(model);
  std::vector<NodeId> floors;
  for (std::size_t b = 0; b < std::min(buildings.size(), most_buildings); ++b)
    for (const NodeId floor : {buildings[b].base, buildings[b].top()})
      if (floor != ground && !model.body(floor).generalised && std::ranges::find(floors, floor) == floors.end())
        floors.push_back(floor);
  return floors;
}

// The first node of the body.
NodeId floor_named(const Model& model, const std::string& name) {
  std::string names;
  for (const Body& body : model.bodies()) {
    const std::string_view known = model.body_name(body.first);
    if (body.generalised) continue;
    if (known == name) return body.first;
    names += (names.empty() ? "\"" : ", \"") + std::string{known} + "\"";
  }
  Check{"FloorSpectra", ""}.that(false, "the model has no floor \"" + name + "\".", "It has " + names + ".");
  return ground;
}

}  // namespace

// All oscillators on all floors.
struct FloorSpectra::Oscillators {
  // A place on a floor and a direction.
  struct Point {
    FloorSpectrum name;
    std::vector<std::pair<NodeId, double>> shares;  // of nodes in its acceleration
    double before = 0.0, now = 0.0;                 // m/s^2, at the ends of a step
  };

  Oscillators(const Model& model, const FloorSpectraOptions& options) {
    std::vector<NodeId> floors;
    for (const std::string& name : options.floors) {
      floors.push_back(floor_named(model, name));
      Check{"FloorSpectra", ""}.that(std::ranges::count(floors, floors.back()) == 1,
                                     "floors has \"" + name + "\" twice.", "Name it once.");
    }
    if (options.floors.empty()) floors = bases_and_tops_of(model);
    for (const NodeId floor : floors) add_floor(model, floor, options.corners);
    const auto is_corner = [](const Point& each) { return !each.name.corner.empty(); };
    Check{"FloorSpectra", ""}.that(!options.corners || std::ranges::any_of(points, is_corner),
                                   "corners are wanted, but no floor has any.", "Give Diaphragm::outline.");
    for (const double damping : options.dampings)
      for (std::size_t first = 0; first < options.periods.size(); first += oscillators_per_group) {
        OscillatorNumbers periods;
        // A group with fewer oscillators repeats its last one.
        for (std::size_t i = 0; i < oscillators_per_group; ++i)
          periods[static_cast<int>(i)] = options.periods[std::min(first + i, options.periods.size() - 1)].si();
        groups.emplace_back(periods, damping);
      }
    motions.resize(points.size() * groups.size());
  }

  void add_floor(const Model& model, NodeId floor, bool with_corners) {
    const std::string name{model.body_name(floor)};
    const PlacedDiaphragm* diaphragm = model.diaphragm_of(floor);
    if (diaphragm == nullptr) {
      points.push_back({{.floor = name}, {{floor, 1.0}}});
      return;
    }
    const auto add = [&](const std::string& corner, PlanVector place) {
      for (const auto& [direction, along] :
           {std::pair{"x", PlanVector{1.0, 0.0}}, std::pair{"y", PlanVector{0.0, 1.0}}}) {
        const auto [x, y, rotation] = diaphragm->weights(place, along);
        points.push_back({{.floor = name, .corner = corner, .direction = direction},
                          {{diaphragm->id.x, x}, {diaphragm->id.y, y}, {diaphragm->id.r, rotation}}});
      }
    };
    add("", diaphragm->centre_of_mass);
    for (std::size_t i = 0; with_corners && i < diaphragm->outline.size(); ++i)
      add("corner " + std::to_string(i + 1), diaphragm->outline.corner(i));
  }

  void sample(const StepView& view) {
    time = view.state.time();
    for (Point& point : points) {
      point.now = 0.0;
      for (const auto& [node, share] : point.shares)
        if (share != 0.0) point.now += share * view.absolute_acceleration(node);
    }
  }

  // Lengths that differ by round-off of the time share one.
  const std::vector<OscillatorInterval>* intervals_of(double length) {
    constexpr double same_length = 1e-12;  // s
    constexpr std::size_t most_kept = 256;
    const long number = std::lround(length / same_length);
    if (number == 0) return nullptr;
    if (intervals.size() > most_kept) intervals.clear();
    std::vector<OscillatorInterval>& found = intervals[number];
    if (found.empty())
      for (const OscillatorGroup& group : groups) found.emplace_back(group, length);
    return &found;
  }

  template <bool with_absolute>
  void pass(double length) {
    const std::vector<OscillatorInterval>* steps = intervals_of(length);
    if (steps == nullptr) return;
    auto motion = motions.begin();
    for (const Point& point : points)
      for (std::size_t g = 0; g < groups.size(); ++g)
        (motion++)->pass<with_absolute>(groups[g], (*steps)[g], point.before, point.now);
  }

  std::vector<Point> points;
  std::vector<OscillatorGroup> groups;    // of one damping after another
  std::vector<OscillatorMotion> motions;  // of every point those of all groups
  std::map<long, std::vector<OscillatorInterval>> intervals;
  double time = 0.0;
};

FloorSpectra::FloorSpectra(FloorSpectraOptions options) : options_{checked(std::move(options))} {}
FloorSpectra::~FloorSpectra() = default;

void FloorSpectra::start(const StepView& view) {
  oscillators_ = std::make_unique<Oscillators>(view.model, options_);
  oscillators_->sample(view);
}

void FloorSpectra::step(const StepView& view) {
  Oscillators& all = *oscillators_;
  const double before = all.time;
  for (Oscillators::Point& point : all.points) point.before = point.now;
  all.sample(view);
  if (options_.absolute_acceleration)
    all.pass<true>(all.time - before);
  else
    all.pass<false>(all.time - before);
}

void FloorSpectra::event(const StepView& view, std::span<const RegimeChange>) { oscillators_->sample(view); }

// Intervals too: one serves all lengths that differ from it by round-off.
void FloorSpectra::archive(StateArchive& archive) {
  Oscillators& all = *oscillators_;
  std::map<long, double> lengths;
  for (const auto& [number, of_groups] : all.intervals) lengths[number] = of_groups.front().whole.length;
  archive(all.time, all.motions, lengths);
  for (Oscillators::Point& point : all.points) archive(point.before, point.now);
  if (!archive.reads()) return;
  all.intervals.clear();
  for (const auto& [number, length] : lengths)
    for (const OscillatorGroup& group : all.groups) all.intervals[number].emplace_back(group, length);
}

std::vector<FloorSpectrum> FloorSpectra::spectra() const {
  std::vector<FloorSpectrum> list;
  if (oscillators_ == nullptr) return list;
  const std::vector<OscillatorGroup>& groups = oscillators_->groups;
  const std::size_t of_damping = groups.size() / options_.dampings.size();
  const OscillatorMotion* motion = oscillators_->motions.data();
  for (const Oscillators::Point& point : oscillators_->points)
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if (g % of_damping == 0) list.push_back(point.name);
      ResponseSpectrum& spectrum = list.back().spectrum;
      spectrum.damping_ratio = groups[g].damping_ratio;
      OscillatorMotion at_end = *motion++;
      const OscillatorInterval longest_period{groups[g], groups[g].periods.maxCoeff()};
      if (options_.absolute_acceleration)
        at_end.vibrate_freely<true>(groups[g], longest_period);
      else
        at_end.vibrate_freely<false>(groups[g], longest_period);
      for (int i = 0; i < oscillators_per_group && spectrum.period.size() < options_.periods.size(); ++i) {
        const double pseudo = at_end.pseudo_accelerations()[i], frequency = groups[g].frequency[i];
        spectrum.period.push_back(groups[g].periods[i]);
        spectrum.displacement.push_back(pseudo / (frequency * frequency));
        spectrum.pseudo_acceleration.push_back(pseudo);
        if (options_.absolute_acceleration)
          spectrum.absolute_acceleration.push_back(at_end.absolute_accelerations()[i]);
      }
    }
  return list;
}

}  // namespace moat
