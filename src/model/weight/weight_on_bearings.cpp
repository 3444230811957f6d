#include "model/weight/weight_on_bearings.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/error.hpp"
#include "model/model.hpp"

namespace moat {
namespace {

constexpr PlanVector axes[] = {{1.0, 0.0}, {0.0, 1.0}};

AxialDistribution distribution_of(const std::vector<WeightOnBearings::Bearing>& bearings, const AxialForces& options,
                                  bool in_plan) {
  std::vector<AxialSupport> supports;
  for (const auto& bearing : bearings) {
    const BearingOnSlab& on_slab = bearing.on_slab;
    AxialSupport support{.at = on_slab.at, .stiffness = double(on_slab.count), .share = on_slab.static_weight};
    if (on_slab.vertical_stiffness > 0.0) support.stiffness = on_slab.vertical_stiffness;
    if (!on_slab.slides && options.may_pull.si() > 0.0) support.cavitation = on_slab.count * options.may_pull.si();
    supports.push_back(support);
  }
  return {std::move(supports), in_plan ? AxialDistribution::Span::plan : AxialDistribution::Span::line};
}

std::vector<WeightOnBearings::Bearing> bearings_of(const Model& model, const Building& building, const Check& check) {
  std::vector<WeightOnBearings::Bearing> bearings;
  const std::vector<ElementId> isolators = isolators_of(model, std::span{&building, 1}).front();
  for (const ElementId id : isolators) {
    const ElementInfo& info = model.blocks()[id.block]->info(id.element);
    const BearingOnSlab* on_slab = info.detail(&ElementDetails::bearing_on_slab);
    check.that(on_slab != nullptr && on_slab->static_weight > 0.0,
               "axial_forces: the bearing \"" + info.name + "\" has no weight.",
               "Give the weight at rest of every isolator, and on a line where it stands (.at).");
    bearings.push_back({.element = id, .on_slab = *on_slab});
  }
  return bearings;
}

}  // namespace

WeightOnBearings::WeightOnBearings(const Model& model, const Building& building, const Elements& elements)
    : name_{building.name},
      options_{*building.axial_forces},
      base_{building.base},
      in_plan_{model.is_plan()},
      bearings_{bearings_of(model, building, Check{"Building", building.name})},
      distribution_{distribution_of(bearings_, options_, in_plan_)},
      model_{&model} {
  Check{"Building", name_}.that(building.slabs.empty(), "axial_forces: it stands on several slabs.",
                                "Give axial forces to buildings on one slab.");
  level_ = model.body(base_).height - options_.base_height.si();
  Check{"Building", name_}.that(
      options_.may_pull.si() == 0.0 ||
          !std::ranges::all_of(bearings_, [](const Bearing& bearing) { return bearing.on_slab.slides; }),
      "axial_forces.may_pull is given, and all bearings slide.", "A slider cannot pull: leave it out.");
  const std::vector<NodeId> nodes = carried_nodes(model, building);
  add_bearings(Check{"Building", name_}, add_floors(nodes));
  std::vector<ElementId> isolators;
  for (const Bearing& bearing : bearings_) isolators.push_back(bearing.element);
  outside_ = OutsideForces{model, nodes, isolators, level_};
  for (Bearing& bearing : bearings_) {
    bearing.acts_on_law = !elements[bearing.element.block]->axial_actions().compressions.empty();
    acts_on_laws_ = acts_on_laws_ || bearing.acts_on_law;
    const auto quantities = model.blocks()[bearing.element.block]->quantities(bearing.element.element);
    for (std::size_t q = 0; q < quantities.size(); ++q)
      if (quantities[q].name == "critical_load") bearing.critical_load = q;
  }
}

void WeightOnBearings::Form::add(const Model& model, NodeId node, double weight) {
  for (const MotionShare& share : model.shares(node)) {
    const auto known = std::ranges::find(entries, share.node.index, &WeightCoupling::Entry::index);
    (known == entries.end() ? entries.insert(known, {share.node.index, 0.0}) : known)->weight += weight * share.weight;
  }
  by_ground = by_ground + weight * GroundVector{model.moved_by_ground(node, {1.0, 0.0, 0.0}),
                                                model.moved_by_ground(node, {0.0, 1.0, 0.0}),
                                                model.moved_by_ground(node, {0.0, 0.0, 1.0})};
}

double WeightOnBearings::Form::of(const Vector& values) const {
  double sum = 0.0;
  for (const WeightCoupling::Entry& entry : entries) sum += entry.weight * values[entry.index];
  return sum;
}

double WeightOnBearings::height(NodeId node) const { return model_->body(node).height - level_; }

void WeightOnBearings::add_point(Form& form, NodeId body, PlanVector at, std::size_t axis, double weight) const {
  const PlacedDiaphragm* floor = model_->diaphragm_of(body);
  if (floor == nullptr) {
    if (axis == 0) form.add(*model_, body, weight);
    return;
  }
  const auto weights = floor->weights(at, axes[axis]);
  for (std::size_t k = 0; k < 3; ++k)
    if (weights[k] != 0.0) form.add(*model_, floor->id.degrees_of_freedom()[k], weight * weights[k]);
}

PlanVector WeightOnBearings::add_floors(const std::vector<NodeId>& nodes) {
  PlanVector moment{};
  for (const NodeId node : nodes) {
    const double mass = model_->mass(node);
    const PlacedDiaphragm* floor = model_->diaphragm_of(node);
    const PlanVector centre = floor != nullptr ? floor->centre_of_mass : PlanVector{};
    weight_ += mass * standard_gravity;
    moment += mass * standard_gravity * centre;
    for (std::size_t axis = 0; axis < (in_plan_ ? 2 : 1); ++axis) {
      add_point(inertia_[axis], node, centre, axis, mass * height(node));
      add_point(displaced_[axis], node, centre, axis, mass * standard_gravity);
      add_point(displaced_[axis], base_, centre, axis, -mass * standard_gravity);
    }
  }
  return moment;
}

void WeightOnBearings::add_bearings(const Check& check, PlanVector moment_of_floors) {
  double sum = 0.0;
  for (Bearing& bearing : bearings_) {
    const BearingOnSlab& on_slab = bearing.on_slab;
    sum += on_slab.static_weight;
    static_moment_ += on_slab.static_weight * on_slab.at;
    bearing.compression = on_slab.static_weight;
    const double share = !options_.displaced_weight ? 0.0
                         : on_slab.slides && on_slab.acts_at == BearingOnSlab::by_surface
                             ? (options_.sliding_surface == SlidingSurface::above ? 1.0 : 0.0)
                             : on_slab.acts_at;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      place_.emplace_back();
      if (axis == 0 || in_plan_) add_point(place_.back(), base_, on_slab.at, axis, -share);
    }
  }
  check.that(std::abs(sum - weight_) <= 1e-6 * weight_, "axial_forces: the weights on its bearings", sum, "N",
             "that of its floors, " + to_text(weight_) + " N",
             "Several superstructures on one base: give the weight of each bearing.");
  std::vector<PlanVector> places;
  for (const Bearing& bearing : bearings_) places.push_back(bearing.on_slab.at);
  check.that(carries_moments(places, in_plan_ ? AxialDistribution::Span::plan : AxialDistribution::Span::line),
             in_plan_ ? "axial_forces: all bearings stand in a row; they cannot carry a moment about it."
                      : "axial_forces: all bearings stand at one position; they cannot carry a moment.",
             in_plan_ ? "Give bearings beside that row." : "Give isolators at two positions (.at) at least.");
  double extent = 0.0;
  for (const PlanVector a : places)
    for (const PlanVector b : places) extent = std::max(extent, length(a - b));
  constexpr double noticeable = 0.01;
  const double distance = length(static_moment_ - moment_of_floors) / weight_;
  if (distance > noticeable * extent) eccentricity_ = distance;
  compressions_.resize(bearings_.size());
  rates_.resize(bearings_.size());
  shifts_.resize(bearings_.size());
  shift_rates_.resize(bearings_.size());
}

void WeightOnBearings::press(const MotionState& motion, GroundVector ground_acceleration, const Elements& elements) {
  const auto [acceleration, rate] = mode_ ? mode_(motion.time) : std::pair{ground_acceleration.z, 0.0};
  vertical_ = acceleration;
  moment_ =
      outside_.moment(*model_, elements, false) - of_both(inertia_, motion.acceleration) -
      PlanVector{dot(inertia_[0].by_ground, ground_acceleration), dot(inertia_[1].by_ground, ground_acceleration)};
  Resultant b{load(), sigma() * static_moment_ + moment_};
  if (options_.displaced_weight) b.moment += sigma() * of_both(displaced_, motion.displacement);
  for (std::size_t i = 0; i < bearings_.size(); ++i)
    shifts_[i] = {place_[2 * i].of(motion.displacement), place_[2 * i + 1].of(motion.displacement)};
  rocks_ = !distribution_.distribute(sigma(), b, shifts_, compressions_);
  if (rocks_ && options_.may_pull.si() == 0.0)
    distribution_.distribute(sigma(), distribution_.moved_into_hull(b, shifts_), shifts_, compressions_);
  // Bearings that pull hold more than their hull: the last moment that they balance on the way from their shares of the
  // load.
  if (rocks_ && options_.may_pull.si() > 0.0) {
    PlanVector at_shares = static_moment_;
    for (std::size_t i = 0; i < bearings_.size(); ++i) at_shares += bearings_[i].on_slab.static_weight * shifts_[i];
    at_shares = sigma() * at_shares;
    const auto hold = [&](double way) {
      return distribution_.distribute(sigma(), {b.load, at_shares + way * (b.moment - at_shares)}, shifts_,
                                      compressions_);
    };
    constexpr double close = 1e-12;
    double held = 0.0;
    for (double part = 0.5; part > close; part *= 0.5)
      if (hold(held + part)) held += part;
    hold(held);
  }
  for (std::size_t i = 0; i < bearings_.size(); ++i) {
    Bearing& bearing = bearings_[i];
    bearing.compression = compressions_[i];
    bearing.deficit = distribution_.deficit(i);
    if (bearing.acts_on_law)
      elements[bearing.element.block]->axial_actions().compressions[bearing.element.element] =
          bearing.deficit > 0.0 ? -bearing.deficit : bearing.compression;
  }
}

void WeightOnBearings::find_rates(const MotionState& motion, double vertical_ground_rate, const Elements& elements) {
  vertical_rate_ = mode_ ? mode_(motion.time).second : vertical_ground_rate;
  const double sigma_rate = vertical_rate_ / standard_gravity;
  moment_rate_ = outside_.moment(*model_, elements, true) - of_both(inertia_, motion.jerk);
  Resultant b{load_rate(), sigma_rate * static_moment_ + moment_rate_};
  if (options_.displaced_weight)
    b.moment += sigma_rate * of_both(displaced_, motion.displacement) + sigma() * of_both(displaced_, motion.velocity);
  for (std::size_t i = 0; i < bearings_.size(); ++i)
    shift_rates_[i] = {place_[2 * i].of(motion.velocity), place_[2 * i + 1].of(motion.velocity)};
  distribution_.rates(sigma_rate, b, shift_rates_, rates_);
  for (std::size_t i = 0; i < bearings_.size(); ++i) {
    Bearing& bearing = bearings_[i];
    bearing.rate = bearing.deficit > 0.0 ? 0.0 : rates_[i];
    if (bearing.acts_on_law)
      elements[bearing.element.block]->axial_actions().rates[bearing.element.element] = rates_[i];
  }
}

std::size_t WeightOnBearings::fill_columns(const Elements& elements, Eigen::Index size, std::vector<Vector>& columns,
                                           std::size_t first) const {
  const std::size_t count = in_plan_ ? 2 : 1;
  for (std::size_t axis = 0; axis < count; ++axis) columns[first + axis].setZero(size);
  for (std::size_t i = 0; i < bearings_.size(); ++i) {
    if (!bearings_[i].acts_on_law) continue;
    const auto [block, element] = bearings_[i].element;
    const PlanVector by_moment = distribution_.by_moment(i);
    for (std::size_t axis = 0; axis < count; ++axis)
      elements[block]->add_force_by_compression(element, dot(by_moment, axes[axis]), columns[first + axis].data());
  }
  return first + count;
}

void WeightOnBearings::add_rows(std::vector<std::vector<WeightCoupling::Entry>>& rows) const {
  for (std::size_t axis = 0; axis < (in_plan_ ? 2 : 1); ++axis) {
    rows.push_back(inertia_[axis].entries);
    for (WeightCoupling::Entry& entry : rows.back()) entry.weight = -entry.weight;
  }
}

void WeightOnBearings::accept(double step, double time) {
  if (rocks_ && options_.rocking == AxialForces::Rocking::stops) {
    double deficit = 0.0;
    for (const Bearing& bearing : bearings_) deficit = std::max(deficit, bearing.largest_deficit);
    throw RockingError{
        (name_.empty() ? "The building" : "The building \"" + name_ + "\"") + " rocks at t = " + to_text(time) +
            " s: its bearings cannot balance the overturning moment, " + to_text(length(moment_)) +
            " N m under a load of " + to_text(load()) + " N; the largest uplift deficit before is " + to_text(deficit) +
            " N. Give bearings farther apart, or AxialForces::rocking = continues, which marks later "
            "peaks. Results up to this time are kept.",
        time};
  }
  if (rocks_) {
    rocking_time_ += step;
    first_rocking_ = std::min(first_rocking_, time);
  }
  for (Bearing& bearing : bearings_) {
    if (bearing.deficit > 0.0) bearing.uplift_time += step;
    // Round-off at an instant of lift or landing is no uplift.
    constexpr double round_off = 1e-6;
    const double least = round_off * bearing.on_slab.static_weight;
    if (bearing.deficit > least && !bearing.lifted) ++bearing.uplifts;
    bearing.lifted = bearing.deficit > least || (bearing.lifted && bearing.compression <= least);
    bearing.largest_deficit = std::max(bearing.largest_deficit, bearing.deficit);
  }
}

void WeightOnBearings::note_instability(double step, double time, const Elements& elements) {
  for (Bearing& bearing : bearings_) {
    if (!bearing.critical_load) continue;
    const auto [block, element] = bearing.element;
    const double before = bearing.excess,
                 critical = elements[block]->law_quantity(element, *bearing.critical_load).value;
    bearing.excess = bearing.compression - bearing.on_slab.count * critical;
    if (bearing.excess <= 0.0 || before > 0.0) continue;
    ++bearing.instabilities;
    // At the instant at which the excess passes zero, which is linear in the step.
    bearing.first_unstable = std::min(bearing.first_unstable, time - step * bearing.excess / (bearing.excess - before));
  }
}

}  // namespace moat
