// The design sheet of EN 1998-1, chapter 10.
#pragma once

#include "design/design_sheet.hpp"
#include "design/sheet_inputs.hpp"
#include "motions/spectra/code_spectra.hpp"

namespace moat {

/// Isolated buildings by EN 1998-1:2004, chapter 10, and the rules of re-centring of EN 15129. It converts to its
/// sheet:
///
///     const DesignSheet sheet = En1998Sheet{.building = hospital,
///                                           .spectrum = {.ground_acceleration = 0.3 * g, .ground = 'C'}};
///
/// d_dc is the displacement at which the spectrum, with the damping and the secant stiffness of the loop at d_dc, asks
/// for d_dc again; it is solved to the last digits. Clauses are recalled, not read in the code, and marked so on the
/// sheet.
struct En1998Sheet {
  Required<SheetBuilding> building;  ///< The isolated building.
  /// S_e. Its damping ratio is not used: that of the isolators is.
  Required<En1998Spectrum> spectrum;
  /// gamma_x of the displacements of isolators, 1 to 2.
  double magnification = 1.2;
  /// By creep, shrinkage and half of the change of temperature, >= 0 m.
  Length slow_displacement{};

  /// Throws InputError for a bad parameter, where d_dc has no solution, and where the spectrum ends before T_eff.
  operator DesignSheet() const;
};

}  // namespace moat
