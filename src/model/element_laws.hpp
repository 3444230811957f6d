// Names, parameters and own quantities of the laws of elements.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/parameter.hpp"
#include "base/reported_quantity.hpp"

namespace moat {

/// Name and parameters of a law, for reports.
struct LawAsGiven {
  std::string name;                   ///< as the script calls it
  std::vector<Parameter> parameters;  ///< in SI units

  friend bool operator==(const LawAsGiven&, const LawAsGiven&) = default;
};

/// The side of an ElementBlock whose elements have laws with a name (materials/).
class ElementLaws {
 public:
  /// As a script calls it.
  [[nodiscard]] virtual std::string law_name(std::size_t element) const = 0;
  /// Names, values and units of the parameters of its law.
  [[nodiscard]] virtual std::vector<Parameter> parameters(std::size_t element) const = 0;
  /// Quantities that its law reports besides deformation and force.
  [[nodiscard]] virtual std::span<const ReportedQuantity> law_quantities(std::size_t element) const = 0;
  /// One of them at the committed state, in SI units.
  [[nodiscard]] virtual ReportedValue law_quantity(std::size_t element, std::size_t quantity) const = 0;
  /// Force at a fraction of the last committed step, N: the law itself, on the deformation and rate interpolated there.
  /// Throws std::logic_error for linear laws, whose force is interpolated like the deformation.
  [[nodiscard]] virtual double force_inside(std::size_t element, double fraction) const = 0;

 protected:
  ~ElementLaws() = default;
};

}  // namespace moat
