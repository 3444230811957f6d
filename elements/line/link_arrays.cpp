#include "elements/line/link_arrays.hpp"

#include <utility>

namespace moat {

LinkArrays::LinkArrays() = default;
LinkArrays::LinkArrays(const LinkArrays& other) = default;
LinkArrays& LinkArrays::operator=(const LinkArrays& other) = default;
LinkArrays::~LinkArrays() = default;

void LinkArrays::append(ElementInfo&& info) {
  // Those of most blocks are zero.
  if (info.offset != 0.0 || !offsets_.empty()) {
    offsets_.resize(infos_.size(), 0.0);
    offsets_.push_back(info.offset);
  }
  if (!infos_.empty() && info.details && infos_.back().details && *info.details == *infos_.back().details)
    info.details = infos_.back().details;
  infos_.push_back(std::move(info));
}

void LinkArrays::resize(Needs needs) {
  const std::size_t count = infos_.size();
  now_.resize(count);
  forces_.resize(count, 0.0);
  force_rates_.resize(count, 0.0);
  if (needs.tangents) {
    stiffnesses_.resize(count, 0.0);
    dampings_.resize(count, 0.0);
  }
  if (needs.start) start_.resize(count);
  if (needs.before) before_.resize(count);
}

void LinkArrays::start_motion() { start_ = now_; }

void LinkArrays::keep_stiffnesses() { start_stiffnesses_ = stiffnesses_; }

}  // namespace moat
