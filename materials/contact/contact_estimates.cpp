#include "materials/contact/contact_estimates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.hpp"

namespace moat {
namespace {

constexpr double quarter_of_geometry = 0.25, tenth_of_geometry = 0.1;

void check_concrete(const Check& check, const Concrete& concrete) {
  check.positive("youngs_modulus", concrete.youngs_modulus);
  check.that(concrete.poissons_ratio >= 0.0 && concrete.poissons_ratio < 0.5, "poissons_ratio", concrete.poissons_ratio,
             "1", ">= 0 and < 0.5", "Concrete has about 0.2.");
  check.positive("density", concrete.density);
}

void check_slab(const Check& check, const SlabAlongHit& slab) {
  check.positive("length", slab.length);
  check.positive("width", slab.width);
  check.positive("thickness", slab.thickness);
  check.that(slab.contact_width == Length{} || (slab.contact_width > Length{} && slab.contact_width <= slab.width),
             "contact_width", slab.contact_width.si(), "m", "> 0 m and <= width = " + to_text(slab.width.si()) + " m",
             "Leave it out for the whole edge.");
  check_concrete(check, slab.material);
}

double flexibility(const Concrete& concrete) {
  return (1.0 - concrete.poissons_ratio * concrete.poissons_ratio) / concrete.youngs_modulus.si();
}

// The modulus E* of two bodies in contact, Pa.
double contact_modulus(const Concrete& first, const Concrete& second) {
  return 1.0 / (flexibility(first) + flexibility(second));
}

// The radius of a sphere of this mass, m.
double radius_of_sphere(Mass mass, const Concrete& concrete) {
  return std::cbrt(3.0 * mass.si() / (4.0 * std::numbers::pi * concrete.density.si()));
}

}  // namespace

Estimate<Stiffness> axial_stiffness_of_slab(const SlabAlongHit& slab) {
  check_slab(Check{"axial_stiffness_of_slab", ""}, slab);
  const double b = slab.width.si(), e = slab.material.youngs_modulus.si(), t = slab.thickness.si();
  const double contact = slab.contact_width.si() > 0.0 ? slab.contact_width.si() : b;
  Check{"axial_stiffness_of_slab", ""}.that(b - contact <= 2.0 * slab.length.si(), "contact_width", contact, "m",
                                            ">= width - 2 length = " + to_text(b - 2.0 * slab.length.si()) + " m",
                                            "The load spreads at 45 degrees, and reaches this width alone: give a "
                                            "smaller width.");
  const double spreading = std::log(b / contact) / (2.0 * e * t), along = slab.length.si() / (e * b * t);
  const auto stiffness = [&](double parts) { return Stiffness{1.0 / (spreading + along / parts)}; };
  const double parts = slab.mass == SlabMass::spread ? 3.0 : slab.mass == SlabMass::in_middle ? 2.0 : 1.0;
  return {.value = stiffness(parts),
          .low = stiffness(1.0),
          .high = stiffness(3.0),
          .source = "bar theory: from the face that is hit to the centre of mass",
          .assumption =
              "The contact lasts at least three times wave_return_time(), and the hit is wider than the slab "
              "is thick."};
}

Time wave_return_time(const SlabAlongHit& slab) {
  check_slab(Check{"wave_return_time", ""}, slab);
  return 2.0 * slab.length.value() / Speed{std::sqrt(slab.material.youngs_modulus.si() / slab.material.density.si())};
}

Estimate<HertzStiffness> contact_stiffness_of_slab_edge(const SlabEdge& edge) {
  const Check check{"contact_stiffness_of_slab_edge", ""};
  check.positive("mass", edge.mass);
  check.not_negative("wall_mass", edge.wall_mass, "Leave it out for a plane wall.");
  check_concrete(check, edge.material);
  check_concrete(check, edge.wall_material);
  double curvature = 1.0 / radius_of_sphere(edge.mass, edge.material);
  if (edge.wall_mass.si() > 0.0) curvature += 1.0 / radius_of_sphere(edge.wall_mass, edge.wall_material);
  const HertzStiffness geometry{4.0 / 3.0 * contact_modulus(edge.material, edge.wall_material) / std::sqrt(curvature)};
  return {.value = quarter_of_geometry * geometry,
          .low = tenth_of_geometry * geometry,
          .high = geometry,
          .source =
              "Hertz, with spheres of the masses of the bodies; a quarter of it after the concrete pendulum of van "
              "Mier et al. (1991) as Jankowski (2005) fitted it, recalled: a quarter to a sixth of the geometry",
          .assumption = "No floor edge is a sphere and faces are uneven: the geometry is an upper bound."};
}

Estimate<Stiffness> contact_stiffness_of_vertical_edge(const VerticalEdge& edge) {
  const Check check{"contact_stiffness_of_vertical_edge", ""};
  check.positive("thickness", edge.thickness);
  check_concrete(check, edge.material);
  const Stiffness line{0.25 * std::numbers::pi * contact_modulus(edge.material, edge.material) * edge.thickness.si()};
  return {.value = line,
          .low = tenth_of_geometry * line,
          .high = line,
          .source = "line contact of a rounded edge, k = (pi/4) E* t, recalled from Popov's book on contact mechanics",
          .assumption =
              "The edge touches along its whole height; it is softer where it does not. A sharp corner "
              "crushes first."};
}

Estimate<Stiffness> stiffness_of_column_hit(const ColumnHit& column) {
  const Check check{"stiffness_of_column_hit", ""};
  check.positive("height", column.height);
  check.positive("depth", column.depth);
  check.positive("width", column.width);
  check.that(column.share > 0.0 && column.share < 1.0, "share", column.share, "1", "> 0 and < 1",
             "A hit at a floor is a Gap between nodes.");
  check.above_up_to("cracked_share", column.cracked_share, 0.0, 1.0, "1", "0.3 to 0.5 where concrete has cracked.");
  check.that(column.count >= 1, "count", column.count, "1", ">= 1");
  check_concrete(check, column.material);
  const double h = column.height.si(), d = column.depth.si(), a = column.share * h, b = h - a;
  const double whole = 3.0 * column.count * column.material.youngs_modulus.si() * column.width.si() * d * d * d / 12.0;
  const Stiffness clamped{whole * std::pow(h / (a * b), 3.0)}, pinned{whole * h / (a * a * b * b)};
  return {.value = column.cracked_share * (column.clamped ? clamped : pinned),
          .low = column.cracked_share * pinned,
          .high = clamped,
          .source = "beam theory",
          .assumption = "The columns stay elastic. Compare the force with their shear strength."};
}

Length effective_wall_width(const HitOnWall& hit) {
  const Check check{"effective_wall_width", ""};
  check.positive("height", hit.height);
  check.positive("width", hit.width);
  check.that(hit.contact_width.value() > Length{} && hit.contact_width.value() <= hit.width.value(), "contact_width",
             hit.contact_width.si(), "m", "> 0 m and <= width = " + to_text(hit.width.si()) + " m");
  return std::min(hit.width.value(), hit.contact_width.value() + 2.2 * hit.height.value());
}

}  // namespace moat
