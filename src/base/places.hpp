// Lists of places whose indices are checked.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"

namespace moat {

/// The parts of a building, or of an outline, in a vector whose indices are checked. Names count from 1, and indices
/// from 0; `remedy` is the sentence with which a wrong index is refused.
template <class Place, const char* remedy>
class Places : public std::vector<Place> {
  using List = std::vector<Place>;

 public:
  using List::List;
  Places() = default;
  /// All of a vector.
  Places(List list) : List(std::move(list)) {}

  /// Returns a place, counted from 0. These throw InputError outside the list.
  const Place& operator[](std::size_t index) const { return List::operator[](checked(index)); }
  Place& operator[](std::size_t index) { return List::operator[](checked(index)); }  ///< Returns it likewise.
  const Place& at(std::size_t index) const { return (*this)[index]; }                ///< Returns it likewise.
  Place& at(std::size_t index) { return (*this)[index]; }                            ///< Returns it likewise.
  const Place& front() const { return (*this)[0]; }                ///< Throws where the list is empty.
  const Place& back() const { return (*this)[this->size() - 1]; }  ///< Throws where the list is empty.
  /// Counted from 1, as names do. Throws InputError outside 1 to size(), naming the owner and the parameter.
  const Place& numbered(int number, const Check& owner, std::string_view parameter) const {
    const auto count = static_cast<int>(this->size());
    owner.that(number >= 1 && number <= count, parameter, number, "", range(1, count));
    return List::operator[](static_cast<std::size_t>(number - 1));
  }

 private:
  static std::string range(int lowest, int highest) {
    if (highest < lowest) return "left out, because there is none";
    return ">= " + std::to_string(lowest) + " and <= " + std::to_string(highest);
  }
  [[nodiscard]] std::size_t checked(std::size_t index) const {
    if (index < this->size()) return index;
    // A negative index of a script has wrapped around.
    Check{"Places", ""}.that(false, "index", static_cast<double>(static_cast<std::ptrdiff_t>(index)), "",
                             range(0, static_cast<int>(this->size()) - 1), remedy);
    return index;
  }
};

/// The remedy for a wrong index of floors of buildings.
inline constexpr char floors_remedy[] = "floors[0] is \"floor 1\": take floor(3) for \"floor 3\".";
/// The remedy for a wrong index of corners of outlines.
inline constexpr char corners_remedy[] = "corners[0] is \"corner 1\", corners[2] is \"corner 3\".";

}  // namespace moat
