#include "output/vtk/frame_fields.hpp"

#include <limits>

namespace moat {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

void set(std::vector<double>& vectors, std::size_t point, PlanVector value) {
  vectors[3 * point] = value.x;
  vectors[3 * point + 1] = value.y;
}

// A storey has its first point below and its last point above.
double drift(const Scene& scene, const SceneCell& cell, const std::vector<double>& displacement) {
  const auto first = static_cast<std::size_t>(cell.points.front()), last = static_cast<std::size_t>(cell.points.back());
  const PlanVector difference{displacement[3 * last] - displacement[3 * first],
                              displacement[3 * last + 1] - displacement[3 * first + 1]};
  return scene.points[last].on_diaphragm ? length(difference) : difference.x;
}

struct ElementFrame {
  double deformation, force;  // of a gap its opening, negative while indented
  bool in_contact;
  PlanVector on_first_point;  // force of a contact on the body of the first point of its cell, friction included
};

// Elements are numbered through all blocks.
std::vector<ElementFrame> elements_of(const StepView& view) {
  std::vector<ElementFrame> frames;
  for (std::size_t b = 0; b < view.model.blocks().size(); ++b) {
    const ElementBlock& block = *view.model.blocks()[b];
    const ElementStates& states = view.state.elements(b);
    const ElementResults results = states.results();
    for (std::size_t e = 0; e < block.size(); ++e) {
      const double force = results[e].force, deformation = results[e].deformation;
      if (!block.kind().contacts) {
        frames.push_back({deformation, force, false, {}});
        continue;
      }
      const ContactView contact = states.contact(e);
      const CornerPair* corner = block.info(e).corner_pair();
      const PlanVector normal = corner != nullptr ? corner->normal : PlanVector{1.0, 0.0};
      frames.push_back(
          {-deformation, force, contact.touching, -force * normal - contact.friction_force * turned_left(normal)});
    }
  }
  return frames;
}

}  // namespace

FrameFields fields_of(const Scene& scene, const StepView& view, std::span<const double> storey_shears) {
  const std::vector<double> no_vectors(3 * scene.points.size());
  std::vector<double> displacement = no_vectors, velocity = no_vectors, acceleration = no_vectors,
                      contact_force = no_vectors;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const ScenePoint& point = scene.points[i];
    if (point.node < 0) {
      set(acceleration, i, view.ground_acceleration.horizontal());
      continue;
    }
    const auto moved = [&](const auto& of_node) {
      const auto of = [&](int offset) { return of_node(view.model.node(point.node + offset)); };
      return point.on_diaphragm ? PlanVector{of(0), of(1)} + of(2) * turned_left(point.arm) : of(0) * point.direction;
    };
    set(displacement, i, moved([&](NodeId node) { return view.state.displacement(node); }));
    set(velocity, i, moved([&](NodeId node) { return view.state.velocity(node); }));
    set(acceleration, i, moved([&](NodeId node) { return view.absolute_acceleration(node); }));
  }

  const std::vector<ElementFrame> elements = elements_of(view);
  const std::vector<double> no_values(scene.cells.size(), no_value);
  std::vector<double> deformation = no_values, force = no_values, cell_drift = no_values, storey_shear = no_values,
                      isolator_force = no_values, opening = no_values, impact_force = no_values,
                      in_contact(scene.cells.size());
  for (std::size_t i = 0; i < scene.cells.size(); ++i) {
    const SceneCell& cell = scene.cells[i];
    if (cell.storey >= 0) {
      cell_drift[i] = drift(scene, cell, displacement);
      storey_shear[i] = storey_shears[static_cast<std::size_t>(cell.storey)];
    }
    if (cell.element < 0) continue;
    const ElementFrame& element = elements[static_cast<std::size_t>(cell.element)];
    deformation[i] = element.deformation;
    force[i] = element.force;
    in_contact[i] = element.in_contact ? 1.0 : 0.0;
    if (cell.kind == CellKind::bearing) isolator_force[i] = force[i];
    if (cell.kind != CellKind::gap) continue;
    opening[i] = deformation[i];
    impact_force[i] = force[i];
    set(contact_force, static_cast<std::size_t>(cell.points[0]), element.on_first_point);
    set(contact_force, static_cast<std::size_t>(cell.points[1]), -element.on_first_point);
  }
  return {.time = view.state.time(),
          .of_points = {{"Displacement", std::move(displacement)},
                        {"Velocity", std::move(velocity)},
                        {"AbsoluteAcceleration", std::move(acceleration)},
                        {"ContactForce", std::move(contact_force)}},
          .of_cells = {{"Deformation", std::move(deformation)},
                       {"Force", std::move(force)},
                       {"Drift", std::move(cell_drift)},
                       {"StoreyShear", std::move(storey_shear)},
                       {"IsolatorForce", std::move(isolator_force)},
                       {"Opening", std::move(opening)},
                       {"ImpactForce", std::move(impact_force)},
                       {"InContact", std::move(in_contact)}}};
}

}  // namespace moat
