// The axial forces of the bearings under one building.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/ground_vector.hpp"
#include "base/units.hpp"
#include "model/building.hpp"
#include "model/element_states.hpp"
#include "model/weight/axial_distribution.hpp"
#include "model/weight/axial_forces.hpp"
#include "model/weight/outside_forces.hpp"
#include "model/weight/weight_coupling.hpp"

namespace moat {

struct MotionState;

/// The axial forces of the bearings of one building with AxialForces, at the trial instant of an analysis. Part of an
/// AnalysisState.
class WeightOnBearings {
 public:
  using Elements = OutsideForces::Elements;  ///< One for each block.

  /// Throws InputError where its bearings, their places or their weights do not fit.
  WeightOnBearings(const Model& model, const Building& building, const Elements& elements);

  /// The building moves so in its vertical mode from now on: the absolute acceleration, m/s^2, and its rate at a time.
  using VerticalMode = std::function<std::pair<double, double>(double time)>;
  /// Takes a vertical mode.
  void move_in(VerticalMode mode) { mode_ = std::move(mode); }
  [[nodiscard]] const AxialForces& options() const { return options_; }  ///< The options of the building.

  /// Finds the axial forces at a motion, under this acceleration of the ground, m/s^2, and gives them to elements whose
  /// law takes one. Elements outside the building must have been evaluated there.
  void press(const MotionState& motion, GroundVector ground_acceleration, const Elements& elements);
  /// After press(): their rates, from the jerks of the motion and the rate of the ground's acceleration, m/s^3.
  void find_rates(const MotionState& motion, double vertical_ground_rate, const Elements& elements);
  /// Fills columns of WeightCoupling from `first` on, one for each direction: the change of the forces on all degrees
  /// of freedom for 1 N m. Returns the next.
  std::size_t fill_columns(const Elements& elements, Eigen::Index size, std::vector<Vector>& columns,
                           std::size_t first) const;
  /// Appends the rows of this building.
  void add_rows(std::vector<std::vector<WeightCoupling::Entry>>& rows) const;

  /// The trial instant is accepted, `step` s after the last one. Throws RockingError where the building rocks and must
  /// not.
  void accept(double step, double time);
  /// After that, with the elements at that instant: notes which bearings became unstable, where their law reports a
  /// `critical_load`.
  void note_instability(double step, double time, const Elements& elements);

  /// Whether the building moves vertically with the ground, without a mode.
  [[nodiscard]] bool moves_with_ground() const { return !mode_; }
  /// Whether the law of a bearing takes its axial force.
  [[nodiscard]] bool acts_on_laws() const { return acts_on_laws_; }

  /// Writes or reads the axial forces and all that was noted.
  void archive(auto& archive) {
    archive(bearings_, distribution_, compressions_, rates_, shifts_, shift_rates_, moment_, moment_rate_, vertical_,
            vertical_rate_, rocks_, rocking_time_, first_rocking_);
  }

  /// A bearing and its results.
  struct Bearing {
    ElementId element;             ///< Finds it in the model.
    BearingOnSlab on_slab;         ///< Place and stiffness, as given.
    double compression = 0.0;      ///< N, N; > 0 compression
    double rate = 0.0;             ///< N/s
    double deficit = 0.0;          ///< N, >= 0: vertical stiffness times opening, while it is lifted
    double uplift_time = 0.0;      ///< s, in all
    double largest_deficit = 0.0;  ///< N
    long uplifts = 0;              ///< how often it lifted
    bool lifted = false;           ///< at the last accepted instant
    bool acts_on_law = false;      ///< whether its law takes the axial force
    /// Index of the quantity `critical_load` that its law reports, of one of `count` bearings; none of other laws.
    std::optional<std::size_t> critical_load{};
    double excess = 0.0;     ///< N, of the axial force over the critical load, at the last accepted instant
    long instabilities = 0;  ///< how often it became unstable
    double first_unstable = std::numeric_limits<double>::infinity();  ///< s
  };
  [[nodiscard]] const std::string& building() const { return name_; }            ///< The name of its building.
  [[nodiscard]] NodeId base() const { return base_; }                            ///< The base on the bearings.
  [[nodiscard]] std::span<const Bearing> bearings() const { return bearings_; }  ///< All bearings of the building.
  /// The distance, m, of the load at rest from the centre of mass where that is more than 1 % of the largest distance
  /// of two bearings; else 0.
  [[nodiscard]] double eccentricity() const { return eccentricity_; }
  [[nodiscard]] double vertical_acceleration() const { return vertical_; }            ///< m/s^2, absolute, up positive.
  [[nodiscard]] double vertical_acceleration_rate() const { return vertical_rate_; }  ///< m/s^3
  [[nodiscard]] double load() const { return sigma() * weight_; }                     ///< V, N
  [[nodiscard]] double load_rate() const { return vertical_rate_ / standard_gravity * weight_; }  ///< N/s
  /// The moment of inertia forces and of forces from outside, N m.
  [[nodiscard]] PlanVector overturning_moment() const { return moment_; }
  [[nodiscard]] PlanVector overturning_moment_rate() const { return moment_rate_; }  ///< N m/s
  [[nodiscard]] double rocking_time() const { return rocking_time_; }                ///< s, in all
  [[nodiscard]] double first_rocking() const { return first_rocking_; }  ///< s; infinite where it did not rock.

 private:
  [[nodiscard]] double sigma() const { return 1.0 + vertical_ / standard_gravity; }

  // A sum over degrees of freedom, and over the components of the ground.
  struct Form {
    std::vector<WeightCoupling::Entry> entries;
    GroundVector by_ground{};

    void add(const Model& model, NodeId node, double weight);
    [[nodiscard]] double of(const Vector& values) const;
  };
  // Returns the moment of their weights, N m.
  PlanVector add_floors(const std::vector<NodeId>& nodes);
  void add_bearings(const Check& check, PlanVector moment_of_floors);
  // Adds the displacement of a point of a body along an axis.
  void add_point(Form& form, NodeId body, PlanVector at, std::size_t axis, double weight) const;
  [[nodiscard]] double height(NodeId node) const;  // m, above the bearings
  [[nodiscard]] static PlanVector of_both(const Form (&forms)[2], const Vector& values) {
    return {forms[0].of(values), forms[1].of(values)};
  }

  std::string name_;
  AxialForces options_;
  NodeId base_;
  double level_ = 0.0;  // m, height of the bearings
  bool in_plan_ = false, acts_on_laws_ = false;
  std::vector<Bearing> bearings_;
  AxialDistribution distribution_;
  Form inertia_[2], displaced_[2];  // along x and y: of sum m h, and of sum m g
  std::vector<Form> place_;         // of every bearing, along x and y, times its share above
  OutsideForces outside_;
  const Model* model_;
  double weight_ = 0.0, eccentricity_ = 0.0;  // N, m
  PlanVector static_moment_{};                // N m, of the static weights
  VerticalMode mode_;                         // empty: the building moves with the ground
  // At the trial instant.
  std::vector<double> compressions_, rates_;
  std::vector<PlanVector> shifts_, shift_rates_;
  PlanVector moment_{}, moment_rate_{};
  double vertical_ = 0.0, vertical_rate_ = 0.0;
  bool rocks_ = false;
  double rocking_time_ = 0.0, first_rocking_ = std::numeric_limits<double>::infinity();
};

}  // namespace moat
