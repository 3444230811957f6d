// Short texts that very many objects share.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

namespace moat {

/// A text kept once per program, however many objects carry it: a number instead of a string each. For
/// the few names that a million elements have in common, not for names of their own: a text stays until the program
/// ends. Thread-safe.
class Label {
 public:
  Label() = default;
  /// Keeps the text where it is new.
  Label(std::string_view text);
  /// Keeps the text where it is new.
  Label(const std::string& text) : Label{std::string_view{text}} {}
  /// Keeps the text where it is new; not null.
  Label(const char* text) : Label{std::string_view{text}} {}

  /// The text, for as long as the program runs.
  [[nodiscard]] const std::string& text() const;
  /// Whether the text has no characters.
  [[nodiscard]] bool empty() const { return number_ == 0; }

  // The same text has the same number.
  friend bool operator==(Label, Label) = default;
  friend std::ostream& operator<<(std::ostream& stream, Label label) { return stream << label.text(); }

 private:
  std::uint32_t number_ = 0;  // in the list of all texts; the first has no characters
};

}  // namespace moat
