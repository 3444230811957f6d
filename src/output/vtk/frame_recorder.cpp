#include "output/vtk/frame_recorder.hpp"

#include <utility>

#include "base/check.hpp"
#include "output/vtk/model_scene.hpp"

namespace moat {
namespace {

// Returns the force of a contact on its left node, or on its corner.
PlanVector force_on_first_point(const ElementInfo& info, double normal_force, const ContactView& contact) {
  if (info.corner_pair() == nullptr) return {-normal_force, 0.0};
  const PlanVector normal = info.corner_pair()->normal;
  return -normal_force * normal - contact.friction_force * turned_left(normal);
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
  if (view.on_grid && view.state.time() >= next_ * (1.0 - 1e-12)) write(view);
}

void FrameRecorder::write(const StepView& view) {
  const Model& model = view.model;
  const auto nodes = static_cast<std::size_t>(model.degrees_of_freedom());
  displacement_.resize(nodes);
  velocity_.resize(nodes);
  acceleration_.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const NodeId node{static_cast<int>(i)};
    displacement_[i] = view.state.displacement(node);
    velocity_[i] = view.state.velocity(node);
    acceleration_[i] = view.absolute_acceleration(node);
  }
  deformation_.clear();
  force_.clear();
  in_contact_.clear();
  contact_force_.clear();
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    const bool contacts = block.kind().contacts;
    const ElementResults results = view.state.elements(b).results();
    for (std::size_t e = 0; e < block.size(); ++e) {
      const ContactView contact = view.state.elements(b).contact(e);
      deformation_.push_back(contacts ? -results[e].deformation : results[e].deformation);
      force_.push_back(results[e].force);
      contact_force_.push_back(contacts ? force_on_first_point(block.info(e), results[e].force, contact)
                                        : PlanVector{});
      in_contact_.push_back(contact.touching ? 1.0 : 0.0);
    }
  }
  writer_.write(view.state.time(), {.node_displacement = displacement_,
                                    .node_velocity = velocity_,
                                    .node_absolute_acceleration = acceleration_,
                                    .deformation = deformation_,
                                    .force = force_,
                                    .in_contact = in_contact_,
                                    .ground_acceleration = view.ground_acceleration.x,
                                    .ground_acceleration_y = view.ground_acceleration.y,
                                    .contact_force = contact_force_,
                                    .storey_shear = storey_shears_.evaluate(view.state)});
  while (next_ <= view.state.time() * (1.0 + 1e-12)) next_ += interval_;
}

}  // namespace moat
