#include "output/recorders/plan_channels.hpp"

#include <algorithm>

#include "model/building.hpp"

namespace moat {
namespace {

// Displacement, velocity, absolute acceleration and jerk of a point.
struct PointMotion {
  PlanVector displacement, velocity, acceleration, jerk;
};

// At a point of a floor; `of` gives the value of a node.
template <class OfNode>
PlanVector at(const PlacedDiaphragm& floor, PlanVector arm, const OfNode& of) {
  const double turn = of(floor.id.r) / floor.gyration;
  return {of(floor.id.x) - arm.y * turn, of(floor.id.y) + arm.x * turn};
}

void write_length(PlanVector vector, PlanVector vector_rate, double*& value, double*& rate) {
  const double size = length(vector);
  *value++ = size;
  *rate++ = size > 0.0 ? dot(vector, vector_rate) / size : 0.0;
}

// M a of all degrees of freedom, N, or its rate.
Vector inertia_of(const StepView& view, bool of_rate) {
  const int count = view.model.degrees_of_freedom();
  Vector accelerations{count}, inertia{count};
  for (int i = 0; i < count; ++i)
    accelerations[i] = of_rate ? view.state.jerk(NodeId{i}) : view.absolute_acceleration(NodeId{i});
  view.model.mass_matrix().multiply(accelerations.data(), inertia.data());
  return inertia;
}

void write(double of_value, double of_rate, double*& value, double*& rate) {
  *value++ = of_value;
  *rate++ = of_rate;
}

}  // namespace

PlanChannels::PlanChannels(const Model& model, std::vector<Channel>& list) {
  for (const PlacedDiaphragm& diaphragm : model.diaphragms()) add_diaphragm(diaphragm, list);
  for (const Building& building : all_buildings(model)) add_drifts(model, building, list);
  // The order of sample(): all drifts at corners before those at centres.
  for (const Drift& drift : corner_drifts_) {
    const PlacedDiaphragm& floor = model.diaphragm(drift.upper.id);
    const auto corner = static_cast<std::size_t>(&drift - corner_drifts_.data());
    std::size_t of_floor = 0;
    for (std::size_t i = 0; i < corner; ++i) of_floor += corner_drifts_[i].upper.id == drift.upper.id ? 1 : 0;
    list.push_back({"corner_drift", floor.name + " corner " + std::to_string(of_floor + 1), floor.name, "m"});
  }
  for (const Drift& drift : centre_drifts_) {
    const std::string& name = model.diaphragm(drift.upper.id).name;
    list.push_back({"drift_x", name, name, "m"});
    list.push_back({"drift_y", name, name, "m"});
    list.push_back({"drift_rotation", name, name, "rad"});
  }
  add_elements(model, list);
  for (const Building& building : model.buildings()) {
    if (building.shares_base) continue;
    std::vector<DiaphragmId>& floors = buildings_.emplace_back();
    for (const NodeId node : carried_nodes(model, building))
      if (const PlacedDiaphragm* diaphragm = model.diaphragm_of(node)) floors.push_back(diaphragm->id);
    shears_.push_back(list.size());
    const std::string where = building.base_name();
    list.push_back({"total_base_shear_x", where, where, "N"});
    list.push_back({"total_base_shear_y", where, where, "N"});
    list.push_back({"total_base_torque", where, where, "N m"});
  }
}

void PlanChannels::add_diaphragm(const PlacedDiaphragm& diaphragm, std::vector<Channel>& list) {
  const auto add = [&](PlanVector arm, const std::string& prefix, const std::string& where) {
    points_.push_back({diaphragm.id, arm});
    list.push_back({prefix + "displacement", where, diaphragm.name, "m"});
    accelerations_.push_back(list.size());
    list.push_back(
        {prefix.empty() ? "absolute_acceleration" : prefix + "acceleration", where, diaphragm.name, "m/s^2"});
  };
  add({}, "", diaphragm.name);
  for (std::size_t i = 0; i < diaphragm.outline.size(); ++i)
    add(diaphragm.outline.corner(i) - diaphragm.centre_of_mass, "corner_",
        diaphragm.name + " corner " + std::to_string(i + 1));
}

void PlanChannels::add_drifts(const Model& model, const Building& building, std::vector<Channel>&) {
  const PlacedDiaphragm* below = model.diaphragm_of(building.base);
  for (const NodeId node : building.floors) {
    const PlacedDiaphragm* floor = model.diaphragm_of(node);
    if (floor == nullptr) continue;
    const auto drift_at = [&](PlanVector point) {
      return Drift{
          {floor->id, point - floor->centre_of_mass},
          below != nullptr ? Point{below->id, point - below->centre_of_mass} : Point{{ground, ground, ground}, {}}};
    };
    for (std::size_t i = 0; i < floor->outline.size(); ++i)
      corner_drifts_.push_back(drift_at(floor->outline.corner(i)));
    centre_drifts_.push_back(drift_at(floor->centre_of_mass));
    below = floor;
  }
}

void PlanChannels::add_elements(const Model& model, std::vector<Channel>& list) {
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ElementInfo& info = block.info(e);
      if (!info.acts_in_two_directions()) continue;
      planar_.push_back({b, e, !info.deformation_quantity.empty(), !info.force_quantity.empty()});
      for (const auto& [quantity, unit] :
           {std::pair{info.deformation_quantity, "m"}, std::pair{info.force_quantity, "N"}})
        for (const char* component : {"_x", "_y"})
          if (!quantity.empty()) list.push_back({quantity + component, info.name, info.listed_under(), unit});
    }
  }
  frictions_ = list.size();
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ElementInfo& info = block.info(e);
      if (info.corner_pair() == nullptr) continue;
      sliding_.push_back({b, e, false, true});
      list.push_back({"friction_force", info.name, info.listed_under(), "N"});
    }
  }
}

void PlanChannels::sample(const StepView& view, double*& value, double*& rate) const {
  const Model& model = view.model;
  const AnalysisState& state = view.state;
  const auto motion_of = [&](const Point& point) {
    if (point.id.x == ground) return PointMotion{};
    const PlacedDiaphragm& floor = *model.diaphragm_of(point.id.x);
    return PointMotion{at(floor, point.arm, [&](NodeId node) { return state.displacement(node); }),
                       at(floor, point.arm, [&](NodeId node) { return state.velocity(node); }),
                       at(floor, point.arm, [&](NodeId node) { return state.acceleration(node); }) +
                           view.ground_acceleration.horizontal(),
                       at(floor, point.arm, [&](NodeId node) { return state.jerk(node); })};
  };
  for (const Point& point : points_) {
    const PointMotion motion = motion_of(point);
    write_length(motion.displacement, motion.velocity, value, rate);
    write_length(motion.acceleration, motion.jerk, value, rate);
  }
  for (const Drift& drift : corner_drifts_) {
    const PointMotion upper = motion_of(drift.upper), lower = motion_of(drift.lower);
    write_length(upper.displacement - lower.displacement, upper.velocity - lower.velocity, value, rate);
  }
  for (const Drift& drift : centre_drifts_) {
    const PointMotion upper = motion_of(drift.upper), lower = motion_of(drift.lower);
    const PlanVector difference = upper.displacement - lower.displacement, speed = upper.velocity - lower.velocity;
    write(difference.x, speed.x, value, rate);
    write(difference.y, speed.y, value, rate);
    const bool on_floor = drift.lower.id.x != ground;
    write(state.rotation(drift.upper.id) - (on_floor ? state.rotation(drift.lower.id) : 0.0),
          state.angular_velocity(drift.upper.id) - (on_floor ? state.angular_velocity(drift.lower.id) : 0.0), value,
          rate);
  }
  for (const ElementOfBlock& element : planar_) {
    const ResultsOf<PlanVector> results = state.elements(element.block).results().plan;
    const auto write_both = [&](PlanVector of_value, PlanVector of_rate) {
      write(of_value.x, of_rate.x, value, rate);
      write(of_value.y, of_rate.y, value, rate);
    };
    if (element.has_deformation) write_both(results.deformations[element.element], results.rates[element.element]);
    if (element.has_force) write_both(results.forces[element.element], results.force_rates[element.element]);
  }
  for (const ElementOfBlock& element : sliding_) {
    const ContactView contact = state.elements(element.block).contact(element.element);
    write(contact.friction_force, contact.friction_force_rate, value, rate);
  }
  // Masses that couple floors count too, but for those of floors that follow modes: these have masses of their own.
  const auto follow = [](const std::vector<DiaphragmId>& floors) {
    return std::ranges::any_of(floors, [](const DiaphragmId& id) { return id.x.is_follower(); });
  };
  const bool coupled = !model.mass_matrix().is_diagonal() && !std::ranges::all_of(buildings_, follow);
  const Vector inertia = coupled ? inertia_of(view, false) : Vector{},
               rates = coupled ? inertia_of(view, true) : Vector{};
  for (const std::vector<DiaphragmId>& floors : buildings_) {
    // The force from outside is the inertia of base and floors.
    PlanVector force, force_rate;
    double torque = 0.0, torque_rate = 0.0;
    const bool follows = follow(floors);
    for (const DiaphragmId& id : floors) {
      if (coupled && !follows) {
        const PlacedDiaphragm& floor = *model.diaphragm_of(id.x);
        const auto add = [&](const Vector& of, PlanVector& sum, double& moment) {
          const PlanVector own{of[id.x.index], of[id.y.index]};
          sum += -1.0 * own;
          moment -= cross(floor.centre_of_mass, own) + floor.gyration * of[id.r.index];
        };
        add(inertia, force, torque);
        add(rates, force_rate, torque_rate);
        continue;
      }
      const PlacedDiaphragm& floor = *model.diaphragm_of(id.x);
      const PointMotion centre = motion_of({id, {}});
      force += -floor.mass * centre.acceleration;
      force_rate += -floor.mass * centre.jerk;
      torque -=
          floor.mass * (cross(floor.centre_of_mass, centre.acceleration) + floor.gyration * state.acceleration(id.r));
      torque_rate -= floor.mass * (cross(floor.centre_of_mass, centre.jerk) + floor.gyration * state.jerk(id.r));
    }
    write(force.x, force_rate.x, value, rate);
    write(force.y, force_rate.y, value, rate);
    write(torque, torque_rate, value, rate);
  }
}

void PlanChannels::add_friction(std::size_t block, std::size_t element, std::vector<std::size_t>& bent) const {
  const auto found = std::ranges::find_if(
      sliding_, [&](const ElementOfBlock& each) { return each.block == block && each.element == element; });
  if (found != sliding_.end()) bent.push_back(frictions_ + static_cast<std::size_t>(found - sliding_.begin()));
}

void PlanChannels::add_bent_by(const Model& model, NodeId body, std::vector<std::size_t>& bent) const {
  const PlacedDiaphragm* diaphragm = body == ground ? nullptr : model.diaphragm_of(body);
  if (diaphragm == nullptr || diaphragm->id.x != body) return;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[i].id == diaphragm->id) bent.push_back(accelerations_[i]);
  for (std::size_t b = 0; b < buildings_.size(); ++b)
    if (std::ranges::find(buildings_[b], diaphragm->id) != buildings_[b].end())
      for (std::size_t k = 0; k < 3; ++k) bent.push_back(shears_[b] + k);
}

}  // namespace moat
