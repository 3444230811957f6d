// The equations of motion of the independent reference, regime by regime.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "plain_model.hpp"
#include "reference_contact.hpp"

namespace moat::testing {

/// Positions and velocities relative to the ground, and accelerations relative to the ground.
struct ReferenceState {
  std::vector<double> displacement, velocity, acceleration;
};

/// A reported quantity with its time derivative.
struct ReferenceChannel {
  double value = 0.0, rate = 0.0;
};

/// M a + f(u, v) = -M a_g with dense loops over the elements. Within a regime of all elements f is smooth. A regime
/// lasts while all its margins are positive; change_regimes() leads beyond those that are negative.
class ReferenceSystem {
 public:
  explicit ReferenceSystem(const PlainModel& model);

  [[nodiscard]] std::size_t size() const { return masses_.size(); }

  /// a = -f(u, v)/M - a_g.
  void accelerations(const double* displacement, const double* velocity, double ground, double* acceleration) const;

  /// A margin of a regime with its time derivative.
  struct Margin {
    double value = 0.0, rate = 0.0;
  };
  /// The margins of all elements, in a fixed order. Regimes without one report 1.
  void margins(const ReferenceState& state, std::vector<Margin>& margins) const;
  struct Touch {
    std::size_t gap = 0;          ///< index in the problem
    double approach_speed = 0.0;  ///< m/s
  };
  /// Touches are appended to `touches`.
  void change_regimes(const ReferenceState& state, std::vector<Touch>& touches);

  /// Quantity and place of every channel; several may share both.
  struct ChannelName {
    std::string quantity, where;
  };
  [[nodiscard]] const std::vector<ChannelName>& channel_names() const { return channel_names_; }
  void channels(const ReferenceState& state, double ground, std::vector<ReferenceChannel>& channels) const;

  /// An upper bound of the frequencies of the current regimes, 1/s, contacts included.
  [[nodiscard]] double fastest(const ReferenceState& state) const;

 private:
  enum class Kind { spring, dashpot, bearing, gap };
  enum class Phase { open, loaded, released };

  struct Link {
    Kind kind = Kind::spring;
    // d = sum of weight * u - offset.
    std::array<int, 4> node{};
    std::array<double, 4> weight{};
    int terms = 0;
    double offset = 0.0;

    double stiffness = 0.0, damping = 0.0;  // spring, dashpot
    // Bearing: post-yield spring beside a spring that slides at `limit` of its stretch d - slip.
    double sliding_stiffness = 0.0, limit = 0.0, slip = 0.0;
    int direction = 0;  // of sliding
    // Gap.
    ReferenceContact contact;
    double effective_mass = 0.0, approach_speed = 0.0;
    Phase phase = Phase::open;
    bool approaching = false;
    std::size_t gap = 0;
    bool reports = true, reports_yielding = false;
  };

  static constexpr int margins_per_link = 2;

  void attach(Link& link, int node, double weight);
  void attach(Link& link, const PlainPoint& point, double sign);
  [[nodiscard]] double sum(const Link& link, const double* values) const;
  [[nodiscard]] ReferenceContact::Response respond(const Link& link, double deformation, double rate) const;
  [[nodiscard]] std::array<Margin, margins_per_link> margins(const Link& link, const ReferenceState& state) const;
  void change_regime(Link& link, const ReferenceState& state, std::vector<Touch>& touches) const;

  std::vector<double> masses_;
  std::vector<Link> links_;
  std::vector<ChannelName> channel_names_;
};

}  // namespace moat::testing
