// Lists in braces with named fields, read from the source of a script.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace moat::launcher {

/// `.clearance = 10 * cm` in such a list.
struct NamedField {
  std::string name, value;
  std::size_t offset;  ///< of the point, in the source
};

/// `Moat{.around = base, .clearance = 10 * cm}`, or the braces alone in a call.
struct DesignatedList {
  std::string type;  ///< "Moat"; empty where none stands in front
  std::vector<NamedField> fields;
};

/// Offset of GCC's place: line and column count from 1, a tabulator ends at the next multiple of 8 columns, and a
/// letter of several bytes is one column. The length of the source where there is no such place.
std::size_t offset_of(const std::string& source, int line, int column);

/// The line of an offset, from 1.
int line_at(const std::string& source, std::size_t offset);

/// `{a, f(b, c)}` -> "a", "f(b, c)". Empty for a text that is not one list in braces.
std::vector<std::string> items_of(const std::string& list);

/// A bracket that closes another kind of bracket than the one that is open, or closes nothing.
struct WrongBracket {
  std::optional<std::size_t> opening;  ///< Offset of the bracket that is open there.
  std::size_t closing;                 ///< Offset of the wrong bracket.
};

/// The first of a source.
std::optional<WrongBracket> first_wrong_bracket(const std::string& source);

/// The innermost list that is open before `offset`; without fields where there is none.
DesignatedList list_around(const std::string& source, std::size_t offset);

/// The list with named fields among the arguments of the call whose parenthesis opens at `offset`; without fields where
/// there is none, or more than one.
DesignatedList list_in_call(const std::string& source, std::size_t offset);

}  // namespace moat::launcher
