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

}  // namespace

FrameFields fields_of(const Scene& scene, double time, const FrameData& data) {
  const std::vector<double> no_vectors(3 * scene.points.size());
  std::vector<double> displacement = no_vectors, velocity = no_vectors, acceleration = no_vectors,
                      contact_force = no_vectors;
  const PlanVector of_ground{data.ground_acceleration, data.ground_acceleration_y};
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const ScenePoint& point = scene.points[i];
    if (point.node < 0) {
      set(acceleration, i, of_ground);
      continue;
    }
    const auto node = static_cast<std::size_t>(point.node);
    const double w = point.weight;
    const auto moved = [&](std::span<const double> values) {
      return point.on_diaphragm ? PlanVector{values[node], values[node + 1]} + values[node + 2] * turned_left(point.arm)
                                : values[node] * point.direction;
    };
    set(displacement, i, w * moved(data.node_displacement));
    set(velocity, i, w * moved(data.node_velocity));
    set(acceleration, i, w * moved(data.node_absolute_acceleration) + (1.0 - w) * of_ground);
  }

  const std::vector<double> no_values(scene.cells.size(), no_value);
  std::vector<double> deformation = no_values, force = no_values, cell_drift = no_values, storey_shear = no_values,
                      isolator_force = no_values, opening = no_values, impact_force = no_values,
                      in_contact(scene.cells.size());
  for (std::size_t i = 0; i < scene.cells.size(); ++i) {
    const SceneCell& cell = scene.cells[i];
    if (cell.storey >= 0) {
      cell_drift[i] = drift(scene, cell, displacement);
      storey_shear[i] = data.storey_shear[static_cast<std::size_t>(cell.storey)];
    }
    if (cell.element < 0) continue;
    const auto element = static_cast<std::size_t>(cell.element);
    deformation[i] = data.deformation[element];
    force[i] = data.force[element];
    in_contact[i] = data.in_contact[element] != 0.0 ? 1.0 : 0.0;
    if (cell.kind == CellKind::bearing) isolator_force[i] = force[i];
    if (cell.kind != CellKind::gap) continue;
    opening[i] = deformation[i];
    impact_force[i] = force[i];
    const PlanVector on_first = data.contact_force.empty() ? PlanVector{} : data.contact_force[element];
    set(contact_force, static_cast<std::size_t>(cell.points[0]), on_first);
    set(contact_force, static_cast<std::size_t>(cell.points[1]), -on_first);
  }
  return {.time = time,
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
