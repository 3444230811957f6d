#include "output/frame_image.hpp"

#include <array>
#include <limits>

namespace moat {
namespace {

constexpr std::array kind_names{"floor", "storey", "bearing", "gap", "wall", "other"};
constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
// Cell types of VTK.
constexpr std::uint8_t vtk_line = 3, vtk_polygon = 7, vtk_quad = 9;

}  // namespace

FrameImage::FrameImage(const Scene& scene) : scene_{scene} {
  draw();
  declare();
  pieces_ = file_.finish();
}

void FrameImage::draw() {
  for (const ScenePoint& point : scene_.points) corners_.insert(corners_.end(), {point.x, point.y, point.z});
  for (const SceneCell& cell : scene_.cells) {
    connectivity_.insert(connectivity_.end(), cell.points.begin(), cell.points.end());
    offsets_.push_back(static_cast<std::int64_t>(connectivity_.size()));
    types_.push_back(cell.points.size() == 2 ? vtk_line : cell.points.size() == 4 ? vtk_quad : vtk_polygon);
    kinds_.push_back(static_cast<std::int32_t>(cell.kind));
    // A text ends at its first zero byte.
    names_.append(cell.name.c_str()).push_back('\0');
  }
  for (const char* name : kind_names) kind_names_.append(name).push_back('\0');
  for (auto* vectors : {&displacement_, &velocity_, &acceleration_, &contact_force_}) vectors->resize(corners_.size());
  for (auto* values : {&deformation_, &force_, &opening_, &impact_force_, &isolator_force_, &drift_, &storey_shear_})
    values->resize(kinds_.size(), no_value);
  in_contact_.resize(kinds_.size());
  time_.resize(1);
}

void FrameImage::declare() {
  const auto numbers = [&](std::string_view name, const std::vector<double>& values, int components = 1) {
    file_.array({name, components}, std::span{values});
  };
  file_.xml("<UnstructuredGrid>\n<FieldData>\n");
  numbers("TimeValue", time_);
  file_.texts({"KindNames"}, kind_names_);
  file_.xml("</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(scene_.points.size()) + "\" NumberOfCells=\"" +
            std::to_string(scene_.cells.size()) + "\">\n<PointData>\n");
  numbers("Displacement", displacement_, 3);
  numbers("Velocity", velocity_, 3);
  numbers("AbsoluteAcceleration", acceleration_, 3);
  numbers("ContactForce", contact_force_, 3);
  file_.xml("</PointData>\n<CellData>\n");
  file_.array({"Kind"}, std::span<const std::int32_t>{kinds_});
  file_.texts({"Name"}, names_);
  numbers("Deformation", deformation_);
  numbers("Force", force_);
  numbers("Drift", drift_);
  numbers("StoreyShear", storey_shear_);
  numbers("IsolatorForce", isolator_force_);
  numbers("Opening", opening_);
  numbers("ImpactForce", impact_force_);
  file_.array({"InContact"}, std::span<const std::int32_t>{in_contact_});
  file_.xml("</CellData>\n<Points>\n");
  numbers("Points", corners_, 3);
  file_.xml("</Points>\n<Cells>\n");
  file_.array({"connectivity"}, std::span<const std::int64_t>{connectivity_});
  file_.array({"offsets"}, std::span<const std::int64_t>{offsets_});
  file_.array({"types"}, std::span<const std::uint8_t>{types_});
  file_.xml("</Cells>\n</Piece>\n</UnstructuredGrid>\n");
}

// A storey has its first point below and its last point above.
double FrameImage::drift(const SceneCell& cell) const {
  const auto first = static_cast<std::size_t>(cell.points.front()), last = static_cast<std::size_t>(cell.points.back());
  const PlanVector difference{displacement_[3 * last] - displacement_[3 * first],
                              displacement_[3 * last + 1] - displacement_[3 * first + 1]};
  return scene_.points[last].on_diaphragm ? length(difference) : difference.x;
}

void FrameImage::fill(double time, const FrameData& data) {
  const auto write_at = [](std::vector<double>& vectors, std::size_t point, PlanVector value) {
    vectors[3 * point] = value.x;
    vectors[3 * point + 1] = value.y;
  };
  for (std::size_t i = 0; i < scene_.points.size(); ++i) {
    const ScenePoint& point = scene_.points[i];
    const bool fixed = point.node < 0;
    const auto node = static_cast<std::size_t>(fixed ? 0 : point.node);
    const double w = fixed ? 0.0 : point.weight;
    const PlanVector of_ground{data.ground_acceleration, data.ground_acceleration_y};
    const auto moved = [&](std::span<const double> values) {
      return point.on_diaphragm ? PlanVector{values[node], values[node + 1]} + values[node + 2] * turned_left(point.arm)
                                : values[node] * point.direction;
    };
    write_at(displacement_, i, fixed ? PlanVector{} : w * moved(data.node_displacement));
    write_at(velocity_, i, fixed ? PlanVector{} : w * moved(data.node_velocity));
    write_at(acceleration_, i, fixed ? of_ground : w * moved(data.node_absolute_acceleration) + (1.0 - w) * of_ground);
  }
  for (std::size_t i = 0; i < scene_.cells.size(); ++i) {
    const SceneCell& cell = scene_.cells[i];
    if (cell.storey >= 0) {
      drift_[i] = drift(cell);
      storey_shear_[i] = data.storey_shear[static_cast<std::size_t>(cell.storey)];
    }
    if (cell.element < 0) continue;
    const auto element = static_cast<std::size_t>(cell.element);
    deformation_[i] = data.deformation[element];
    force_[i] = data.force[element];
    if (cell.kind == CellKind::gap) {
      opening_[i] = data.deformation[element];
      const PlanVector force = data.contact_force.empty() ? PlanVector{} : data.contact_force[element];
      write_at(contact_force_, static_cast<std::size_t>(cell.points[0]), force);
      write_at(contact_force_, static_cast<std::size_t>(cell.points[1]), -force);
      impact_force_[i] = data.force[element];
    } else if (cell.kind == CellKind::bearing) {
      isolator_force_[i] = data.force[element];
    }
    in_contact_[i] = data.in_contact[element] != 0.0 ? 1 : 0;
  }
  time_[0] = time;
}

}  // namespace moat
