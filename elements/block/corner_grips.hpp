// The friction of all corners of a block along their edges, and the ends of these edges.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "elements/block/contact_log.hpp"
#include "elements/block/corner_and_edge.hpp"
#include "elements/block/corner_grip.hpp"
#include "elements/block/link_motion.hpp"
#include "elements/block/regime_search.hpp"
#include "model/element_states.hpp"

namespace moat {

/// Energy that went into the friction of one corner since its account started, J.
struct CornerGripEnergy {
  double work = 0.0;             ///< of the friction along the path
  double friction = 0.0;         ///< lost by sliding
  double stored_at_start = 0.0;  ///< in the tangential spring when the account started

  /// Adds a step of `step` s between these grips; 0: the same instant again, after a change of the normal force.
  void add_step(const CornerGrip& start, const CornerGrip& now, double step, WorkRule rule) {
    if (step == 0.0) {
      // Where the normal force jumped down, the grip gives up its energy.
      friction += std::max(start.stored() - now.stored(), 0.0);
      return;
    }
    if (start.force == 0.0 && now.force == 0.0) return;
    const double mean = 0.5 * (start.force + now.force);
    // The work of the mean force less the change of k_t stretch^2/2.
    friction += mean * (now.slip - start.slip) +
                0.5 * (start.spring - now.spring) * (start.path - start.slip) * (now.path - now.slip);
    work += mean * (now.path - start.path);
    if (rule == WorkRule::mean_force) return;
    // The power is smooth but for kinks: the trapezoidal rule with its correction by the rates at the ends.
    const auto power_rate = [](const CornerGrip& grip) {
      return grip.force_rate * grip.rate + grip.force * grip.second_rate;
    };
    work += 0.5 * step * (start.force * start.rate + now.force * now.rate) - mean * (now.path - start.path) +
            step * step / 12.0 * (power_rate(start) - power_rate(now));
  }
};

/// Along the tangent t of an edge (model/element_details.hpp) acts Coulomb friction F_t (corner_grip.hpp). The force on
/// the corner's body is -F_n n - F_t t. Only the normal phases are located: grip changes stay inside steps, where they
/// are kinks and no jumps.
///
/// A corner that crosses the line of an edge beside the edge's ends does not touch it, until it comes back. A corner in
/// contact that slides past an end by more than 1 % of the edge's length is released.
class CornerGrips {
 public:
  CornerGrips() = default;
  /// One for each of these corners, at rest.
  explicit CornerGrips(const std::vector<CornerAndEdge>& corners) {
    for (const CornerAndEdge& corner : corners) corners_.push_back({.geometry = corner});
  }

  /// After the normal forces, N: the friction at a trial state; adds it to `force` unless that is null. Corners that
  /// miss their edges stay open in `motion`. `at_rest(i, d)` is the response of a normal law at an indentation, m, and
  /// zero rate. Returns whether tangents changed.
  template <class AtRest>
  bool evaluate(double step, const double* displacement, const double* velocity,
                const std::vector<double>& normal_forces, const ContactLog& contacts, LinkMotion<double>& motion,
                double* force, AtRest at_rest) {
    bool changed = false;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      Corner& corner = corners_[i];
      const WeightedEnds& across = corner.geometry.ends.across();
      const double stiffness = corner.now.stiffness;
      corner.now.path = across.difference(displacement);
      corner.now.rate = across.difference(velocity);
      ElasticNormal elastic;
      if (corner.friction().tangential_ratio > 0.0 && normal_forces[i] > 0.0)
        elastic = elastic_normal([&](double d) { return at_rest(i, d); }, motion.deformations[i], motion.rates[i]);
      corner.now.follow(corner.start, step, corner.friction(), normal_forces[i], elastic);
      changed |= stiffness != corner.now.stiffness || corner.now.follows > 0.0;
      if (force != nullptr && corner.now.force != 0.0) across.add_force(corner.now.force, force);
      corner.gap = {-motion.deformations[i], -motion.rates[i]};
      if (corner.misses && !contacts.touching(i)) {
        // A corner that misses stays open: its indentation counts as a distance.
        if (motion.deformations[i] > 0.0) motion.rates[i] = -motion.rates[i];
        constexpr double apart = 1e-9;  // m
        motion.deformations[i] = -std::abs(motion.deformations[i]) - apart;
      }
    }
    return changed;
  }

  /// After the rates of the normal forces, N/s: those of friction; adds them unless `force_rate` is null.
  void evaluate_rates(const double* acceleration, const std::vector<double>& normal_force_rates, double* force_rate) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      Corner& corner = corners_[i];
      const WeightedEnds& across = corner.geometry.ends.across();
      corner.now.find_rates(corner.friction(), normal_force_rates[i], across.difference(acceleration));
      if (force_rate != nullptr && corner.now.force_rate != 0.0) across.add_force(corner.now.force_rate, force_rate);
    }
  }

  /// Along n and t, from the weighted tangent of the normal force, N/m.
  [[nodiscard]] PlanMatrix tangent(std::size_t i, double normal, double displacement_weight) const {
    const Corner& corner = corners_[i];
    return {normal, 0.0,
            corner.now.follows * corner.now.sense * corner.friction().coefficient * normal +
                displacement_weight * corner.now.by_indentation,
            displacement_weight * corner.now.stiffness};
  }
  /// Whether one of them begins to slide in the trial step.
  [[nodiscard]] bool begin_to_slide() const {
    return std::ranges::any_of(corners_, [](const Corner& each) { return each.now.begins_to_slide(each.start); });
  }

  /// Commits the grips as ElementStates::commit() does; before the contacts change.
  void commit(double step, WorkRule rule, bool keeps_energy, const ContactLog& contacts) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      Corner& corner = corners_[i];
      if (keeps_energy) corner.energy.add_step(corner.start, corner.now, step, rule);
      // An open corner beyond an end misses the edge. If it then moves behind the line of the edge, it misses the edge
      // until it is in front of the line again.
      const bool behind = corner.misses && corner.gap.value < 0.0;
      corner.misses = !contacts.touching(i) && (behind || corner.geometry.margin_at_ends(corner.now.path) < 0.0);
      corner.slide_begin = corner.now.slide_begin(corner.start, step, corner.friction());
      corner.start = corner.now;
    }
  }
  /// Starts the accounts as ElementStates::start_energy_accounts() does.
  void start_energy_accounts() {
    for (Corner& corner : corners_) {
      corner.start = corner.now;
      corner.energy = {.stored_at_start = corner.now.stored()};
    }
  }
  /// Adds that of friction.
  void add_energy(std::size_t i, ElementEnergy& energy) const {
    const Corner& corner = corners_[i];
    energy.work += corner.energy.work;
    energy.stored += corner.start.stored() - corner.energy.stored_at_start;
    energy.friction = corner.energy.friction;
  }

  /// Adds the margins of corners in contact at the ends of their edges.
  void scan(double aim, const ContactLog& contacts, RegimeScan& scan) const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!contacts.touching(i)) continue;
      const Corner& corner = corners_[i];
      const double margin = corner.geometry.margin_at_ends(corner.now.path);
      scan.margin = std::min(scan.margin, margin);
      if (margin >= 0.0) continue;
      const double before = corner.geometry.margin_at_ends(corner.start.path);
      scan.crossed = true;
      scan.fraction = std::min(scan.fraction, std::clamp((before - aim) / (before - margin), 0.0, 1.0));
    }
  }
  /// Answers as ElementStates::next_fall(), for these margins.
  [[nodiscard]] double next_fall(double aim, const ContactLog& contacts) const {
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!contacts.touching(i)) continue;
      const auto margin_above_aim = [&](double time) {
        return corners_[i].geometry.margin_at_ends(corners_[i].now.path + time * corners_[i].now.rate) - aim;
      };
      first = std::min(first, fall_near(margin_above_aim));
    }
    return first;
  }
  /// Whether a corner in contact has slid past an end at the committed state.
  [[nodiscard]] bool leaves_edge(std::size_t i, const ContactLog& contacts) const {
    return contacts.touching(i) && corners_[i].geometry.margin_at_ends(corners_[i].start.path) < 0.0;
  }
  /// After its contact was released: the corner counts as apart in the committed motion.
  void leave_edge(std::size_t i, LinkMotion<double>& committed) {
    Corner& corner = corners_[i];
    corner.misses = true;
    ++corner.departures;
    corner.gap.value = committed.deformations[i] = -std::abs(committed.deformations[i]);
  }
  /// At touch the spring is relaxed.
  void touch(std::size_t i) {
    Corner& corner = corners_[i];
    corner.start.slip = corner.start.path;
    corner.speed_at_touch = corner.start.rate;
  }

  /// The tangential spring has a duration of its own, s: half a period. The shortest of contacts in progress.
  [[nodiscard]] double shortest_contact(const ContactLog& contacts) const {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners_.size(); ++i)
      if (const Corner& corner = corners_[i]; contacts.touching(i) && corner.friction().coefficient > 0.0) {
        // Also before the first evaluation in contact, where a constant spring is known.
        const double spring = std::max(corner.now.spring, corner.friction().tangential_stiffness);
        if (spring > 0.0)
          shortest = std::min(shortest, std::numbers::pi * std::sqrt(corner.geometry.tangential_mass / spring));
      }
    return shortest;
  }
  /// Writes or reads all that changes.
  void archive(auto& archive) {
    for (Corner& corner : corners_)
      archive(corner.now, corner.start, corner.slide_begin, corner.energy, corner.speed_at_touch, corner.misses,
              corner.gap, corner.departures);
  }
  /// Completes the view of a contact.
  void complete(std::size_t i, ContactView& view) const {
    const Corner& corner = corners_[i];
    const CornerDistance distance =
        view.touching ? corner.gap : corner.geometry.distance(corner.gap, corner.now.path, corner.now.rate);
    view.distance = distance.value;
    view.distance_rate = distance.rate;
    view.friction_force = corner.now.force;
    view.friction_force_rate = corner.now.force_rate;
    view.slide_begin = corner.slide_begin;
    view.tangential_speed_at_touch = corner.speed_at_touch;
    view.departures = corner.departures;
  }

 private:
  // The normal contact at rest, with the slope of its stiffness by central differences.
  template <class AtRest>
  static ElasticNormal elastic_normal(AtRest at_rest, double indentation, double rate) {
    const Response here = at_rest(indentation);
    ElasticNormal normal{indentation, rate, here.force, here.stiffness};
    constexpr double width = 1e-4;  // of the indentation: of the root of a Hertz contact it gives 9 digits
    if (const double h = width * indentation; h > 0.0)
      normal.curvature = (at_rest(indentation + h).stiffness - at_rest(indentation - h).stiffness) / (2.0 * h);
    return normal;
  }

  struct Corner {
    CornerAndEdge geometry;
    CornerGrip now{}, start{};                                      // at the last evaluate(), and at the last commit
    double slide_begin = std::numeric_limits<double>::quiet_NaN();  // in the last step, as a fraction of it
    CornerGripEnergy energy{};
    double speed_at_touch = 0.0;  // along the edge, m/s
    bool misses = false;          // at the last commit: beside its edge
    CornerDistance gap{};         // along the normal at the last evaluate(); negative behind the edge's line
    int departures = 0;

    [[nodiscard]] const ContactFriction& friction() const { return geometry.friction; }
  };
  std::vector<Corner> corners_;
};

}  // namespace moat
