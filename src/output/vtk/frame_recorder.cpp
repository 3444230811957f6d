#include "output/vtk/frame_recorder.hpp"

#include <utility>

#include "base/check.hpp"
#include "output/vtk/model_scene.hpp"

namespace moat {
namespace {

// Returns the force of a contact on its left node, or on its corner.
PlanVector force_on_first_point(const ElementBlock& block, std::size_t element) {
  const double normal_force = block.results().forces[element];
  const PlanContacts* corners = block.plan_contacts();
  if (corners == nullptr) return {-normal_force, 0.0};
  const PlanVector normal = corners->pair(element).normal;
  return -normal_force * normal - corners->friction_force(element) * turned_left(normal);
}

}  // namespace

FrameRecorder::FrameRecorder(const Model& model, const std::filesystem::path& folder, double interval)
    : FrameRecorder{model, folder, interval, scene_of(model)} {}

FrameRecorder::FrameRecorder(const Model& model, const std::filesystem::path& folder, double interval, Scene scene)
    : storey_shears_{model, scene.storeys},
      // Checked before the writer makes files.
      writer_{(Check{"FrameRecorder", ""}.positive("interval", interval, "s"), folder), std::move(scene)},
      interval_{interval} {}

void FrameRecorder::start(const StepView& view) { write(view); }

void FrameRecorder::step(const StepView& view) {
  if (view.on_grid && view.model.state().time >= next_ * (1.0 - 1e-12)) write(view);
}

void FrameRecorder::write(const StepView& view) {
  const Model& model = view.model;
  const auto nodes = static_cast<std::size_t>(model.node_count());
  displacement_.resize(nodes);
  velocity_.resize(nodes);
  acceleration_.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const NodeId node{static_cast<int>(i)};
    displacement_[i] = model.displacement(node);
    velocity_[i] = model.velocity(node);
    acceleration_[i] = view.absolute_acceleration(node);
  }
  deformation_.clear();
  force_.clear();
  in_contact_.clear();
  contact_force_.clear();
  for (const auto& block : model.blocks()) {
    const Contacts* contacts = block->contacts();
    const ElementResults results = block->results();
    for (std::size_t e = 0; e < block->size(); ++e) {
      deformation_.push_back(contacts != nullptr ? -results.deformations[e] : results.deformations[e]);
      force_.push_back(results.forces[e]);
      contact_force_.push_back(contacts != nullptr ? force_on_first_point(*block, e) : PlanVector{});
      in_contact_.push_back(contacts != nullptr && contacts->contact(e).touching ? 1.0 : 0.0);
    }
  }
  writer_.write(model.state().time, {.node_displacement = displacement_,
                                     .node_velocity = velocity_,
                                     .node_absolute_acceleration = acceleration_,
                                     .deformation = deformation_,
                                     .force = force_,
                                     .in_contact = in_contact_,
                                     .ground_acceleration = view.ground_acceleration,
                                     .ground_acceleration_y = view.ground_acceleration_y,
                                     .contact_force = contact_force_,
                                     .storey_shear = storey_shears_.evaluate(model)});
  while (next_ <= model.state().time * (1.0 + 1e-12)) next_ += interval_;
}

}  // namespace moat
