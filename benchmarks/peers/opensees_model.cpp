#include "peers/opensees.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <moat.hpp>
#include <ostream>
#include <string_view>

namespace moat::peers {
namespace {

using Values = std::vector<Parameter>;

constexpr int pendulum_tags = 100000;     // between the tags of the parts of a pendulum
constexpr double axial_stiffness = 1e12;  // N/m

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
  } else if (law == "YieldingStorey") {
    tcl << "Steel01 " << tag << ' ' << value("yield_force") << ' ' << value("stiffness") << ' '
        << value("hardening_ratio");
  } else if (law == "LinearElastic") {
    constexpr double never_yields = -1e15;
    tcl << "ElasticPPGap " << tag << ' ' << value("stiffness") << ' ' << never_yields << ' ' << -clearance;
  } else if (law == "BoucWen") {
    const double limit = value("yield_displacement"), initial_stiffness = value("yield_force") / limit;
    const double to_limit = std::pow(limit, -value("exponent"));
    tcl << "BoucWen " << tag << ' ' << value("post_yield_stiffness") / initial_stiffness << ' ' << initial_stiffness
        << ' ' << value("exponent") << ' ' << (1.0 - value("beta")) * to_limit << ' ' << value("beta") * to_limit
        << " 1 0 0 0 1e-12 50";
  } else if (law == "BilinearImpact") {
    const BilinearContact contact = BilinearImpact{HertzStiffness{value("stiffness")}, value("restitution"),
                                                   Length{value("expected_indentation")}, value("yield_share")}
                                        .between(0.0);
    tcl << "ImpactMaterial " << tag << ' ' << contact.loading_stiffness << ' ' << contact.yielding_stiffness << ' '
        << -contact.yield_indentation << ' ' << -clearance;
  } else if (law == "HertzDamp") {
    const double restitution = value("restitution"), damping_ratio = 0.75 * (1.0 - restitution * restitution);
    tcl << "Hertzdamp " << tag << ' ' << value("stiffness") << ' ' << damping_ratio << ' ' << -clearance << " 1.5";
  } else {
    throw InputError{"The law " + law + " has no counterpart in OpenSees here."};
  }
  tcl << '\n';
}

// The slider stands upright; its axial spring is shortened by the weight (write_opensees_model()).
void write_pendulum(const Values& parameters, int tag, int node, bool single_bearing, std::ostream& tcl) {
  const auto value = [&](std::string_view name) { return value_of(parameters, name); };
  const double weight = value("weight"), friction = value("friction.coefficient");
  const double restoring = weight / value("radius"), elastic = friction * weight / value("yield_displacement");
  const int axial = tag + pendulum_tags, free = axial + pendulum_tags, spring = free + pendulum_tags;
  tcl << "frictionModel Coulomb " << tag << ' ' << friction << "\nuniaxialMaterial Elastic " << axial << ' '
      << axial_stiffness << "\nuniaxialMaterial Elastic " << free << " 0\nelement ";
  if (single_bearing)
    tcl << "singleFPBearing " << tag << " 0 " << node << ' ' << tag << ' ' << value("radius") << ' '
        << elastic + restoring;
  else
    tcl << "flatSliderBearing " << tag << " 0 " << node << ' ' << tag << ' ' << elastic;
  tcl << " -P " << axial << " -Mz " << free << " -orient 0 1 0 -1 0 0";
  // Its own tolerance, 1e-12 N, is below round-off.
  tcl << (single_bearing ? " -iter 25 1e-6\n" : "\n");
  if (!single_bearing)
    tcl << "uniaxialMaterial Elastic " << spring << ' ' << restoring << "\nelement zeroLength " << spring << " 0 "
        << node << " -mat " << spring << " -dir 1\n";
  tcl << "setNodeDisp " << node << " 2 " << -weight / axial_stiffness << " -commit\n";
}

bool is_pendulum(const ElementBlock& block, std::size_t element) {
  return block.law(element).name == "FrictionPendulum";
}

bool has_pendulums(const Model& model) {
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e)
      if (is_pendulum(*block, e)) return true;
  return false;
}

}  // namespace

double value_of(const std::vector<Parameter>& parameters, std::string_view name) {
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  if (found == parameters.end()) throw InputError{"There is no parameter " + std::string{name} + "."};
  return found->value;
}

std::vector<int> write_opensees_model(const AnalysisState& state, const OpenSeesSetting& setting, std::ostream& tcl) {
  const Model& model = state.model();
  constexpr int exact_digits = 17;
  tcl << std::setprecision(exact_digits);
  // A pendulum of OpenSees needs a vertical displacement and a rotation, which are held.
  const bool upright = has_pendulums(model);
  const std::string place = upright ? " 0.0 0.0\n" : " 0.0\n", no_mass = upright ? " 0 0\n" : "\n";
  tcl << (upright ? "model basic -ndm 2 -ndf 3\nnode 0 0.0 0.0\nfix 0 1 1 1\n"
                  : "model basic -ndm 1 -ndf 1\nnode 0 0.0\nfix 0 1\n");
  const auto tag_of = [](NodeId node) { return node == ground ? 0 : node.index + 1; };
  for (int i = 0; i < model.degrees_of_freedom(); ++i) {
    const NodeId node{i};
    const int tag = tag_of(node);
    tcl << "node " << tag << place << "mass " << tag << ' ' << model.mass(node) << no_mass;
    if (upright) tcl << "fix " << tag << " 0 1 1\n";
  }
  std::vector<int> gaps;
  int tag = 0, first_storey = 0;
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; e < block->size(); ++e) {
      ++tag;
      const ElementInfo& info = block->info(e);
      const LawAsGiven law = block->law(e);
      if (is_pendulum(*block, e)) {
        write_pendulum(law.parameters, tag, tag_of(info.second), setting.single_bearing, tcl);
        continue;
      }
      write_material(law.name, law.parameters, info.offset, tag, tcl);
      // Both programs measure second minus first; a gap's deformation is compression here and extension there.
      const bool is_gap = block->kind().contacts;
      const NodeId first = is_gap ? info.second : info.first, second = is_gap ? info.first : info.second;
      tcl << "element zeroLength " << tag << ' ' << tag_of(first) << ' ' << tag_of(second) << " -mat " << tag
          << " -dir 1\n";
      if (is_gap) gaps.push_back(tag);
      if (info.name == "storey 1") first_storey = tag;
    }
  // A zeroLength element takes the displacements and velocities that it finds as those of its rest.
  for (int i = 0; i < model.degrees_of_freedom(); ++i) {
    const NodeId node{i};
    tcl << "setNodeDisp " << tag_of(node) << " 1 " << state.displacement(node) << " -commit\n";
    tcl << "setNodeVel " << tag_of(node) << " 1 " << state.velocity(node) << " -commit\n";
    tcl << "setNodeAccel " << tag_of(node) << " 1 " << state.acceleration(node) << " -commit\n";
  }
  return gaps.empty() ? std::vector{first_storey} : gaps;
}

}  // namespace moat::peers
