#include "analyses/case/run_under_way.hpp"

#include <utility>

namespace moat {

void RunUnderWay::begin(Transient& transient) {
  transient_ = &transient;
  if (state_.empty()) return;
  StateArchive archive{std::exchange(state_, {})};
  transient.archive(archive);
}

void RunUnderWay::archive(StateArchive& archive) {
  StateArchive own;
  if (transient_ != nullptr) transient_->archive(own);
  std::string state = own.take();
  archive(state);
  if (archive.reads()) state_ = std::move(state);
}

}  // namespace moat
