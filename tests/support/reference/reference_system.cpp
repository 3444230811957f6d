#include "reference_system.hpp"

#include <algorithm>
#include <cmath>

namespace moat::testing {
namespace {

constexpr double least_approach_speed = 1e-4;  // m/s

}  // namespace

ReferenceSystem::ReferenceSystem(const PlainModel& model) {
  for (const PlainNode& node : model.nodes) {
    masses_.push_back(node.mass);
    for (const char* quantity : {"displacement", "velocity", "absolute_acceleration"})
      channel_names_.push_back({quantity, node.name});
  }
  const auto between = [&](Kind kind, int lower, int upper) {
    Link link;
    link.kind = kind;
    attach(link, upper, 1.0);
    attach(link, lower, -1.0);
    return link;
  };
  const auto report = [&](const std::string& deformation, const std::string& force, const std::string& where) {
    channel_names_.push_back({deformation, where});
    channel_names_.push_back({force, where});
  };
  for (const PlainSpring& spring : model.springs) {
    Link link = between(Kind::spring, spring.lower, spring.upper);
    link.stiffness = spring.stiffness;
    link.damping = spring.damping;
    links_.push_back(link);
    links_.back().reports = spring.kind != PlainSpring::Kind::frame;
    if (spring.kind == PlainSpring::Kind::storey)
      report("drift", "storey_shear", spring.name);
    else if (spring.kind == PlainSpring::Kind::wall)
      report("wall_deformation", "wall_force", spring.name);
  }
  for (const PlainBearing& bearing : model.bearings) {
    Link link = between(Kind::bearing, bearing.lower, bearing.upper);
    link.stiffness = bearing.post_yield_stiffness;
    link.sliding_stiffness = bearing.yield_force / bearing.yield_displacement - bearing.post_yield_stiffness;
    link.limit = bearing.yield_displacement;
    links_.push_back(link);
    if (bearing.kind == PlainBearing::Kind::isolator) {
      report("isolator_deformation", "isolator_force", bearing.name);
    } else {
      links_.back().reports_yielding = true;
      report("drift", "storey_shear", bearing.name);
      report("ductility", "residual_drift", bearing.name);
    }
  }
  for (const PlainGap& gap : model.gaps) {
    Link link;
    link.kind = Kind::gap;
    attach(link, gap.left, 1.0);
    attach(link, gap.right, -1.0);
    link.offset = gap.clearance;
    double mobility = 0.0;
    for (int i = 0; i < link.terms; ++i) {
      const auto n = static_cast<std::size_t>(i);
      mobility += link.weight[n] * link.weight[n] / masses_[static_cast<std::size_t>(link.node[n])];
    }
    link.effective_mass = 1.0 / mobility;
    link.contact = reference_contact(gap.law, link.effective_mass);
    link.gap = static_cast<std::size_t>(&gap - model.gaps.data());
    links_.push_back(link);
    report("indentation", "impact_force", gap.place);
  }
  for (const PlainDashpot& dashpot : model.dashpots) {
    Link link = between(Kind::dashpot, dashpot.lower, dashpot.upper);
    link.damping = dashpot.damping;
    link.reports = false;
    links_.push_back(link);
  }
}

void ReferenceSystem::attach(Link& link, int node, double weight) {
  if (node == plain_ground || weight == 0.0) return;
  const auto n = static_cast<std::size_t>(link.terms++);
  link.node[n] = node;
  link.weight[n] = weight;
}

void ReferenceSystem::attach(Link& link, const PlainPoint& point, double sign) {
  attach(link, point.node, sign * (1.0 - point.share));
  attach(link, point.other, sign * point.share);
}

double ReferenceSystem::sum(const Link& link, const double* values) const {
  double total = 0.0;
  for (int i = 0; i < link.terms; ++i) {
    const auto n = static_cast<std::size_t>(i);
    total += link.weight[n] * values[link.node[n]];
  }
  return total;
}

ReferenceContact::Response ReferenceSystem::respond(const Link& link, double deformation, double rate) const {
  switch (link.kind) {
    case Kind::spring:
      return {link.stiffness * deformation + link.damping * rate, link.stiffness, link.damping};
    case Kind::dashpot:
      return {link.damping * rate, 0.0, link.damping};
    case Kind::bearing:
      if (link.direction != 0)
        return {link.stiffness * deformation + link.direction * link.sliding_stiffness * link.limit, link.stiffness,
                0.0};
      return {link.stiffness * deformation + link.sliding_stiffness * (deformation - link.slip),
              link.stiffness + link.sliding_stiffness, 0.0};
    case Kind::gap:
      break;
  }
  if (link.phase != Phase::loaded) return {0.0, 0.0, 0.0};
  return link.contact.evaluate(deformation, rate, link.approach_speed, link.approaching);
}

void ReferenceSystem::accelerations(const double* displacement, const double* velocity, double ground,
                                    double* acceleration) const {
  for (std::size_t i = 0; i < size(); ++i) acceleration[i] = 0.0;
  for (const Link& link : links_) {
    if (link.kind == Kind::gap && link.phase != Phase::loaded) continue;
    const double force = respond(link, sum(link, displacement) - link.offset, sum(link, velocity)).force;
    for (int i = 0; i < link.terms; ++i) {
      const auto n = static_cast<std::size_t>(i);
      acceleration[link.node[n]] -= link.weight[n] * force;
    }
  }
  for (std::size_t i = 0; i < size(); ++i) acceleration[i] = acceleration[i] / masses_[i] - ground;
}

std::array<ReferenceSystem::Margin, ReferenceSystem::margins_per_link> ReferenceSystem::margins(
    const Link& link, const ReferenceState& state) const {
  constexpr Margin none{1.0, 0.0};
  const double d = sum(link, state.displacement.data()) - link.offset, rate = sum(link, state.velocity.data());
  if (link.kind == Kind::bearing) {
    if (link.direction != 0)
      return {Margin{link.direction * rate, link.direction * sum(link, state.acceleration.data())}, none};
    const double stretch = d - link.slip, limit = link.limit * (1.0 + 1e-13);
    return {Margin{limit - stretch, -rate}, Margin{limit + stretch, rate}};
  }
  if (link.phase == Phase::open) return {Margin{-d, -rate}, none};
  const Margin opening{d, rate};
  if (link.contact.approach_only) {
    const double sign = link.approaching ? 1.0 : -1.0;
    return {opening, Margin{sign * rate, sign * sum(link, state.acceleration.data())}};
  }
  if (!link.contact.ends_by_force) return {opening, none};
  const auto push = link.contact.push(d, rate, sum(link, state.acceleration.data()), link.approach_speed);
  const double sign = link.phase == Phase::loaded ? 1.0 : -1.0;
  return {opening, Margin{sign * push.value, sign * push.rate}};
}

void ReferenceSystem::margins(const ReferenceState& state, std::vector<Margin>& margins) const {
  margins.clear();
  for (const Link& link : links_) {
    if (link.kind != Kind::bearing && link.kind != Kind::gap) continue;
    for (const Margin& margin : this->margins(link, state)) margins.push_back(margin);
  }
}

void ReferenceSystem::change_regime(Link& link, const ReferenceState& state, std::vector<Touch>& touches) const {
  const std::array<Margin, margins_per_link> all = margins(link, state);
  if (all[0].value >= 0.0 && all[1].value >= 0.0) return;
  const double d = sum(link, state.displacement.data()) - link.offset, rate = sum(link, state.velocity.data());
  if (link.kind == Kind::bearing) {
    if (link.direction != 0) {
      link.slip = d - link.direction * link.limit;
      link.direction = 0;
    } else {
      link.direction = d > link.slip ? 1 : -1;
    }
  } else if (link.phase == Phase::open) {
    link.phase = Phase::loaded;
    link.approaching = true;
    link.approach_speed = std::max(rate, least_approach_speed);
    touches.push_back({link.gap, rate});
  } else if (all[0].value < 0.0) {
    link.phase = Phase::open;
  } else if (link.contact.approach_only) {
    link.approaching = !link.approaching;
  } else {
    link.phase = link.phase == Phase::loaded ? Phase::released : Phase::loaded;
  }
}

void ReferenceSystem::change_regimes(const ReferenceState& state, std::vector<Touch>& touches) {
  for (Link& link : links_)
    if (link.kind == Kind::bearing || link.kind == Kind::gap) change_regime(link, state, touches);
}

void ReferenceSystem::channels(const ReferenceState& state, double ground,
                               std::vector<ReferenceChannel>& channels) const {
  channels.resize(channel_names_.size());
  for (std::size_t i = 0; i < size(); ++i) {
    channels[3 * i] = {state.displacement[i], state.velocity[i]};
    channels[3 * i + 1] = {state.velocity[i], state.acceleration[i]};
    channels[3 * i + 2] = {state.acceleration[i] + ground, 0.0};
  }
  std::size_t next = 3 * size();
  for (const Link& link : links_) {
    const double d = sum(link, state.displacement.data()) - link.offset, rate = sum(link, state.velocity.data());
    const auto response = respond(link, d, rate);
    const double force_rate = response.by_indentation * rate + response.by_rate * sum(link, state.acceleration.data());
    for (int i = 0; i < link.terms; ++i) {
      const auto n = static_cast<std::size_t>(i), node = static_cast<std::size_t>(link.node[n]);
      channels[3 * node + 2].rate -= link.weight[n] * force_rate / masses_[node];
    }
    if (!link.reports) continue;
    // An open gap is not indented.
    const bool shown = link.kind != Kind::gap || link.phase != Phase::open;
    channels[next++] = shown ? ReferenceChannel{d, rate} : ReferenceChannel{};
    channels[next++] = {response.force, force_rate};
    if (!link.reports_yielding) continue;
    channels[next++] = {d / link.limit, rate / link.limit};
    // Where the force is zero on a line with the initial stiffness.
    const double of_slip = link.sliding_stiffness / (link.stiffness + link.sliding_stiffness);
    const bool slides = link.direction != 0;
    channels[next++] = {of_slip * (slides ? d - link.direction * link.limit : link.slip),
                        slides ? of_slip * rate : 0.0};
  }
}

double ReferenceSystem::fastest(const ReferenceState& state) const {
  std::vector<double> stiffness(size(), 0.0), damping(size(), 0.0);
  double fastest = 0.0;
  for (const Link& link : links_) {
    const double d = sum(link, state.displacement.data()) - link.offset, rate = sum(link, state.velocity.data());
    const auto response = respond(link, d, rate);
    double weights = 0.0;
    for (int i = 0; i < link.terms; ++i) weights += std::abs(link.weight[static_cast<std::size_t>(i)]);
    for (int i = 0; i < link.terms; ++i) {
      const auto n = static_cast<std::size_t>(i), node = static_cast<std::size_t>(link.node[n]);
      // The slope of d^0.25 is infinite at touch; steps start short there anyway.
      const double slope = link.kind == Kind::gap && link.contact.form == ReferenceContact::Form::root
                               ? 0.0
                               : std::abs(response.by_indentation);
      stiffness[node] += weights * std::abs(link.weight[n]) * slope / masses_[node];
      damping[node] += weights * std::abs(link.weight[n]) * response.by_rate / masses_[node];
    }
    if (link.kind == Kind::gap && link.phase != Phase::open)
      fastest = std::max(fastest, 3.0 / link.contact.duration(link.effective_mass, link.approach_speed));
  }
  for (std::size_t i = 0; i < size(); ++i) fastest = std::max({fastest, std::sqrt(stiffness[i]), damping[i]});
  return fastest;
}

}  // namespace moat::testing
