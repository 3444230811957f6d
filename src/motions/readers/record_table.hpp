// The channels of files of records, and the table that decides about them.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "motions/readers/record.hpp"

namespace moat {

/// A row of the table.
struct RecordRow {
  std::size_t line = 0, channel = 0;                        ///< RecordChannel 0: all in the file.
  std::string record{}, component{}, columns{};             ///< Empty where the row leaves them to the file.
  std::optional<double> azimuth{}, unit{}, step{}, sign{};  ///< Degrees, m/s^2, s, 1 or -1.
};

/// A channel with the words of the table about it.
struct SortedChannel {
  RecordChannel channel{};  ///< As the file and the table say.
  std::string record{};     ///< By the table; else empty.
  std::string component{};  ///< x, y, z or out by the table; else empty.
  std::string fate{};       ///< "first of Kobe", "left out: ..."
  /// File and table say these; a record is resampled, and its azimuths may be assumed.
  double step = 0.0, sign = 1.0;
  std::optional<double> azimuth{};
};

/// The channels of files or of a folder, sorted by names of files.
class SortedFiles {
 public:
  /// Reads all files in a folder; those that are no records are left out.
  SortedFiles(const std::filesystem::path& folder, const RecordOptions& options);
  /// Reads these files.
  SortedFiles(const std::vector<std::filesystem::path>& files, const RecordOptions& options);

  /// The horizontal and vertical channels that are used.
  std::vector<SortedChannel>& channels() { return channels_; }
  /// Notes as which component a channel was taken, or why it was left out.
  void note(SortedChannel& channel, const std::string& fate) const;
  /// A sentence about the files.
  void note(const std::string& text) const;
  /// Throws FileError with the way out, the table.
  [[noreturn]] void refuse(const std::string& problem) const;

 private:
  void read_table(const std::filesystem::path& table, bool is_needed, const std::set<std::string>& names);
  void read(const std::filesystem::path& file, const RecordOptions& options, bool may_leave_out);
  void apply_table(SortedChannel& channel);

  std::filesystem::path where_, table_;
  std::map<std::string, std::vector<RecordRow>> rows_{};
  std::vector<SortedChannel> channels_{};
};

}  // namespace moat
