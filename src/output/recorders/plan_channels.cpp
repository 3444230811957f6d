#include "output/recorders/plan_channels.hpp"

#include <algorithm>

#include "model/building.hpp"
#include "output/recorders/channels.hpp"

namespace moat {
namespace {

constexpr auto on_ground = static_cast<std::size_t>(-1);

// Quantities of a node, in the order of its channels.
constexpr std::size_t of_displacement = 0, of_acceleration = 2, per_node = 3;

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

PlanChannels::PlanChannels(const Model& model, ChannelList& list) : first_{list.size()} {
  for (const PlacedDiaphragm& diaphragm : model.diaphragms()) add_diaphragm(model, diaphragm, list);
  for (const Building& building : all_buildings(model)) add_drifts(model, building, list);
  // The order of sample(): all drifts at corners before those at centres.
  for (const Drift& drift : corner_drifts_) {
    const PlacedDiaphragm& floor = model.diaphragm(drift.of);
    const auto corner = static_cast<std::size_t>(&drift - corner_drifts_.data());
    std::size_t of_floor = 0;
    for (std::size_t i = 0; i < corner; ++i) of_floor += corner_drifts_[i].of == drift.of ? 1 : 0;
    list.add("corner_drift", floor.name + " corner " + std::to_string(of_floor + 1), floor.name, "m");
  }
  for (const Drift& drift : centre_drifts_) {
    const std::string& name = model.diaphragm(drift.of).name;
    list.add("drift_x", name, name, "m");
    list.add("drift_y", name, name, "m");
    list.add("drift_rotation", name, name, "rad");
  }
  add_elements(model, list);
  for (const Building& building : model.buildings()) {
    if (building.shares_base) continue;
    std::vector<DiaphragmId>& floors = buildings_.emplace_back();
    for (const NodeId node : carried_nodes(model, building))
      if (const PlacedDiaphragm* diaphragm = model.diaphragm_of(node)) floors.push_back(diaphragm->id);
    shears_.push_back(list.size());
    const std::string where = building.base_name();
    list.add("total_base_shear_x", where, where, "N");
    list.add("total_base_shear_y", where, where, "N");
    list.add("total_base_torque", where, where, "N m");
  }
}

void PlanChannels::add_diaphragm(const Model& model, const PlacedDiaphragm& diaphragm, ChannelList& list) {
  const auto add = [&](PlanVector arm, const std::string& prefix, const std::string& where) {
    points_.push_back({Channels::of_node(model, diaphragm.id.x), arm});
    list.add(prefix + "displacement", where, diaphragm.name, "m");
    list.add(prefix.empty() ? "absolute_acceleration" : prefix + "acceleration", where, diaphragm.name, "m/s^2");
  };
  add({}, "", diaphragm.name);
  for (std::size_t i = 0; i < diaphragm.outline.size(); ++i)
    add(diaphragm.outline.corner(i) - diaphragm.centre_of_mass, "corner_",
        diaphragm.name + " corner " + std::to_string(i + 1));
}

void PlanChannels::add_drifts(const Model& model, const Building& building, ChannelList&) {
  const PlacedDiaphragm* below = model.diaphragm_of(building.base);
  for (const NodeId node : building.floors) {
    const PlacedDiaphragm* floor = model.diaphragm_of(node);
    if (floor == nullptr) continue;
    const auto drift_at = [&](PlanVector point) {
      const auto of = [&](const PlacedDiaphragm& each) {
        return Point{Channels::of_node(model, each.id.x), point - each.centre_of_mass};
      };
      return Drift{floor->id, of(*floor), below != nullptr ? of(*below) : Point{on_ground, {}}};
    };
    for (std::size_t i = 0; i < floor->outline.size(); ++i)
      corner_drifts_.push_back(drift_at(floor->outline.corner(i)));
    centre_drifts_.push_back(drift_at(floor->centre_of_mass));
    below = floor;
  }
}

void PlanChannels::add_elements(const Model& model, ChannelList& list) {
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ElementInfo& info = block.info(e);
      if (!info.acts_in_two_directions()) continue;
      planar_.push_back({b, e, !info.deformation_quantity.empty(), !info.force_quantity.empty()});
      for (const auto& [quantity, unit] :
           {std::pair{info.deformation_quantity, "m"}, std::pair{info.force_quantity, "N"}})
        for (const char* component : {"_x", "_y"})
          if (!quantity.empty()) list.add(quantity + component, info.name, info.listed_under(), unit);
    }
  }
  frictions_ = list.size();
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ElementInfo& info = block.info(e);
      if (info.corner_pair() == nullptr) continue;
      sliding_.push_back({b, e, false, true});
      list.add("friction_force", info.name, info.listed_under(), "N");
    }
  }
}

void PlanChannels::sample(const StepView& view, double* values, double* rates) const {
  const Model& model = view.model;
  const AnalysisState& state = view.state;
  double *value = values + first_, *rate = rates + first_;
  // From values or rates of all channels.
  const auto at = [](const Point& point, const double* channels, std::size_t quantity) {
    if (point.floor == on_ground) return PlanVector{};
    const double* x = channels + point.floor + quantity;
    const double turn = x[2 * per_node];
    return PlanVector{x[0] - point.arm.y * turn, x[per_node] + point.arm.x * turn};
  };
  const auto rotation = [](const Point& point, const double* channels, std::size_t quantity) {
    return point.floor == on_ground ? 0.0 : channels[point.floor + 2 * per_node + quantity];
  };
  for (const Point& point : points_)
    for (const std::size_t quantity : {of_displacement, of_acceleration})
      write_length(at(point, values, quantity), at(point, rates, quantity), value, rate);
  const auto drift_of = [&](const Drift& drift, const double* channels) {
    return at(drift.upper, channels, of_displacement) - at(drift.lower, channels, of_displacement);
  };
  for (const Drift& drift : corner_drifts_) write_length(drift_of(drift, values), drift_of(drift, rates), value, rate);
  for (const Drift& drift : centre_drifts_) {
    const PlanVector difference = drift_of(drift, values), speed = drift_of(drift, rates);
    write(difference.x, speed.x, value, rate);
    write(difference.y, speed.y, value, rate);
    const auto turn = [&](const double* channels) {
      return rotation(drift.upper, channels, of_displacement) - rotation(drift.lower, channels, of_displacement);
    };
    write(turn(values), turn(rates), value, rate);
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
               inertia_rates = coupled ? inertia_of(view, true) : Vector{};
  for (const std::vector<DiaphragmId>& floors : buildings_) {
    // The force from outside is the inertia of base and floors.
    PlanVector force, force_rate;
    double torque = 0.0, torque_rate = 0.0;
    const bool follows = follow(floors);
    for (const DiaphragmId& id : floors) {
      const PlacedDiaphragm& floor = *model.diaphragm_of(id.x);
      const Point centre{Channels::of_node(model, id.x), {}};
      const auto add = [&](const double* channels, const Vector& coupled_inertia, PlanVector& sum, double& moment) {
        PlanVector own = floor.mass * at(centre, channels, of_acceleration);
        double turning = floor.mass * floor.gyration * floor.gyration * rotation(centre, channels, of_acceleration);
        if (coupled && !follows) {
          own = {coupled_inertia[id.x.index], coupled_inertia[id.y.index]};
          turning = floor.gyration * coupled_inertia[id.r.index];
        }
        sum += -1.0 * own;
        moment -= cross(floor.centre_of_mass, own) + turning;
      };
      add(values, inertia, force, torque);
      add(rates, inertia_rates, force_rate, torque_rate);
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
    if (points_[i].floor == Channels::of_node(model, body)) bent.push_back(first_ + 2 * i + 1);
  for (std::size_t b = 0; b < buildings_.size(); ++b)
    if (std::ranges::find(buildings_[b], diaphragm->id) != buildings_[b].end())
      for (std::size_t k = 0; k < 3; ++k) bent.push_back(shears_[b] + k);
}

}  // namespace moat
