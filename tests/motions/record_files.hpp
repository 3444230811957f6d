// Files of records that a test writes, and the records that read_record() makes of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "motions/readers/record.hpp"
#include "motions/readers/record_folder.hpp"
#include "written_files.hpp"

namespace moat {

class Records : public testing::WrittenFiles {
 protected:
  /// A file of PEER with values in g.
  void put(const std::string& name, const std::string& component, const std::string& values = "0.0 0.1 -0.1",
           const std::string& step = ".01", const std::string& station = "Kobe Japan, 1/16/1995, KJMA") const {
    (void)write(name, "PEER NGA STRONG MOTION DATABASE RECORD\n" + station + ", " + component +
                          "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= " +
                          std::to_string(std::count(values.begin(), values.end(), ' ') + 1) + ", DT= " + step +
                          " SEC\n" + values + "\n");
  }
  [[nodiscard]] Record read(const RecordOptions& options = {}) const { return read_record({folder}, options); }
  [[nodiscard]] std::string refusal(const RecordOptions& options = {}) const {
    return testing::message_of<FileError>([&] { (void)read_records(folder, options); });
  }
  void expect_refused(const std::string& words, const RecordOptions& options = {}) const {
    const std::string message = refusal(options);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }
  [[nodiscard]] bool notes_have(const std::string& words) const {
    return std::ranges::any_of(record_folder_notes(), [&](const std::string& note) {
      return note.find(folder.string() + ": " + words) != std::string::npos;
    });
  }
};

/// In g.
inline std::vector<double> values_of(const GroundMotion& motion) {
  std::vector<double> values(motion.samples().begin(), motion.samples().end());
  for (double& value : values) value /= standard_gravity;
  return values;
}

// As K-NET has them: starts 14:00:00 and 14:00:00.02.
inline std::string knet(const std::string& component, const std::string& start, const std::string& counts,
                        int frequency = 100) {
  const auto count = std::count(counts.begin(), counts.end(), ' ') + 1;
  return "Origin Time       2018/01/24 19:51:00\nLat.\nLong.\nDepth. (km)\nMag.\nStation Code      XYZ001\nStation "
         "Lat.\nStation Long.\n"
         "Station Height(m)\nRecord Time       2018/01/24 " +
         start + "\nSampling Freq(Hz) " + std::to_string(frequency) + "Hz\nDuration Time(s)  " +
         std::to_string(static_cast<double>(count) / frequency) + "\nDir.              " + component +
         "\nScale Factor      980.665(gal)/1\nMax. Acc. (gal)\nLast Correction\nMemo.\n" + counts + "\n";
}

}  // namespace moat
