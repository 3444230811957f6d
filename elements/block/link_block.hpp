// Elements with one law between two places.
#pragma once

#include <algorithm>
#include <concepts>
#include <deque>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "elements/block/ends.hpp"
#include "elements/block/law_response.hpp"
#include "elements/block/link_states.hpp"
#include "materials/contact/contact_state.hpp"
#include "materials/contact/free_impact.hpp"
#include "model/element_block.hpp"

namespace moat {

/// All elements of a model that put a law of type Law between two places.
///
///     deformation d = u(second) - u(first) - offset;  the law's force pulls `second` back and `first` along.
///
/// A spring has its lower node first; a contact has its right node first and its clearance as offset, so that d is the
/// indentation and a positive force is compression. `Ends` is how the two places are attached: at nodes (NodePair), at
/// points between nodes or in plan along one direction (WeightedEnds), in plan in two directions (PlanEnds), or a
/// corner at an edge with friction (CornerAndEdge). The law has one component, or two with PlanEnds. Corners of the
/// force of a law without regimes are not located; ElementStates::find_corners() shows them.
///
///     model.block<LinkBlock<Linear>>().add({.name = "spring", .first = ground, .second = node}, Linear{...});
template <class Law, class Ends = NodePair>
class LinkBlock final : public ElementBlock {
 public:
  /// Appends an element. effective_mass > 0 kg of a contact is used to estimate its duration, and the approach speed of
  /// a gap that is closed at the start.
  void add(ElementInfo info, const Law& law, const Ends& ends, double effective_mass = 0.0) {
    if constexpr (ContactLaw<Law>) info.drawn_as = DrawnAs::gap;
    infos_.push_back(std::move(info));
    laws_.push_back(law);
    ends_.push_back(ends);
    effective_masses_.push_back(effective_mass);
  }
  /// Adds an element between the nodes of `info`.
  void add(ElementInfo info, const Law& law,
           double effective_mass = 0.0) requires std::constructible_from<Ends, const ElementInfo&> {
    const Ends ends{info};
    add(std::move(info), law, ends, effective_mass);
  }

  /// Puts another law of the type in the place of that of an element, with another description. States that were made
  /// before do not follow.
  void replace(std::size_t e, ElementInfo info, const Law& law) {
    infos_[e] = std::move(info);
    laws_[e] = law;
  }
  /// Replaces the law, and the ends by others between the same bodies.
  void replace(std::size_t e, ElementInfo info, const Law& law, const Ends& ends) {
    replace(e, std::move(info), law);
    ends_[e] = ends;
  }

  [[nodiscard]] const std::vector<Law>& laws() const { return laws_; }   ///< In the order in which they were added.
  [[nodiscard]] const std::vector<Ends>& ends() const { return ends_; }  ///< In the order in which they were added.
  [[nodiscard]] double effective_mass(std::size_t e) const { return effective_masses_[e]; }  ///< kg.

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<LinkBlock>(*this); }
  const std::deque<ElementInfo>& infos() const override { return infos_; }
  BlockKind kind() const override {
    if constexpr (PlanarLaw<Law>)
      return {};
    else
      return {.constant_tangent = LawWithConstantTangents<Law>,
              .linear_between_events = is_linear_between_events(),
              .has_regimes = LawWithRegimes<Law>,
              .contacts = ContactLaw<Law>};
  }
  LawAsGiven law_of_block(std::size_t e) const override {
    return {std::string{name_of(laws_[e])}, parameters_of(laws_[e])};
  }
  std::span<const ReportedQuantity> quantities(std::size_t e) const override { return quantities_of(laws_[e]); }
  double linear_stiffness(std::size_t e, StiffnessStage stage) const override {
    return stage == StiffnessStage::joined ? 1.0 : laws_[e].linear_stiffness(stage);
  }
  double delivered_restitution([[maybe_unused]] std::size_t e, [[maybe_unused]] double approach_speed) const override {
    if constexpr (ContactLaw<Law>) {
      try {
        if (approach_speed > 0.0) return moat::delivered_restitution(laws_[e], effective_masses_[e], approach_speed);
      } catch (const Error&) {
        // A contact that never ends has no restitution; the impact itself is reported all the same.
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  void add_couplings(Couplings& couplings) const override {
    for (const Ends& ends : ends_) ends.add_couplings(couplings);
  }
  void add_stiffness(std::size_t e, double stiffness, SparseMatrix& matrix) const override {
    const typename Ends::Slots slots{ends_[e], matrix};
    if constexpr (PlanarLaw<Law>)
      slots.add_stiffness(ends_[e], PlanMatrix::diagonal(stiffness), matrix.valuePtr());
    else
      slots.add_stiffness(ends_[e], stiffness, matrix.valuePtr());
  }
  std::unique_ptr<ElementStates> make_states(const SparseMatrix& matrix) const override {
    return std::make_unique<LinkStates<LinkBlock, Law, Ends>>(*this, matrix);
  }

 private:
  [[nodiscard]] bool is_linear_between_events() const {
    if constexpr (ContactLaw<Law>)
      return std::same_as<Ends, NodePair> || std::same_as<Ends, WeightedEnds>;  // a closed gap does not count
    else if constexpr (requires(const Law& law) { law.is_linear_within_regimes(); })
      return std::ranges::all_of(laws_, &Law::is_linear_within_regimes);
    else
      return LinearWithinRegimes<Law>;
  }

  std::deque<ElementInfo> infos_;
  std::vector<Law> laws_;
  std::vector<Ends> ends_;
  std::vector<double> effective_masses_;  // kg
};

}  // namespace moat
