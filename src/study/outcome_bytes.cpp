#include "study/outcome_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace moat {
namespace {

struct Writer {
  std::string bytes{};

  template <class T>
  void pass(const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  // NaN has many forms, and files of studies keep one.
  void pass(double value) { pass<double>(value != value ? std::numeric_limits<double>::quiet_NaN() : value); }
  void pass(const std::string& text) {
    pass<std::uint64_t>(text.size());
    bytes += text;
  }
  template <class T>
  void pass_size(const std::vector<T>& list) {
    pass<std::uint64_t>(list.size());
  }
};

/// Reads the bytes of a Writer of the same program.
struct Reader {
  const std::string& bytes;
  std::size_t at;

  template <class T>
  void pass(T& value) {
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
  }
  void pass(std::string& text) {
    std::uint64_t length = 0;
    pass(length);
    text = bytes.substr(at, length);
    at += length;
  }
  template <class T>
  void pass_size(std::vector<T>& list) {
    std::uint64_t size = 0;
    pass(size);
    list.resize(size);
  }
};

template <class Bytes>
void pass_fields(Bytes& bytes, std::uint64_t number, CaseOutcome& outcome) {
  bytes.pass(number);
  bytes.pass(outcome.state);
  bytes.pass(outcome.reason);
  bytes.pass_size(outcome.files);
  for (FileRead& each : outcome.files) {
    bytes.pass(each.path);
    bytes.pass(each.sha256);
  }
  bytes.pass(outcome.steps);
  bytes.pass(outcome.energy_error);
  bytes.pass(outcome.seconds);
  bytes.pass_size(outcome.results);
  for (NamedNumber& each : outcome.results) {
    bytes.pass(each.quantity);
    bytes.pass(each.where);
    bytes.pass(each.unit);
    bytes.pass(each.value);
  }
}

}  // namespace

std::string to_bytes(std::size_t number, CaseOutcome outcome) {
  Writer writer;
  pass_fields(writer, number, outcome);
  return writer.bytes;
}

CaseOutcome from_bytes(const std::string& bytes, std::size_t& at) {
  Reader reader{bytes, at};
  CaseOutcome outcome;
  pass_fields(reader, 0, outcome);
  at = reader.at;
  return outcome;
}

}  // namespace moat
