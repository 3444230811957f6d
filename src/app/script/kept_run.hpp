// Keeps a run on disk while it is computed.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "analyses/case/case_run.hpp"
#include "study/file/store.hpp"

namespace moat {

/// Writes a run into its results folder while it goes on: the rows of histories.csv every five seconds, and
/// checkpoints, from which --resume goes on. Both are written more rarely where they would take more than 2 % of the
/// time.
class KeptRun {
 public:
  /// interval: of checkpoints, s; 0 for none. stops() alone needs the run.
  KeptRun(CaseRun& run, std::filesystem::path folder, double interval, StudyIdentity identity);

  /// Before every step: whether a signal asked the run to stop. It has a last checkpoint then.
  bool stops();
  /// The results are written, and nothing is left to go on with: when they are on the disk, the checkpoint is removed,
  /// unless a signal stopped the run. Throws FileError where they do not get there.
  void end() const;
  /// Returns the command that goes on from the checkpoint that is still there, or why there was none although they are
  /// wanted, as a line for the user. folder: of the results.
  [[nodiscard]] std::string message(const std::vector<std::string>& arguments,
                                    const std::filesystem::path& folder) const;

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  // Work that is done at most so often.
  struct Regular {
    Seconds interval;
    Clock::time_point next = Clock::now() + std::chrono::duration_cast<Clock::duration>(interval);

    template <class Work>
    void run(const Work& work);
  };
  void write_checkpoint();
  void write_rows();

  CaseRun* run_;
  std::filesystem::path folder_;
  Seconds interval_;
  StudyIdentity identity_;
  Regular checkpoints_, rows_;
  std::size_t rows_written_ = 0;
  std::uintmax_t whole_bytes_ = 0;  // of the file behind the last rows
  bool rows_fail_ = false, stopped_ = false;
  std::string failure_;  // of the last checkpoint
};

}  // namespace moat
