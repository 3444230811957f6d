// Contacts of corners with edges, with friction.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "elements/contact_links.hpp"
#include "elements/plan_ends.hpp"
#include "model/plan_contacts.hpp"

namespace moat {

/// Coulomb friction of a contact.
struct ContactFriction {
  double coefficient = 0.0;           ///< mu, 0 to 1; 0 is no friction
  double tangential_stiffness = 0.0;  ///< k_t > 0 N/m
};

/// All contacts of corners with edges that have a normal law of type Law. The normal force F_n is that of ContactLinks
/// along the normal n. Along the tangent t (model/plan_contacts.hpp) acts Coulomb friction, by return mapping with the
/// slip s as history:
///
///     e = k_t (u_t - s),  F_t = clamp(e, -mu F_n, mu F_n),  s follows where it is clamped
///
/// At touch s = u_t. The force on the corner's body is -F_n n - F_t t. Only the normal phases are located: grip changes
/// stay inside steps, where they are kinks and no jumps.
///
/// A corner that crosses the line of an edge beside the edge's ends does not touch it, until it comes back. A corner in
/// contact that slides past an end by more than 1 % of the edge's length is released.
template <ContactLaw Law>
class CornerContacts final : public ContactLinks<Law, PlanEnds>, public PlanContacts {
  using Base = ContactLinks<Law, PlanEnds>;

 public:
  using State = ContactState;

  /// One contact. The edge reaches from `edge_begin` to `edge_end` > edge_begin along t, from the corner at rest, m.
  struct Corner {
    CornerPair pair;
    PlanEndsBothWays ends;  ///< along n and t, of the corner relative to the edge
    ContactFriction friction;
    double edge_begin = 0.0, edge_end = 0.0;
    double normal_mass = 0.0, tangential_mass = 0.0;  ///< effective, kg
  };

  std::size_t add(ElementInfo info, const Law& law, const Corner& corner) {
    corners_.push_back(corner);
    const std::size_t count = corners_.size();
    now_slides_.resize(count);
    start_slides_.resize(count);
    losses_.resize(count);
    misses_.resize(count, 0);
    return Base::add(std::move(info), law, corner.normal_mass, corner.ends.along());
  }

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<CornerContacts>(*this); }
  const PlanContacts* plan_contacts() const override { return this; }
  bool linear_between_events() const override { return false; }

  void add_couplings(PatternBuilder& pattern) const override {
    Base::add_couplings(pattern);
    for (const Corner& corner : corners_) corner.ends.add_couplings(pattern);
  }
  void find_slots(const SparseMatrix& matrix) override {
    Base::find_slots(matrix);
    for (std::size_t i = 0; i < corners_.size(); ++i) corners_[i].ends.find(this->infos_[i], matrix);
  }

  void evaluate(const double* displacement, const double* velocity, double* force) override {
    Base::evaluate(displacement, velocity, force);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const PlanEnds& across = corners_[i].ends.across();
      Slide& now = now_slides_[i];
      const bool slid = now.slides;
      const double stiffness = now.stiffness;
      now.path = across.difference(displacement);
      now.rate = across.difference(velocity);
      grip(i);
      friction_changed_ |= slid != now.slides || stiffness != now.stiffness || now.slides;
      if (force != nullptr && now.force != 0.0) across.add_force(now.force, force);
      if (misses_[i] != 0 && !this->is_touching(i)) keep_open(i);
    }
  }

  void evaluate_rates(const double* acceleration, double* force_rate) override {
    Base::evaluate_rates(acceleration, force_rate);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      Slide& now = now_slides_[i];
      now.force_rate = now.slides ? now.sense * coefficient(i) * this->force_rates_[i] : now.stiffness * now.rate;
      now.second_rate = corners_[i].ends.across().difference(acceleration);
      if (force_rate != nullptr && now.force_rate != 0.0)
        corners_[i].ends.across().add_force(now.force_rate, force_rate);
    }
  }

  void add_tangent(double displacement_weight, double velocity_weight, double* values) const override {
    Base::add_tangent(displacement_weight, velocity_weight, values);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Slide& now = now_slides_[i];
      const double coupling =
          now.slides ? now.sense * coefficient(i) *
                           (displacement_weight * this->stiffnesses_[i] + velocity_weight * this->dampings_[i])
                     : 0.0;
      const double stiffness = displacement_weight * now.stiffness;
      if (coupling != 0.0 || stiffness != 0.0) corners_[i].ends.add_stiffness({0.0, 0.0, coupling, stiffness}, values);
    }
  }
  bool take_tangent_change() override {
    const bool changed = Base::take_tangent_change();
    return std::exchange(friction_changed_, false) || changed;
  }
  /// Whether a corner began or ended to slide.
  bool has_corner() const override {
    for (std::size_t i = 0; i < corners_.size(); ++i)
      if (now_slides_[i].slides != start_slides_[i].slides || now_slides_[i].stiffness != start_slides_[i].stiffness)
        return true;
    return false;
  }

  void scan(double step, double aim, RegimeScan& scan) const override {
    Base::scan(step, aim, scan);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!this->is_touching(i)) continue;
      const double margin = margin_at_ends(i, now_slides_[i].path);
      scan.margin = std::min(scan.margin, margin);
      if (margin >= 0.0) continue;
      const double before = margin_at_ends(i, start_slides_[i].path);
      scan.crossed = true;
      ++scan.crossings;
      scan.fraction = std::min(scan.fraction, std::clamp((before - aim) / (before - margin), 0.0, 1.0));
    }
  }

  void change(std::size_t block_index, std::vector<RegimeChange>& changes) override {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!this->is_touching(i) || margin_at_ends(i, start_slides_[i].path) >= 0.0) continue;
      changes.push_back({.block = block_index, .element = i, .rate = this->start_.rates[i]});
      const double stored_before = this->stored(i);
      enter(i, {}, this->start_.rates[i], changes.back());
      this->energies_.release(i, stored_before - this->stored(i));
      misses_[i] = 1;
      keep_open_at_start(i);
      ++past_an_end_;
    }
    Base::change(block_index, changes);
  }

  void commit(double step, WorkRule rule) override {
    const bool kept = this->energies_.kept();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (kept) add_step(i, step, rule);
      watch_ends(i);
    }
    start_slides_ = now_slides_;
    Base::commit(step, rule);
  }

  void start_energy_accounts() override {
    Base::start_energy_accounts();
    start_slides_ = now_slides_;
    for (std::size_t i = 0; i < corners_.size(); ++i)
      losses_[i] = {.stored_at_start = stored_by_grip(i, now_slides_[i])};
  }
  ElementEnergy energy(std::size_t i) const override {
    ElementEnergy energy = Base::energy(i);
    energy.work += losses_[i].work;
    energy.stored += stored_by_grip(i, start_slides_[i]) - losses_[i].stored_at_start;
    energy.friction = losses_[i].friction;
    return energy;
  }

  /// The tangential spring has a duration of its own: half a period.
  double shortest_contact() const override {
    double shortest = Base::shortest_contact();
    if (!std::isfinite(shortest)) return shortest;
    for (std::size_t i = 0; i < corners_.size(); ++i)
      if (this->is_touching(i) && coefficient(i) > 0.0)
        shortest = std::min(shortest, std::numbers::pi * std::sqrt(corners_[i].tangential_mass /
                                                                   corners_[i].friction.tangential_stiffness));
    return shortest;
  }

  const CornerPair& pair(std::size_t i) const override { return corners_[i].pair; }
  double friction_force(std::size_t i) const override { return now_slides_[i].force; }
  double friction_force_rate(std::size_t i) const override { return now_slides_[i].force_rate; }
  double tangential_speed_at_touch(std::size_t i) const override { return losses_[i].speed_at_touch; }
  int corners_past_an_end() const override { return past_an_end_; }

 protected:
  void enter(std::size_t i, const State& next, double rate, RegimeChange& change) override {
    const bool touched_before = this->is_touching(i);
    Base::enter(i, next, rate, change);
    if (touched_before || !this->is_touching(i)) return;
    // At touch the spring is relaxed.
    start_slides_[i].slip = start_slides_[i].path;
    losses_[i].speed_at_touch = start_slides_[i].rate;
  }
  /// The slip at touch is known where a step ends, and not inside.
  bool jumps_at_entry(std::size_t i, const State& next, double rate) const override {
    return (coefficient(i) > 0.0 && !this->is_touching(i)) || Base::jumps_at_entry(i, next, rate);
  }

 private:
  // The motion along the edge and its friction.
  struct Slide {
    double path = 0.0, rate = 0.0, second_rate = 0.0;  // u_t, m, and its rates
    double slip = 0.0;                                 // s, m
    double force = 0.0, force_rate = 0.0;              // F_t, N, N/s
    double stiffness = 0.0;                            // dF_t/du_t, N/m
    double sense = 0.0;                                // of the sliding: -1 or 1
    bool slides = false;
  };
  struct Losses {
    double work = 0.0, friction = 0.0, stored_at_start = 0.0;  // J
    double speed_at_touch = 0.0;                               // m/s
  };

  [[nodiscard]] double coefficient(std::size_t i) const { return corners_[i].friction.coefficient; }

  // Return mapping from the committed slip.
  void grip(std::size_t i) {
    Slide& now = now_slides_[i];
    const double limit = coefficient(i) * std::max(this->forces_[i], 0.0);
    now.slides = false;
    now.sense = now.stiffness = now.force = 0.0;
    if (limit == 0.0) {
      now.slip = now.path;
      return;
    }
    const double stiffness = corners_[i].friction.tangential_stiffness;
    const double elastic = stiffness * (now.path - start_slides_[i].slip);
    if (std::abs(elastic) <= limit) {
      now.slip = start_slides_[i].slip;
      now.force = elastic;
      now.stiffness = stiffness;
      return;
    }
    now.slides = true;
    now.sense = elastic > 0.0 ? 1.0 : -1.0;
    now.force = now.sense * limit;
    now.slip = now.path - now.force / stiffness;
  }

  [[nodiscard]] double stored_by_grip(std::size_t i, const Slide& slide) const {
    return slide.force == 0.0 ? 0.0 : 0.5 * slide.force * slide.force / corners_[i].friction.tangential_stiffness;
  }

  void add_step(std::size_t i, double step, WorkRule rule) {
    const Slide &start = start_slides_[i], &now = now_slides_[i];
    Losses& losses = losses_[i];
    if (step == 0.0) {
      // The same instant again: where the normal force jumped down, the grip gives up its energy.
      losses.friction += std::max(stored_by_grip(i, start) - stored_by_grip(i, now), 0.0);
      return;
    }
    if (start.force == 0.0 && now.force == 0.0) return;
    const double mean = 0.5 * (start.force + now.force);
    losses.friction += mean * (now.slip - start.slip);
    losses.work += mean * (now.path - start.path);
    if (rule == WorkRule::mean_force) return;
    // The power is smooth but for kinks: the trapezoidal rule with its correction by the rates at the ends.
    const auto power_rate = [](const Slide& slide) {
      return slide.force_rate * slide.rate + slide.force * slide.second_rate;
    };
    losses.work += 0.5 * step * (start.force * start.rate + now.force * now.rate) - mean * (now.path - start.path) +
                   step * step / 12.0 * (power_rate(start) - power_rate(now));
  }

  // > 0 while the corner is beside the edge, or past an end by less than 1 % of it, m.
  [[nodiscard]] double margin_at_ends(std::size_t i, double path) const {
    const Corner& corner = corners_[i];
    const double beyond = std::max(path - corner.edge_end, corner.edge_begin - path);
    return 0.01 * (corner.edge_end - corner.edge_begin) - beyond;
  }

  // After a step: whether an open corner misses the edge. Once behind its line it misses until it comes back.
  void watch_ends(std::size_t i) {
    if (this->is_touching(i)) {
      misses_[i] = 0;
      return;
    }
    const double path = now_slides_[i].path;
    const bool behind = misses_[i] != 0 && indentations_behind(i) > 0.0;
    misses_[i] = behind || margin_at_ends(i, path) < 0.0 ? 1 : 0;
  }

  // The true indentation of a corner that misses its edge; keep_open() has changed the sign of a positive one.
  [[nodiscard]] double indentations_behind(std::size_t i) const { return behind_.empty() ? 0.0 : behind_[i]; }

  // A corner that misses stays open: its indentation counts as a distance.
  void keep_open(std::size_t i) {
    behind_.resize(corners_.size(), 0.0);
    behind_[i] = this->now_.deformations[i];
    if (this->now_.deformations[i] > 0.0) this->now_.rates[i] = -this->now_.rates[i];
    constexpr double apart = 1e-9;  // m
    this->now_.deformations[i] = -std::abs(this->now_.deformations[i]) - apart;
  }
  void keep_open_at_start(std::size_t i) {
    behind_.resize(corners_.size(), 0.0);
    behind_[i] = std::abs(this->start_.deformations[i]);
    this->start_.deformations[i] = -std::abs(this->start_.deformations[i]);
  }

  std::vector<Corner> corners_;
  std::vector<Slide> now_slides_, start_slides_;  // at the last evaluate(), and at the last commit
  std::vector<Losses> losses_;
  std::vector<char> misses_;    // at the last commit: beside its edge
  std::vector<double> behind_;  // m, where they miss
  int past_an_end_ = 0;
  bool friction_changed_ = false;
};

}  // namespace moat
