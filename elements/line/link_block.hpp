// The block of links that fits a law.
#pragma once

#include <type_traits>

#include "elements/contact/contact_links.hpp"
#include "elements/line/links.hpp"
#include "elements/line/links_with_regimes.hpp"

namespace moat {
namespace detail {

template <class Law, class Ends>
struct LinkBlockOf {
  using type = Links<Law, Ends>;
};
template <LawWithRegimes Law, class Ends>
struct LinkBlockOf<Law, Ends> {
  using type = LinksWithRegimes<Law, Ends>;
};
template <ContactLaw Law, class Ends>
struct LinkBlockOf<Law, Ends> {
  using type = ContactLinks<Law, Ends>;
};

}  // namespace detail

/// All elements of a model that put a law of type Law between two places: Links, LinksWithRegimes or ContactLinks.
///
///     model.block<LinkBlock<Linear>>().add({.name = "spring", .first = ground, .second = node}, Linear{...});
template <ForceLaw Law, class Ends = NodePair>
using LinkBlock = typename detail::LinkBlockOf<Law, Ends>::type;

}  // namespace moat
