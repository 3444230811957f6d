// The design sheet of ASCE 7, chapter 17.
#pragma once

#include <optional>

#include "design/design_sheet.hpp"
#include "design/sheet_inputs.hpp"
#include "motions/spectra/code_spectra.hpp"
#include "motions/spectra/target_spectrum.hpp"

namespace moat {

/// Isolated buildings by ASCE/SEI 7-16 and 7-22, chapter 17: the equivalent lateral force procedure, and the minima
/// that it sets for histories. It converts to its sheet:
///
///     const Asce7Spectrum spectrum{.s_ds = 1.0, .s_d1 = 0.6, .long_period = 8 * s};
///     const DesignSheet sheet = Asce7Sheet{.building = hospital, .spectrum = spectrum, .s_1 = 0.6,
///                                          .response_modification = 5};
///
/// At D_M the spectrum, with the damping and the secant stiffness of the loop at D_M, asks for D_M again; this is
/// solved to the last digits. Nobody of moat has read the code itself: recalled clauses are marked on the sheet.
struct Asce7Sheet {
  Required<SheetBuilding> building;  ///< The isolated building.
  /// S_DS, S_D1 and T_L; S_M1 = 1.5 S_D1.
  Required<Asce7Spectrum> spectrum;
  /// The mapped S_1, a fraction of g, > 0, <= 5.
  Required<double> s_1;
  /// R of the superstructure, 1 to 8.
  Required<double> response_modification;
  double importance = 1.0;  ///< I_e, 1 to 1.5.
  /// S_aM(T) of a multi-period MCE_R spectrum, of 5 % damping; without it S_M1/T.
  std::optional<TargetSpectrum> mce_spectrum{};
  /// Whether the loop has sharp corners, as that of sliders: then 3.5 beta_M instead of 2.5 beta_M.
  bool abrupt_transition = false;
  bool regular = false;  ///< Whether the superstructure is regular, which lowers a minimum of histories.
  /// Base shear by wind, >= 0 N.
  Force wind{};

  /// Throws InputError for a bad parameter, and where D_M has no solution.
  operator DesignSheet() const;
};

}  // namespace moat
