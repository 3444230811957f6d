// Texts for a terminal.
#pragma once

#include <exception>
#include <ostream>
#include <string>
#include <string_view>

namespace moat {

/// `text` with \u001b and the like in place of control characters, which a terminal would obey, and of characters that
/// turn the direction of text. Newlines and all other UTF-8 stay, so that JSON stays JSON.
std::string printable(std::string_view text);

/// Prints printable(text) at once. Every text of moat that holds words of users goes through here.
std::ostream& print_text(std::ostream& to, std::string_view text);

/// A text as one word of a shell command: in quotes where it needs some.
std::string shell_word(const std::string& text);

/// The message of an error, for people.
const char* reason_of(const std::exception& error);

}  // namespace moat
