// A pointer whose copy owns a copy of the object.
#pragma once

#include <memory>
#include <utility>

namespace moat {

/// Owns an object of a class with `std::unique_ptr<T> clone() const`. Copying the pointer clones the object, so that a
/// class which holds such pointers is copied by default.
template <class T>
class CopyablePointer {
 public:
  CopyablePointer() = default;
  /// Takes the object; null is none.
  CopyablePointer(std::unique_ptr<T> object) : object_{std::move(object)} {}
  /// Clones the object of the other.
  CopyablePointer(const CopyablePointer& other) : object_{other.object_ ? other.object_->clone() : nullptr} {}
  /// Clones the object of the other.
  CopyablePointer& operator=(const CopyablePointer& other) {
    if (this != &other) *this = CopyablePointer{other};
    return *this;
  }
  CopyablePointer(CopyablePointer&&) noexcept = default;
  CopyablePointer& operator=(CopyablePointer&&) noexcept = default;
  ~CopyablePointer() = default;

  /// The object, which must exist.
  T& operator*() const { return *object_; }
  /// The object, which must exist.
  T* operator->() const { return object_.get(); }
  /// Null where there is none.
  [[nodiscard]] T* get() const { return object_.get(); }

 private:
  std::unique_ptr<T> object_;
};

}  // namespace moat
