#include "output/recorders/channels.hpp"

#include <algorithm>
#include <utility>

namespace moat {

Channels::Channels(const Model& model) {
  for (int i = 0; i < model.nodes(); ++i) add_node(model, model.node(i));
  for (std::size_t b = 0; b < model.blocks().size(); ++b) add_elements(model, b);
  for (const Building& building : model.buildings())
    for (const StoreyResult& result : building.storey_results) {
      storey_sums_.push_back({list_.size(), &result});
      list_.add(result.quantity, result.place, result.place, result.unit);
    }
  weights_ = WeightChannels{model, list_};
  base_shear_of_node_.assign(static_cast<std::size_t>(model.nodes()), -1);
  if (model.is_plan()) {
    plan_ = PlanChannels{model, list_};
    return;
  }
  for (const Building& building : model.buildings()) {
    if (building.shares_base) continue;
    std::vector<NodeId> nodes = carried_nodes(model, building);
    const bool has_followers = std::ranges::any_of(nodes, &NodeId::is_follower);
    base_shears_.push_back({list_.size(), std::move(nodes), has_followers});
    for (const NodeId node : base_shears_.back().nodes)
      base_shear_of_node_[static_cast<std::size_t>(model.place(node))] = static_cast<int>(list_.size());
    list_.add("total_base_shear", building.base_name(), building.base_name(), "N");
  }
}

void Channels::add_elements(const Model& model, std::size_t b) {
  const ElementBlock& block = *model.blocks()[b];
  BlockChannels of_block{b, {}, {}, {}, {}};
  for (std::size_t e = 0; e < block.size(); ++e) {
    const ElementInfo& info = block.info(e);
    if (!info.deformation_quantity.empty()) {
      const bool indentation = block.kind().contacts;
      (indentation ? of_block.indentations : of_block.deformations).push_back({e, list_.size()});
      list_.add(info.deformation_quantity, info.name, info.listed_under(), "m", block.kind().contacts);
    }
    if (info.force_quantity.empty()) continue;
    if (!block.kind().constant_tangent) of_laws_.push_back({list_.size(), b, e});
    of_block.forces.push_back({e, list_.size()});
    list_.add(info.force_quantity, info.name, info.listed_under(), "N", block.kind().contacts);
    const auto quantities = block.quantities(e);
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      const ReportedQuantity& quantity = quantities[q];
      of_block.law_quantities.push_back({e, list_.size(), q});
      list_.add(quantity.name, info.name, info.listed_under(), quantity.unit, block.kind().contacts);
    }
  }
  if (!of_block.deformations.empty() || !of_block.indentations.empty() || !of_block.forces.empty())
    blocks_.push_back(std::move(of_block));
}

void Channels::add_node(const Model& model, NodeId id) {
  const PlacedDiaphragm* diaphragm = model.diaphragm_of(id);
  const std::string name{diaphragm != nullptr ? std::string_view{diaphragm->name} : model.node_name(id)};
  const auto add = [&](const std::string& quantity, const char* unit) { list_.add(quantity, name, name, unit); };
  if (diaphragm != nullptr && id == diaphragm->id.r) {
    rotations_.push_back({list_.size(), 1.0 / diaphragm->gyration});
    add("rotation", "rad");
    add("angular_velocity", "rad/s");
    add("angular_acceleration", "rad/s^2");
    return;
  }
  if (model.body(id).generalised) {
    add("coordinate", "m");
    add("coordinate_velocity", "m/s");
    add("coordinate_acceleration", "m/s^2");
    return;
  }
  const std::string component = diaphragm == nullptr ? "" : id == diaphragm->id.x ? "_x" : "_y";
  add("displacement" + component, "m");
  add("velocity" + component, "m/s");
  add("absolute_acceleration" + component, "m/s^2");
}

std::vector<std::size_t> Channels::bent_by(const Model& model, const RegimeChange& change) const {
  std::vector<std::size_t> bent;
  for (const NodeId node : model.struck_by(model.blocks()[change.block]->info(change.element))) {
    bent.push_back(of_node(model, node) + 2);
    if (const int shear = base_shear_of_node_[static_cast<std::size_t>(model.place(node))]; shear >= 0)
      bent.push_back(static_cast<std::size_t>(shear));
    plan_.add_bent_by(model, node, bent);
  }
  plan_.add_friction(change.block, change.element, bent);
  return bent;
}

void Channels::sample(const StepView& view, std::vector<double>& values, std::vector<double>& rates) const {
  values.resize(list_.size());
  rates.resize(list_.size());
  double *value = values.data(), *rate = rates.data();
  const MotionState& state = view.state.motion();
  const double *displacement = state.displacement.data(), *velocity = state.velocity.data(),
               *acceleration = state.acceleration.data(), *jerk = state.jerk.data();
  const GroundColumns influence = view.model.ground_influence();
  const int count = view.model.degrees_of_freedom();
  for (int i = 0; i < count; ++i) {
    const std::size_t channel = 3 * static_cast<std::size_t>(i);
    value[channel] = displacement[i];
    value[channel + 1] = rate[channel] = velocity[i];
    rate[channel + 1] = acceleration[i];
    value[channel + 2] = acceleration[i] + influence.times(view.ground_acceleration, i);
    rate[channel + 2] = jerk[i];
  }
  for (int place = count; place < view.model.nodes(); ++place) {
    const NodeId node = view.model.node(place);
    const std::size_t channel = of_node(view.model, node);
    value[channel] = view.state.displacement(node);
    value[channel + 1] = rate[channel] = view.state.velocity(node);
    rate[channel + 1] = view.state.acceleration(node);
    value[channel + 2] = rate[channel + 1] + view.model.moved_by_ground(node, view.ground_acceleration);
    rate[channel + 2] = view.state.jerk(node);
  }
  for (const Rotation& rotation : rotations_) {
    for (std::size_t k = rotation.channel; k < rotation.channel + 3; ++k) {
      value[k] *= rotation.per_metre;
      rate[k] *= rotation.per_metre;
    }
  }
  for (const BlockChannels& channels : blocks_) sample(view.state.elements(channels.block), channels, value, rate);
  sample_storeys(view, value, rate);
  if (!weights_.empty()) weights_.sample(view, value, rate);
  const auto masses = view.model.mass_matrix().diagonal();
  for (const BaseShear& shear : base_shears_) {
    value[shear.channel] = rate[shear.channel] = 0.0;
    for (const NodeId node : shear.nodes) {
      const double mass = shear.has_followers ? view.model.mass(node) : masses[node.index];
      value[shear.channel] -= mass * value[of_node(view.model, node) + 2];
      rate[shear.channel] -= mass * rate[of_node(view.model, node) + 2];
    }
  }
  if (!view.model.mass_matrix().is_diagonal() && !std::ranges::all_of(base_shears_, &BaseShear::has_followers))
    for (double* each : {value, rate}) add_coupled_inertia(view.model.mass_matrix(), each);
  if (view.model.is_plan()) plan_.sample(view, value, rate);
}

void Channels::sample_storeys(const StepView& view, double* values, double* rates) const {
  const MotionState& motion = view.state.motion();
  for (const auto& [channel, result] : storey_sums_) {
    double value = 0.0, rate = 0.0;
    for (const MotionShare& share : result->displacements) {
      value += share.weight * motion.displacement[share.node.index];
      rate += share.weight * motion.velocity[share.node.index];
    }
    for (const ForceShare& share : result->forces) {
      const ResultsOf<double> results = view.state.elements(share.element.block).results().line;
      value += share.weight * results.forces[share.element.element];
      rate += share.weight * results.force_rates[share.element.element];
    }
    values[channel] = value;
    rates[channel] = rate;
  }
}

// Masses that couple a node of a building with others add to its inertia.
void Channels::add_coupled_inertia(const MassMatrix& mass, double* values) const {
  const Eigen::Map<const Vector, 0, Eigen::InnerStride<3>> every_third{values + 2, mass.diagonal().size()};
  const Vector accelerations = every_third;
  Vector inertia = accelerations;
  mass.multiply(accelerations.data(), inertia.data());
  inertia -= mass.diagonal().cwiseProduct(accelerations);
  for (const BaseShear& shear : base_shears_)
    for (const NodeId node : shear.nodes)
      if (!shear.has_followers) values[shear.channel] -= inertia[node.index];
}

void Channels::sample(const ElementStates& elements, const BlockChannels& channels, double* values, double* rates) {
  for (const auto& [element, channel, quantity] : channels.law_quantities) {
    const ReportedValue now = elements.law_quantity(element, quantity);
    values[channel] = now.value;
    rates[channel] = now.rate;
  }
  const ElementResults results = elements.results();
  if (!results.plan.forces.empty()) {
    for (const auto& [element, channel] : channels.forces) {
      values[channel] = results[element].force;
      rates[channel] = results[element].force_rate;
    }
    for (const auto& [element, channel] : channels.deformations) {
      values[channel] = results[element].deformation;
      rates[channel] = results[element].rate;
    }
    return;
  }
  const double *forces = results.line.forces.data(), *force_rates = results.line.force_rates.data();
  for (const auto& [element, channel] : channels.forces) {
    values[channel] = forces[element];
    rates[channel] = force_rates[element];
  }
  const double *deformations = results.line.deformations.data(), *deformation_rates = results.line.rates.data();
  for (const auto& [element, channel] : channels.deformations) {
    values[channel] = deformations[element];
    rates[channel] = deformation_rates[element];
  }
  // An open gap is not indented.
  for (const auto& [element, channel] : channels.indentations) {
    const bool closed = deformations[element] >= 0.0;
    values[channel] = closed ? deformations[element] : 0.0;
    rates[channel] = closed ? deformation_rates[element] : 0.0;
  }
}

double Channels::value_inside(const StepView& view, std::size_t channel, double fraction, double of_cubic) const {
  const auto found = std::ranges::lower_bound(of_laws_, channel, {}, &LawChannel::channel);
  if (found == of_laws_.end() || found->channel != channel) return of_cubic;
  return view.state.elements(found->block).force_inside(found->element, fraction);
}

}  // namespace moat
