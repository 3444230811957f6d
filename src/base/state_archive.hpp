// The state of an analysis as bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace moat {

/// Writes values into bytes, or reads them back bit for bit. A class has one function for both directions:
///
///     void archive(StateArchive& archive) { archive(time_, values_, name_); }
///
/// Values may be numbers and structs of numbers, texts, std::vector, std::array, std::optional and std::map of these,
/// matrices of Eigen, and classes with such a function. Of a sparse matrix the values count: its pattern belongs to the
/// model. The bytes belong to one program on one machine.
///
/// The class that reads them is of the same model and the same options. Reading throws InputError where the bytes are
/// too short.
class StateArchive {
 public:
  StateArchive() = default;  ///< Writes.
  /// Reads these bytes.
  explicit StateArchive(std::string bytes) : bytes_{std::move(bytes)}, reads_{true} {}

  /// Whether values are read.
  [[nodiscard]] bool reads() const { return reads_; }
  /// Returns the bytes that were written.
  [[nodiscard]] std::string take() { return std::move(bytes_); }

  /// Writes or reads these values in their order.
  template <class... Values>
  void operator()(Values&... values) {
    (item(values), ...);
  }
  /// Writes a text that must be the same when it is read. Throws InputError with this sentence where it is not.
  void require_same(std::string text, const std::string& sentence) {
    const std::string own = text;
    item(text);
    if (text != own) throw InputError{sentence};
  }
  /// After reading: throws InputError where bytes are left.
  void require_end() const {
    if (reads_ && next_ != bytes_.size()) throw InputError{"The saved state is longer than that of this analysis."};
  }

 private:
  void raw(void* values, std::size_t size) {
    if (!reads_) {
      bytes_.append(static_cast<const char*>(values), size);
      return;
    }
    require(size, 1);
    if (size > 0) std::memcpy(values, bytes_.data() + next_, size);
    next_ += size;
  }
  // Before memory is taken for them.
  void require(std::size_t count, std::size_t size) const {
    if (reads_ && count > (bytes_.size() - next_) / size)
      throw InputError{"The saved state is shorter than that of this analysis."};
  }

  template <class Value>
  void item(Value& value) {
    static_assert(!std::is_pointer_v<Value>);
    if constexpr (requires { value.archive(*this); }) {
      value.archive(*this);
    } else if constexpr (std::is_trivially_copyable_v<Value>) {
      raw(&value, sizeof value);
    } else if constexpr (requires { value.nonZeros(), value.valuePtr(), value.outerIndexPtr(); }) {
      raw(value.valuePtr(), static_cast<std::size_t>(value.nonZeros()) * sizeof *value.valuePtr());
    } else {
      auto rows = value.rows(), columns = value.cols();
      (*this)(rows, columns);
      const auto fits = [](auto size, auto fixed) { return fixed < 0 ? size >= 0 : size == fixed; };
      if (!fits(rows, Value::RowsAtCompileTime) || !fits(columns, Value::ColsAtCompileTime))
        throw InputError{"The saved state has a matrix of another shape than this analysis."};
      if (rows > 0 && columns > 0) {  // their product may be too large for a number
        require(static_cast<std::size_t>(columns), sizeof *value.data());
        require(static_cast<std::size_t>(rows), static_cast<std::size_t>(columns) * sizeof *value.data());
      }
      if (reads_) value.resize(rows, columns);
      raw(value.data(), static_cast<std::size_t>(value.size()) * sizeof *value.data());
    }
  }
  template <class Value>
  void item(std::vector<Value>& values) {
    std::size_t count = values.size();
    item(count);
    require(count, 1);
    if (reads_) values.resize(count);
    if constexpr (std::is_trivially_copyable_v<Value> && !requires(Value & each) { each.archive(*this); })
      raw(values.data(), count * sizeof(Value));
    else
      for (Value& each : values) item(each);
  }
  template <class Value, std::size_t count>
  void item(std::array<Value, count>& values) {
    for (Value& each : values) item(each);
  }
  template <class Value>
  void item(std::optional<Value>& value) {
    unsigned char exists = value.has_value();  // any byte may be read
    item(exists);
    if (reads_) value = exists != 0 ? std::optional{Value{}} : std::nullopt;
    if (value) item(*value);
  }
  template <class Key, class Value>
  void item(std::map<Key, Value>& values) {
    std::vector<std::pair<Key, Value>> list{values.begin(), values.end()};
    item(list);
    if (reads_) values = {list.begin(), list.end()};
  }
  template <class First, class Second>
  void item(std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  void item(std::string& text) {
    std::size_t size = text.size();
    item(size);
    require(size, 1);
    if (reads_) text.resize(size);
    raw(text.data(), size);
  }

  std::string bytes_;
  bool reads_ = false;
  std::size_t next_ = 0;  // to read
};

}  // namespace moat
