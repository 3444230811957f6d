#include "analyses/integrators/integrators.hpp"

#include <cstddef>
#include <utility>

#include "base/error.hpp"

namespace moat {
namespace {

template <class Action>
void for_each_integrator(const Action& action) {
  [&]<std::size_t... i>(std::index_sequence<i...>) { (action(std::variant_alternative_t<i, Integrator>{}), ...); }
  (std::make_index_sequence<std::variant_size_v<Integrator>>{});
}

}  // namespace

Integrator integrator_named(std::string_view name, std::string_view what) {
  std::optional<Integrator> found;
  for_each_integrator([&](const auto& each) {
    if (each.name == name) found = each;
  });
  if (!found)
    throw InputError{std::string{what} + ": \"" + std::string{name} +
                     "\" is not known. Give one of: " + integrator_names() + "."};
  return *found;
}

std::optional<StepScheme> scheme_of(const Integrator& integrator) {
  return std::visit(
      [](const auto& each) -> std::optional<StepScheme> {
        if constexpr (requires { each.scheme(); })
          return each.scheme();
        else
          return std::nullopt;
      },
      integrator);
}

std::string_view name_of(const Integrator& integrator) {
  return std::visit([](const auto& each) { return each.name; }, integrator);
}

std::string integrator_names() {
  std::string names;
  for_each_integrator([&](const auto& each) { names += (names.empty() ? "" : ", ") + std::string{each.name}; });
  return names;
}

}  // namespace moat
