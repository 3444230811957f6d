#include "output/vtk/frame_recorder.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "output_testing.hpp"
#include "recorders_testing.hpp"

namespace moat {
namespace {

using testing_output::HandMovedBuilding;

class FrameRecorderTest : public testing_output::InFolder {};

TEST_F(FrameRecorderTest, WritesAFrameAtTheStartAndThenAtItsInterval) {
  HandMovedBuilding building;
  {
    FrameRecorder recorder{building.model, folder, 0.1};
    recorder.start(building.move(0.0, 0.0, 0.0));
    for (int i = 1; i <= 10; ++i) recorder.step(building.move(0.04 * i, 0.0, 0.0));
    recorder.finish({building.model, *building.state});
  }
  const std::string pvd = testing_output::read_file(folder / "frames.pvd");
  // 0, then the first steps at or after 0.1, 0.2, 0.3 and 0.4 s.
  for (const char* time :
       {"timestep=\"0\"", "timestep=\"0.12\"", "timestep=\"0.2\"", "timestep=\"0.32\"", "timestep=\"0.4\""})
    EXPECT_NE(pvd.find(time), std::string::npos) << time << "\n" << pvd;
  long frames = 0;
  for (const auto& entry : std::filesystem::directory_iterator{folder / "frames"}) {
    EXPECT_EQ(entry.path().extension(), ".vtu");
    ++frames;
  }
  EXPECT_EQ(frames, 5);
}

TEST_F(FrameRecorderTest, RefusesAnIntervalBeforeItWritesAnything) {
  const HandMovedBuilding building;
  EXPECT_EQ(testing_output::message_of<InputError>([&] { FrameRecorder(building.model, folder / "new", -1.0); }),
            "FrameRecorder: interval = -1 s is not allowed; it must be > 0 s and finite.");
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
}

}  // namespace
}  // namespace moat
