// Text files that a test writes for the readers of ground motions, and the messages it gets back.
#pragma once

#include "message_of.hpp"
#include "written_files.hpp"

namespace moat {

using MotionFiles = testing::WrittenFiles;
using testing::message_of;

}  // namespace moat
