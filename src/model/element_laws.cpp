#include "model/element_laws.hpp"

#include <utility>

namespace moat {

std::shared_ptr<const LawAsGiven> law_as_given(std::string_view name, std::vector<Parameter> parameters) {
  return std::make_shared<const LawAsGiven>(LawAsGiven{std::string{name}, std::move(parameters)});
}

}  // namespace moat
