#include "output/recorders/weight_channels.hpp"

namespace moat {

WeightChannels::WeightChannels(const Model& model, ChannelList& list) : first_{list.size()} {
  for (const Building& building : model.buildings()) {
    if (!building.axial_forces || building.shares_base) continue;
    const std::vector<ElementId> isolators = isolators_of(model, std::span{&building, 1}).front();
    for (const ElementId id : isolators) {
      const ElementInfo& info = model.blocks()[id.block]->info(id.element);
      list.add("bearing_compression", info.name, info.listed_under(), "N");
    }
    const std::string where = building.base_name();
    list.add("vertical_acceleration", where, where, "m/s^2");
    list.add("vertical_load", where, where, "N");
    if (!model.is_plan()) {
      list.add("overturning_moment", where, where, "N m");
      continue;
    }
    list.add("overturning_moment_x", where, where, "N m");
    list.add("overturning_moment_y", where, where, "N m");
    list.add("torque_of_bearings", where, where, "N m");
  }
  behind_ = list.size();
}

void WeightChannels::sample(const StepView& view, double* values, double* rates) const {
  double *value = values + first_, *rate = rates + first_;
  const auto write = [&](double of_value, double of_rate) {
    *value++ = of_value;
    *rate++ = of_rate;
  };
  for (const WeightOnBearings& weight : view.state.weights()) {
    PlanVector torque{};  // and its rate
    const PlacedDiaphragm* base = view.model.diaphragm_of(weight.base());
    for (const WeightOnBearings::Bearing& bearing : weight.bearings()) {
      write(bearing.compression, bearing.rate);
      if (base == nullptr) continue;
      const ResultsOf<PlanVector> results = view.state.elements(bearing.element.block).results().plan;
      const PlanVector arm = bearing.on_slab.at - base->centre_of_mass;
      torque += PlanVector{cross(arm, results.forces[bearing.element.element]),
                           cross(arm, results.force_rates[bearing.element.element])};
    }
    write(weight.vertical_acceleration(), weight.vertical_acceleration_rate());
    write(weight.load(), weight.load_rate());
    const PlanVector moment = weight.overturning_moment(), moment_rate = weight.overturning_moment_rate();
    write(moment.x, moment_rate.x);
    if (base == nullptr) continue;
    write(moment.y, moment_rate.y);
    write(torque.x, torque.y);
  }
}

}  // namespace moat
