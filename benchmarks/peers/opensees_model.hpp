// A model of moat in the words of OpenSees.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace moat {
class Model;
}

namespace moat::peers {

/// Tags of the elements whose force is an impact.
struct OpenSeesTags {
  std::vector<int> gaps;
};

/// Writes Tcl that builds the same model: nodes with masses and committed displacement, velocity and acceleration,
/// springs, dampers, bilinear bearings, and gaps with `LinearElastic` or `HertzDamp`. Node i of the model has tag
/// i + 1, the ground tag 0. Throws InputError for a law that OpenSees does not have.
OpenSeesTags write_opensees_model(const Model& model, std::ostream& tcl);

}  // namespace moat::peers
