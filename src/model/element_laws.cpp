#include "model/element_laws.hpp"

#include <utility>

namespace moat {

std::unique_ptr<const LawAsGiven> law_as_given(std::string_view name, std::vector<Parameter> parameters) {
  return std::make_unique<const LawAsGiven>(LawAsGiven{std::string{name}, std::move(parameters)});
}

}  // namespace moat
