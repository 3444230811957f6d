#include <iomanip>
#include <map>
#include <moat.hpp>
#include <ostream>
#include <tuple>

#include "peers/opensees.hpp"

namespace moat::peers {
namespace {

// A material of every element, and one without stiffness.
constexpr int no_stiffness = 1;

class PlanWriter {
 public:
  PlanWriter(const Model& model, std::ostream& tcl)
      : model_{model}, tcl_{tcl}, next_node_{model.degrees_of_freedom() + 1} {}

  void write() {
    constexpr int exact_digits = 17;
    tcl_ << std::setprecision(exact_digits) << "model basic -ndm 3 -ndf 6\nuniaxialMaterial Elastic " << no_stiffness
         << " 0\n";
    for (const PlacedDiaphragm& floor : model_.diaphragms()) {
      const int tag = floor.id.x.index + 1;
      write_node(tag, floor.centre_of_mass);
      tcl_ << "fix " << tag << " 0 0 1 1 1 0\nmass " << tag << ' ' << floor.mass << ' ' << floor.mass << " 0 0 0 "
           << floor.mass * floor.gyration * floor.gyration << '\n';
    }
    for (const auto& block : model_.blocks())
      for (std::size_t e = 0; e < block->size(); ++e) write_element(block->info(e), block->law_of_block(e));
  }

 private:
  void write_node(int tag, PlanVector at) { tcl_ << "node " << tag << ' ' << at.x << ' ' << at.y << " 0\n"; }

  // The tag of a point of a body: its centre of mass, or a node tied to it.
  int point(NodeId body, PlanVector at) {
    const PlacedDiaphragm* floor = body == ground ? nullptr : model_.diaphragm_of(body);
    if (floor != nullptr && length(at - floor->centre_of_mass) < same_place) return floor->id.x.index + 1;
    const auto [found, is_new] = points_.try_emplace(std::tuple{body.index, at.x, at.y}, next_node_);
    if (!is_new) return found->second;
    write_node(next_node_, at);
    if (floor == nullptr)
      tcl_ << "fix " << next_node_ << " 1 1 1 1 1 1\n";
    else
      tcl_ << "fix " << next_node_ << " 0 0 1 1 1 0\nrigidDiaphragm 3 " << floor->id.x.index + 1 << ' ' << next_node_
           << '\n';
    return next_node_++;
  }

  void write_element(const ElementInfo& info, const LawAsGiven& law) {
    const auto value = [&](std::string_view name) { return value_of(law.parameters, name); };
    const int tag = ++last_element_, material = no_stiffness + tag;
    const auto centre = [&](NodeId body) {
      return body == ground ? PlanVector{} : model_.diaphragm_of(body)->centre_of_mass;
    };
    const PlanPlaces* places = info.plan_places();
    const int first = point(info.first, places ? places->first : centre(info.first));
    const int second = point(info.second, places ? places->second : centre(info.second));
    if (law.name == "BiaxialBilinear") {
      const double limit = value("yield_displacement"), stiffness = value("yield_force") / limit;
      const double share = value("post_yield_stiffness") / stiffness;
      tcl_ << "element elastomericBearingPlasticity " << tag << ' ' << first << ' ' << second << ' ' << stiffness << ' '
           << (1.0 - share) * value("yield_force") << ' ' << share << " 0 2";
      for (const char* direction : {" -P ", " -T ", " -My ", " -Mz "}) tcl_ << direction << no_stiffness;
      tcl_ << " -orient 0 0 1 1 0 0\n";
      return;
    }
    if (law.name == "Linear")
      tcl_ << "uniaxialMaterial Elastic " << material << ' ' << value("stiffness") << ' ' << value("damping") << '\n';
    else if (law.name == "Viscous")
      tcl_ << "uniaxialMaterial Elastic " << material << " 0 " << value("damping") << '\n';
    else
      throw InputError{"The law " + law.name + " has no counterpart in plan in OpenSees here."};
    if (places != nullptr && places->direction.x * places->direction.y != 0.0)
      throw InputError{info.name + " acts neither along x nor along y."};
    const int direction = places == nullptr ? 6 : places->direction.x != 0.0 ? 1 : 2;
    tcl_ << "element zeroLength " << tag << ' ' << first << ' ' << second << " -mat " << material << " -dir "
         << direction << '\n';
  }

  const Model& model_;
  std::ostream& tcl_;
  std::map<std::tuple<int, double, double>, int> points_;
  int next_node_, last_element_ = 0;
};

}  // namespace

void write_opensees_plan(const Model& model, std::ostream& tcl) { PlanWriter{model, tcl}.write(); }

}  // namespace moat::peers
