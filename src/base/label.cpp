#include "base/label.hpp"

#include <mutex>
#include <unordered_set>

namespace moat {

constinit const std::string Label::none{};

Label::Label(std::string_view text) : Label{} {
  if (text.empty()) return;
  static std::mutex mutex;
  // Elements of a set of nodes do not move.
  static std::unordered_set<std::string> texts;
  const std::lock_guard lock{mutex};
  text_ = &*texts.emplace(text).first;
}

}  // namespace moat
