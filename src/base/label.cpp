#include "base/label.hpp"

#include <deque>
#include <mutex>
#include <unordered_map>

namespace moat {
namespace {

struct Texts {
  std::mutex mutex;
  std::deque<std::string> list{""};  // they do not move
  std::unordered_map<std::string_view, std::uint32_t> numbers;
};

Texts& all_texts() {
  static Texts texts;
  return texts;
}

}  // namespace

Label::Label(std::string_view text) {
  if (text.empty()) return;
  Texts& texts = all_texts();
  const std::lock_guard lock{texts.mutex};
  if (const auto known = texts.numbers.find(text); known != texts.numbers.end()) {
    number_ = known->second;
    return;
  }
  number_ = static_cast<std::uint32_t>(texts.list.size());
  texts.numbers.emplace(texts.list.emplace_back(text), number_);
}

const std::string& Label::text() const {
  Texts& texts = all_texts();
  const std::lock_guard lock{texts.mutex};
  return texts.list[number_];
}

}  // namespace moat
