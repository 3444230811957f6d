// A pointer whose copy owns a copy of the object.
#pragma once

#include <memory>
#include <utility>

namespace moat {

/// Owns an object, and copies it when the pointer is copied: by `std::unique_ptr<T> clone() const` where its class has
/// that. A class which holds such pointers is copied by default.
template <class T>
class CopyablePointer {
 public:
  CopyablePointer() = default;
  /// Takes the object; null is none.
  CopyablePointer(std::unique_ptr<T> object) : object_{std::move(object)} {}
  /// A copy of the object.
  CopyablePointer(const T& object) : object_{copy_of(object)} {}
  /// Copies the object of the other.
  CopyablePointer(const CopyablePointer& other) : object_{other.object_ ? copy_of(*other.object_) : nullptr} {}
  /// Copies the object of the other.
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
  /// Whether there is one.
  explicit operator bool() const { return object_ != nullptr; }

 private:
  static std::unique_ptr<T> copy_of(const T& object) {
    if constexpr (requires { object.clone(); })
      return object.clone();
    else
      return std::make_unique<T>(object);
  }

  std::unique_ptr<T> object_;
};

}  // namespace moat
