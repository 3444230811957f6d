#include "study/ranks/outcome_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace moat {
namespace {

class Writer {
 public:
  template <class T>
  void put(T value) {
    static_assert(std::is_trivially_copyable_v<T>);
    // NaN has many forms, and files of studies keep one.
    if constexpr (std::is_same_v<T, double>)
      if (value != value) value = std::numeric_limits<double>::quiet_NaN();
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes_.append(raw, sizeof value);
  }
  void put(const std::string& text) {
    put<std::uint64_t>(text.size());
    bytes_ += text;
  }
  void put(const CaseOutcome& outcome) {
    put(outcome.state);
    put(outcome.reason);
    put<std::uint64_t>(outcome.files.size());
    for (const FileRead& each : outcome.files) {
      put(each.path);
      put(each.sha256);
    }
    put(outcome.steps);
    put(outcome.energy_error);
    put(outcome.seconds);
    put<std::uint64_t>(outcome.results.size());
    for (const NamedNumber& each : outcome.results) {
      put(each.quantity);
      put(each.where);
      put(each.unit);
      put(each.value);
    }
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

// Reads the bytes of a Writer of the same program.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_{&bytes} {}

  template <class T>
  T number() {
    T value;
    std::memcpy(&value, bytes_->data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::string text() {
    const auto length = number<std::uint64_t>();
    std::string found = bytes_->substr(at_, length);
    at_ += length;
    return found;
  }
  CaseOutcome outcome() {
    CaseOutcome found;
    found.state = number<CaseState>();
    found.reason = text();
    for (auto left = number<std::uint64_t>(); left > 0; --left) {
      FileRead each;
      each.path = text();
      each.sha256 = text();
      found.files.push_back(std::move(each));
    }
    found.steps = number<long>();
    found.energy_error = number<double>();
    found.seconds = number<double>();
    for (auto left = number<std::uint64_t>(); left > 0; --left) {
      NamedNumber each;
      each.quantity = text();
      each.where = text();
      each.unit = text();
      each.value = number<double>();
      found.results.push_back(std::move(each));
    }
    return found;
  }

 private:
  const std::string* bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::string to_bytes(std::size_t number, const CaseOutcome& outcome) {
  Writer writer;
  writer.put<std::uint64_t>(number);
  writer.put(outcome);
  return writer.take();
}

CaseOutcome from_bytes(const std::string& bytes, std::size_t& number) {
  Reader reader{bytes};
  number = reader.number<std::uint64_t>();
  return reader.outcome();
}

std::string to_bytes(const std::vector<CaseOutcome>& outcomes) {
  Writer writer;
  writer.put<std::uint64_t>(outcomes.size());
  for (const CaseOutcome& outcome : outcomes) writer.put(outcome);
  return writer.take();
}

std::vector<CaseOutcome> outcomes_from_bytes(const std::string& bytes) {
  Reader reader{bytes};
  std::vector<CaseOutcome> outcomes;
  for (auto left = reader.number<std::uint64_t>(); left > 0; --left) outcomes.push_back(reader.outcome());
  return outcomes;
}

}  // namespace moat
