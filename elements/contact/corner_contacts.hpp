// Contacts of corners with edges, with friction.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "elements/contact/contact_links.hpp"
#include "elements/contact/corner_and_edge.hpp"
#include "elements/contact/corner_grip.hpp"
#include "elements/contact/corner_grip_energy.hpp"
#include "elements/plan/plan_ends.hpp"
#include "model/plan_contacts.hpp"

namespace moat {

/// All contacts of corners with edges that have a normal law of type Law. The normal force F_n is that of ContactLinks
/// along the normal n. Along the tangent t (model/plan_contacts.hpp) acts Coulomb friction F_t (corner_grip.hpp). The
/// force on the corner's body is -F_n n - F_t t. Only the normal phases are located: grip changes stay inside steps,
/// where they are kinks and no jumps.
///
/// A corner that crosses the line of an edge beside the edge's ends does not touch it, until it comes back. A corner in
/// contact that slides past an end by more than 1 % of the edge's length is released.
template <ContactLaw Law>
class CornerContacts final : public ContactLinks<Law, PlanEnds>, public PlanContacts {
  using Base = ContactLinks<Law, PlanEnds>;

 public:
  /// Touch, approach speed and phase of a contact.
  using State = ContactState;

  /// Appends a contact and returns its index.
  std::size_t add(ElementInfo info, const Law& law, const CornerAndEdge& corner) {
    corners_.push_back(corner);
    const std::size_t count = corners_.size();
    now_grips_.resize(count);
    start_grips_.resize(count);
    slide_begins_.resize(count, std::numeric_limits<double>::quiet_NaN());
    grip_energies_.resize(count);
    speeds_at_touch_.resize(count, 0.0);
    misses_.resize(count, 0);
    times_left_.resize(count, 0);
    gaps_.resize(count);
    return Base::add(std::move(info), law, corner.normal_mass, corner.ends.along());
  }

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<CornerContacts>(*this); }
  const PlanContacts* plan_contacts() const override { return this; }
  bool linear_between_events() const override { return false; }

  void add_couplings(Couplings& couplings) const override {
    Base::add_couplings(couplings);
    for (const CornerAndEdge& corner : corners_) corner.ends.add_couplings(couplings);
  }
  void find_slots(const SparseMatrix& matrix) override {
    Base::find_slots(matrix);
    for (std::size_t i = 0; i < corners_.size(); ++i) corners_[i].ends.find(this->infos_[i], matrix);
  }

  void evaluate(const double* displacement, const double* velocity, double* force) override {
    Base::evaluate(displacement, velocity, force);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const PlanEnds& across = corners_[i].ends.across();
      CornerGrip& now = now_grips_[i];
      const double stiffness = now.stiffness(friction(i));
      now.path = across.difference(displacement);
      now.rate = across.difference(velocity);
      now.follow(start_grips_[i], this->step_, friction(i), this->forces_[i]);
      friction_changed_ |= stiffness != now.stiffness(friction(i)) || now.follows > 0.0;
      if (force != nullptr && now.force != 0.0) across.add_force(now.force, force);
      gaps_[i] = {-this->now_.deformations[i], -this->now_.rates[i]};
      if (misses_[i] != 0 && !this->is_touching(i)) keep_open(i);
    }
  }

  void evaluate_rates(const double* acceleration, double* force_rate) override {
    Base::evaluate_rates(acceleration, force_rate);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      CornerGrip& now = now_grips_[i];
      now.find_rates(friction(i), this->force_rates_[i], corners_[i].ends.across().difference(acceleration));
      if (force_rate != nullptr && now.force_rate != 0.0)
        corners_[i].ends.across().add_force(now.force_rate, force_rate);
    }
  }

  void add_tangent(double displacement_weight, double velocity_weight, SparseMatrix& matrix) const override {
    Base::add_tangent(displacement_weight, velocity_weight, matrix);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const CornerGrip& now = now_grips_[i];
      const double coupling = now.follows * now.sense * friction(i).coefficient *
                              (displacement_weight * this->stiffnesses_[i] + velocity_weight * this->dampings_[i]);
      const double stiffness = displacement_weight * now.stiffness(friction(i));
      if (coupling != 0.0 || stiffness != 0.0)
        corners_[i].ends.add_stiffness({0.0, 0.0, coupling, stiffness}, matrix.valuePtr());
    }
  }
  bool take_tangent_change() override {
    const bool changed = Base::take_tangent_change();
    return std::exchange(friction_changed_, false) || changed;
  }
  /// A corner that begins to slide is one.
  void find_corners(UnlocatedCorners& corners, double*) const override {
    for (std::size_t i = 0; i < corners_.size(); ++i) corners.jump |= now_grips_[i].begins_to_slide(start_grips_[i]);
  }

  void scan(double step, double aim, RegimeScan& scan) const override {
    Base::scan(step, aim, scan);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!this->is_touching(i)) continue;
      const double margin = corners_[i].margin_at_ends(now_grips_[i].path);
      if (margin < scan.margin) {
        scan.margin = margin;
        scan.nearest = i;
      }
      if (margin >= 0.0) continue;
      const double before = corners_[i].margin_at_ends(start_grips_[i].path);
      scan.crossed = true;
      ++scan.crossings;
      scan.fraction = std::min(scan.fraction, std::clamp((before - aim) / (before - margin), 0.0, 1.0));
    }
  }

  double next_fall(double aim) const override {
    double first = Base::next_fall(aim);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!this->is_touching(i)) continue;
      const auto margin_above_aim = [&](double time) {
        return corners_[i].margin_at_ends(now_grips_[i].path + time * now_grips_[i].rate) - aim;
      };
      first = std::min(first, fall_near(margin_above_aim));
    }
    return first;
  }

  void change(std::size_t block_index, std::vector<RegimeChange>& changes) override {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!this->is_touching(i) || corners_[i].margin_at_ends(start_grips_[i].path) >= 0.0) continue;
      changes.push_back({.block = block_index, .element = i, .rate = this->start_.rates[i]});
      const double stored_before = this->stored(i);
      enter(i, {}, this->start_.rates[i], changes.back());
      this->energies_.release(i, stored_before - this->stored(i));
      misses_[i] = 1;
      keep_open_at_start(i);
      ++times_left_[i];
    }
    Base::change(block_index, changes);
  }

  void commit(double step, WorkRule rule) override {
    const bool kept = this->energies_.kept();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (kept) grip_energies_[i].add_step(start_grips_[i], now_grips_[i], friction(i), step, rule);
      watch_ends(i);
      slide_begins_[i] = now_grips_[i].slide_begin(start_grips_[i], step, friction(i));
    }
    start_grips_ = now_grips_;
    Base::commit(step, rule);
  }

  void start_energy_accounts() override {
    Base::start_energy_accounts();
    start_grips_ = now_grips_;
    for (std::size_t i = 0; i < corners_.size(); ++i)
      grip_energies_[i] = {.stored_at_start = now_grips_[i].stored(friction(i))};
  }
  ElementEnergy energy(std::size_t i) const override {
    ElementEnergy energy = Base::energy(i);
    energy.work += grip_energies_[i].work;
    energy.stored += start_grips_[i].stored(friction(i)) - grip_energies_[i].stored_at_start;
    energy.friction = grip_energies_[i].friction;
    return energy;
  }

  /// The tangential spring has a duration of its own: half a period.
  double shortest_contact() const override {
    double shortest = Base::shortest_contact();
    if (!std::isfinite(shortest)) return shortest;
    for (std::size_t i = 0; i < corners_.size(); ++i)
      if (this->is_touching(i) && friction(i).coefficient > 0.0)
        shortest = std::min(
            shortest, std::numbers::pi * std::sqrt(corners_[i].tangential_mass / friction(i).tangential_stiffness));
    return shortest;
  }

  const CornerPair& pair(std::size_t i) const override { return corners_[i].pair; }
  double friction_force(std::size_t i) const override { return now_grips_[i].force; }
  double friction_force_rate(std::size_t i) const override { return now_grips_[i].force_rate; }
  double slide_begin(std::size_t i) const override { return slide_begins_[i]; }
  double tangential_speed_at_touch(std::size_t i) const override { return speeds_at_touch_[i]; }
  double distance_at_rest(std::size_t i) const override {
    return distance_of(i, {this->infos_[i].offset, 0.0}, {}).value;
  }
  Distance distance(std::size_t i) const override { return distance_of(i, gaps_[i], now_grips_[i]); }
  bool may_jam(std::size_t i) const override {
    const CornerAndEdge& corner = corners_[i];
    return 1.0 <= corner.normal_mass * corner.friction.coefficient * std::abs(corner.cross_mobility);
  }
  int times_left(std::size_t i) const override { return times_left_[i]; }

 protected:
  void enter(std::size_t i, const State& next, double rate, RegimeChange& change) override {
    const bool touched_before = this->is_touching(i);
    Base::enter(i, next, rate, change);
    if (touched_before || !this->is_touching(i)) return;
    // At touch the spring is relaxed.
    start_grips_[i].slip = start_grips_[i].path;
    speeds_at_touch_[i] = start_grips_[i].rate;
  }
  /// The slip at touch is known where a step ends, and not inside.
  bool jumps(std::size_t i, const State& next, double rate) const override {
    return (friction(i).coefficient > 0.0 && !this->is_touching(i)) || Base::jumps(i, next, rate);
  }

 private:
  [[nodiscard]] ContactFriction friction(std::size_t i) const { return corners_[i].friction; }

  [[nodiscard]] Distance distance_of(std::size_t i, Distance gap, const CornerGrip& along) const {
    const CornerAndEdge& corner = corners_[i];
    const double past_end = along.path - corner.edge_end, before_begin = corner.edge_begin - along.path;
    const double beside = std::max(past_end, before_begin);
    if (this->is_touching(i)) return gap;
    // An open corner behind the line of its edge has passed an end: its distance is positive there too.
    const double apart = std::abs(gap.value), apart_rate = gap.value < 0.0 ? -gap.rate : gap.rate;
    if (beside <= 0.0) return {apart, apart_rate};
    const double value = std::hypot(apart, beside);
    return {value, (apart * apart_rate + beside * (past_end > before_begin ? along.rate : -along.rate)) / value};
  }

  // After a step: an open corner beyond an end misses the edge. If it then moves behind the line of the edge,
  // it misses the edge until it is in front of the line again.
  void watch_ends(std::size_t i) {
    if (this->is_touching(i)) {
      misses_[i] = 0;
      return;
    }
    const double path = now_grips_[i].path;
    const bool behind = misses_[i] != 0 && gaps_[i].value < 0.0;
    misses_[i] = behind || corners_[i].margin_at_ends(path) < 0.0 ? 1 : 0;
  }

  // A corner that misses stays open: its indentation counts as a distance.
  void keep_open(std::size_t i) {
    if (this->now_.deformations[i] > 0.0) this->now_.rates[i] = -this->now_.rates[i];
    constexpr double apart = 1e-9;  // m
    this->now_.deformations[i] = -std::abs(this->now_.deformations[i]) - apart;
  }
  void keep_open_at_start(std::size_t i) {
    gaps_[i].value = -std::abs(this->start_.deformations[i]);
    this->start_.deformations[i] = -std::abs(this->start_.deformations[i]);
  }

  std::vector<CornerAndEdge> corners_;
  std::vector<CornerGrip> now_grips_, start_grips_;  // at the last evaluate(), and at the last commit
  std::vector<double> slide_begins_;                 // in the last step, as fractions of it
  std::vector<CornerGripEnergy> grip_energies_;
  std::vector<double> speeds_at_touch_;  // along the edges, m/s
  std::vector<char> misses_;             // at the last commit: beside its edge
  std::vector<Distance> gaps_;  // along the normals, m, at the last evaluate(); negative behind the edge's line
  std::vector<int> times_left_;
  bool friction_changed_ = false;
};

}  // namespace moat
