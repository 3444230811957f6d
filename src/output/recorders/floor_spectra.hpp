// Response spectra of floors, marched with the steps of an analysis.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/quantity.hpp"
#include "output/files/case_result.hpp"
#include "output/recorders/step_observer.hpp"

namespace moat {

/// Where floor spectra are taken, and for which oscillators.
struct FloorSpectraOptions {
  /// Names of diaphragms or nodes. Empty: base and top of each of the first three buildings.
  std::vector<std::string> floors{};
  /// Each >= 0 and < 1, share of critical damping.
  std::vector<double> dampings{0.05};
  /// Ascending, each from 1 ms to 1000 s. Empty: 100 from 0.02 s to 10 s in equal ratios, rounded to three digits.
  std::vector<Time> periods{};
  /// Whether the corners of floors in plan have spectra too, besides the centre of mass.
  bool corners = false;
  /// Whether the largest absolute accelerations of the oscillators are kept too; they cost as much again.
  bool absolute_acceleration = false;
};

/// Response spectra of the absolute acceleration of floors: the demand on light equipment that stands there. In plan
/// that of the centre of mass, and of corners where wanted, along x and y.
///
///     FloorSpectra spectra{{.floors = {"floor 3", "floor 5"}, .dampings = {0.02, 0.05}}};
///     return script.run(model, motion, {&spectra});
///
/// A run without one has that of FloorSpectraOptions{}. It writes floor_spectra.csv, and the report draws the centres.
///
/// Oscillators move on by the accepted steps as they are, with the values on both sides of every event, so that no
/// jump of an impact is smeared. The acceleration is straight between the ends of a step, and zero after the last one,
/// where one period of free vibration counts. Oscillators follow it exactly (OscillatorMotion), peaks lie at most T/32
/// apart.
class FloorSpectra final : public StepObserver {
 public:
  /// Throws InputError for an option outside its range.
  explicit FloorSpectra(FloorSpectraOptions options = {});
  ~FloorSpectra() override;

  /// Throws InputError for a floor that the model has not, one that is no place but a generalised coordinate, one named
  /// twice, and where corners are wanted but no floor has an outline.
  void start(const StepView& view) override;
  void step(const StepView& view) override;
  void event(const StepView& view, std::span<const RegimeChange>) override;
  void archive(StateArchive& archive) override;

  /// Up to now, with the free vibration if the floors stopped here: for every floor and place along every direction one
  /// for each damping. Empty before the start.
  [[nodiscard]] std::vector<FloorSpectrum> spectra() const;

 private:
  struct Oscillators;
  FloorSpectraOptions options_;
  std::unique_ptr<Oscillators> oscillators_;
};

}  // namespace moat
