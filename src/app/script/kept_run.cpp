#include "app/script/kept_run.hpp"

#include <algorithm>
#include <fstream>
#include <utility>

#include "app/script/checkpoint_file.hpp"
#include "app/script/script_origin.hpp"
#include "app/script/stop_signals.hpp"
#include "base/text/terminal.hpp"
#include "output/files/csv_writer.hpp"
#include "output/files/folder_exchange.hpp"
#include "output/files/results_folder.hpp"

namespace moat {
namespace {

constexpr double seconds_between_rows = 5.0, longest_interval = 1e9, pause_per_cost = 50.0;

}  // namespace

KeptRun::KeptRun(CaseRun& run, std::filesystem::path folder, double interval, StudyIdentity identity)
    : run_{&run},
      folder_{std::move(folder)},
      interval_{std::min(interval, longest_interval)},
      identity_{std::move(identity)},
      checkpoints_{interval_},
      rows_{Seconds{interval > 0.0 ? std::min(interval, seconds_between_rows) : seconds_between_rows}} {}

template <class Work>
void KeptRun::Regular::run(const Work& work) {
  const Clock::time_point start = Clock::now();
  work();
  const Clock::time_point end = Clock::now();
  const Seconds pause = std::max(interval, pause_per_cost * Seconds{end - start});
  next = end + std::chrono::duration_cast<Clock::duration>(pause);
}

bool KeptRun::stops() {
  // Other runs of the case begin after a stop, and end at once: they are no part of the checkpoint.
  if (stopped_) return true;
  stopped_ = StopSignals::received() != 0;
  const Clock::time_point now = Clock::now();
  if (interval_.count() > 0.0 && (stopped_ || now >= checkpoints_.next)) checkpoints_.run([&] { write_checkpoint(); });
  if (!stopped_ && !rows_fail_ && now >= rows_.next) rows_.run([&] { write_rows(); });
  return stopped_;
}

void KeptRun::end() const {
  const std::filesystem::path checkpoint = folder_ / results_file::checkpoint;
  if (stopped_ || !std::filesystem::exists(checkpoint)) return;
  wait_for_disk(folder_);
  std::error_code error;
  std::filesystem::remove(checkpoint, error);
}

std::string KeptRun::message(const std::vector<std::string>& arguments, const std::filesystem::path& folder) const {
  if (std::filesystem::exists(folder / results_file::checkpoint))
    return "moat: to go on: " + command_to_resume(arguments, folder) + "\n";
  return failure_.empty() ? "" : "moat: The last checkpoint was not written: " + failure_ + "\n";
}

void KeptRun::write_checkpoint() {
  try {
    moat::write_checkpoint(folder_ / results_file::checkpoint, identity_,
                           [&](StateArchive& archive) { run_->archive(archive); });
    failure_.clear();
  } catch (const std::exception& error) {
    failure_ = reason_of(error);
  }
}

// Where they cannot be written now, they are written at the end.
void KeptRun::write_rows() {
  const Table& table = run_->histories();
  const std::filesystem::path path = folder_ / results_file::histories_csv;
  try {
    if (rows_written_ == 0) {
      write_csv(table, path);
    } else {
      // It is closed again: a file that is replaced at the end would take its room on the disk as long as it is open.
      std::ofstream file{path, std::ios::binary | std::ios::app};
      write_csv_rows(table, rows_written_, file);
      rows_fail_ = !file.flush();
    }
    if (rows_fail_) std::filesystem::resize_file(path, whole_bytes_);
    whole_bytes_ = std::filesystem::file_size(path);
    rows_written_ = table.rows();
  } catch (const std::exception&) {
    rows_fail_ = true;
  }
}

}  // namespace moat
