// Short texts that very many objects share.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

namespace moat {

/// A text kept once per program, however many objects carry it: the size of a pointer instead of a string each. For
/// the few names that a million elements have in common, not for names of their own: a text stays until the program
/// ends. Thread-safe.
class Label {
 public:
  Label() : text_{&none} {}
  /// Keeps the text where it is new.
  Label(std::string_view text);
  /// Keeps the text where it is new.
  Label(const std::string& text) : Label{std::string_view{text}} {}
  /// Keeps the text where it is new; not null.
  Label(const char* text) : Label{std::string_view{text}} {}

  /// The text, for as long as the program runs.
  [[nodiscard]] const std::string& text() const { return *text_; }
  /// Whether the text has no characters.
  [[nodiscard]] bool empty() const { return text_->empty(); }

  // The same text is at the same place.
  friend bool operator==(Label a, Label b) { return a.text_ == b.text_; }
  friend std::ostream& operator<<(std::ostream& stream, Label label) { return stream << label.text(); }

 private:
  // The text of all labels without characters: most labels of a million elements.
  static const std::string none;

  const std::string* text_;
};

}  // namespace moat
