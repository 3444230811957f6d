#include "peers/opensees.hpp"

#include <algorithm>
#include <iomanip>
#include <moat.hpp>
#include <ostream>
#include <string_view>

namespace moat::peers {
namespace {

using Values = std::vector<Parameter>;

double value_of(const Values& parameters, std::string_view name) {
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  if (found == parameters.end()) throw InputError{"There is no parameter " + std::string{name} + "."};
  return found->value;
}

// A gap closes under compression: its clearance is negative.
void write_material(const std::string& law, const Values& parameters, double clearance, int tag, std::ostream& tcl) {
  const auto value = [&](std::string_view name) { return value_of(parameters, name); };
  tcl << "uniaxialMaterial ";
  if (law == "Linear") {
    tcl << "Elastic " << tag << ' ' << value("stiffness") << ' ' << value("damping");
  } else if (law == "Viscous") {
    tcl << "Elastic " << tag << " 0 " << value("damping");
  } else if (law == "Bilinear") {
    const double initial_stiffness = value("yield_force") / value("yield_displacement");
    tcl << "Steel01 " << tag << ' ' << value("yield_force") << ' ' << initial_stiffness << ' '
        << value("post_yield_stiffness") / initial_stiffness;
  } else if (law == "LinearElastic") {
    constexpr double never_yields = -1e15;
    tcl << "ElasticPPGap " << tag << ' ' << value("stiffness") << ' ' << never_yields << ' ' << -clearance;
  } else if (law == "HertzDamp") {
    const double restitution = value("restitution"), damping_ratio = 0.75 * (1.0 - restitution * restitution);
    tcl << "Hertzdamp " << tag << ' ' << value("stiffness") << ' ' << damping_ratio << ' ' << -clearance << " 1.5";
  } else {
    throw InputError{"The law " + law + " has no counterpart in OpenSees here."};
  }
  tcl << '\n';
}

}  // namespace

std::vector<int> write_opensees_model(const AnalysisState& state, std::ostream& tcl) {
  const Model& model = state.model();
  constexpr int exact_digits = 17;
  tcl << std::setprecision(exact_digits) << "model basic -ndm 1 -ndf 1\nnode 0 0.0\nfix 0 1\n";
  const auto tag_of = [](NodeId node) { return node == ground ? 0 : node.index + 1; };
  for (int i = 0; i < model.degrees_of_freedom(); ++i) {
    const NodeId node{i};
    tcl << "node " << tag_of(node) << " 0.0\nmass " << tag_of(node) << ' ' << model.mass(node) << '\n';
    tcl << "setNodeDisp " << tag_of(node) << " 1 " << state.displacement(node) << " -commit\n";
    tcl << "setNodeVel " << tag_of(node) << " 1 " << state.velocity(node) << " -commit\n";
    tcl << "setNodeAccel " << tag_of(node) << " 1 " << state.acceleration(node) << " -commit\n";
  }
  std::vector<int> gaps;
  int tag = 0;
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) {
      ++tag;
      const ElementInfo& info = block->info(e);
      const LawAsGiven law = block->law(e);
      write_material(law.name, law.parameters, info.offset, tag, tcl);
      // Both programs measure second minus first; a gap's deformation is compression here and extension there.
      const bool is_gap = block->kind().contacts;
      const NodeId first = is_gap ? info.second : info.first, second = is_gap ? info.first : info.second;
      tcl << "element zeroLength " << tag << ' ' << tag_of(first) << ' ' << tag_of(second) << " -mat " << tag
          << " -dir 1\n";
      if (is_gap) gaps.push_back(tag);
    }
  return gaps;
}

}  // namespace moat::peers
