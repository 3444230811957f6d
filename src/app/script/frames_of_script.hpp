// The frames of a script's run.
#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "base/text/terminal.hpp"
#include "output/recorders/step_observer.hpp"
#include "output/vtk/frame_recorder.hpp"

namespace moat {

/// Where frames cannot be written the analysis goes on without them.
class FramesOfScript final : public StepObserver {
 public:
  /// Takes the parameters of FrameRecorder.
  FramesOfScript(const Model& model, const std::filesystem::path& folder, double interval) {
    attempt([&] { frames_.emplace(model, folder, interval); });
  }

  void start(const StepView& view) override {
    attempt([&] { frames_->start(view); });
  }
  void step(const StepView& view) override {
    attempt([&] { frames_->step(view); });
  }
  /// The frames are one text, which is read whole also where they have failed.
  void archive(StateArchive& archive) override {
    StateArchive written;
    if (!archive.reads()) attempt([&] { frames_->archive(written); });
    std::string failure = failure_, bytes = written.take();
    archive(failure, bytes);
    if (failure_.empty()) failure_ = failure;
    StateArchive saved{std::move(bytes)};
    if (archive.reads()) attempt([&] { frames_->archive(saved); });
  }
  /// Why frames are missing; empty where none are.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  template <class Action>
  void attempt(const Action& action) {
    if (!failure_.empty()) return;
    try {
      action();
    } catch (const std::exception& error) {
      failure_ = reason_of(error);
    }
  }

  std::optional<FrameRecorder> frames_;
  std::string failure_;
};

}  // namespace moat
