#include "analyses/time_history/model_checks.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "base/error.hpp"
#include "model/building.hpp"
#include "model/plan_outline.hpp"

namespace moat {
namespace {

// The degrees of freedom whose motion, with that of those eliminated before, deforms no element: the pivot vanishes
// beside the diagonal of a matrix to which every element adds 1 N/m. Two bearings of a floor count as one where the
// square of their distance is below this share of that of their distance from the centre of mass.
std::vector<bool> loose_in_plan(const Model& model) {
  constexpr double vanishing = 1e-10, shift = 1e-12;
  SparseMatrix matrix = model.linear_stiffness(StiffnessStage::joined);
  const Vector diagonal = matrix.diagonal();
  // No pivot is zero then, and the elimination goes on.
  matrix.diagonal().array() += shift;
  const Eigen::SimplicialLDLT<SparseMatrix> factors{matrix};
  const Vector pivots = factors.permutationPinv() * factors.vectorD();
  std::vector<bool> loose;
  for (Eigen::Index i = 0; i < pivots.size(); ++i) loose.push_back(!(pivots[i] > vanishing * (1.0 + diagonal[i])));
  return loose;
}

// The bodies of a connected part with a verb: "floor 2 and floor 3 are".
std::string subject(const Model& model, const std::vector<int>& part, int number, const std::string& verb) {
  constexpr std::size_t most = 4;
  std::vector<std::string> names;
  for (int i = 0; i < model.degrees_of_freedom(); ++i)
    if (part[static_cast<std::size_t>(i)] == number && model.body(NodeId{i}).first == NodeId{i})
      names.emplace_back(model.body_name(NodeId{i}));
  if (names.size() > most) names = {names[0], names[1], names[2], std::to_string(names.size() - 3) + " more"};
  std::string text = names[0];
  for (std::size_t i = 1; i < names.size(); ++i) text += (i + 1 < names.size() ? ", " : " and ") + names[i];
  return text + (names.size() == 1 && verb == "are" ? " is" : " " + verb);
}

// The isolators of a building that leave its part loose because of their places: "the bearings of hospital do not
// resist rotation: all stand at (0, 0) m." Empty where other elements are at fault.
std::string weak_isolators(const Model& model, const std::vector<int>& part, int number) {
  const std::vector<Building> buildings = all_buildings(model);
  const std::vector<std::vector<ElementId>> isolators = isolators_of(model, buildings);
  for (std::size_t b = 0; b < buildings.size(); ++b) {
    const NodeId base = buildings[b].base;
    if (base == ground || part[static_cast<std::size_t>(model.place(base))] != number || isolators[b].empty()) continue;
    const auto info = [&](ElementId id) -> const ElementInfo& { return model.blocks()[id.block]->info(id.element); };
    const auto at_one_point = [&](ElementId id) {
      const PlanPlaces *first = info(isolators[b].front()).plan_places(), *places = info(id).plan_places();
      return first != nullptr && places != nullptr && length(places->second - first->second) < same_place;
    };
    if (!std::ranges::all_of(isolators[b], at_one_point)) continue;
    const PlanVector at = info(isolators[b].front()).plan_places()->second;
    return "the bearings of " + (buildings[b].name.empty() ? "the building" : buildings[b].name) +
           " do not resist rotation: all stand at one point, (" + to_text(at.x) + ", " + to_text(at.y) + ") m.";
  }
  return "";
}

// Whether one of the two bodies of a gap stands inside the other.
bool encloses(const Model& model, const ElementInfo& gap) {
  const Body &a = model.body(gap.first), &b = model.body(gap.second);
  return std::abs(a.x - b.x) < std::abs(a.half_width - b.half_width);
}

std::string sides_of(const Model& model, const ElementInfo& gap) {
  return "\"" + std::string{model.node_name(gap.second)} + "\" on the left of \"" +
         std::string{model.node_name(gap.first)} + "\"";
}

// Whether both motions are the same up to a time, s, at the samples of the finer one.
bool agree_until(double time, const GroundMotion& one, const GroundMotion& other) {
  const double interval = std::min(one.time_step(), other.time_step());
  const double round_off = 1e-9 * one.peak_acceleration().si();
  for (double t = 0.0, i = 0.0; t < time; ++i) {
    t = std::min(i * interval, time);
    // Round-off of the time may put a last sample behind the end of its motion.
    const double before = t * (1.0 - 1e-12);
    if (length(one.components_at(before) - other.components_at(before)) > round_off) return false;
  }
  return true;
}

}  // namespace

void check_held(const AnalysisState& state) {
  const Model& model = state.model();
  const std::vector<int> part = connected_parts(model);
  const auto part_of = [&](int node) { return static_cast<std::size_t>(part[static_cast<std::size_t>(node)]); };
  std::vector<bool> held(part.size(), false), loose(part.size(), false), free(part.size(), false);
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; !block->kind().contacts && e < block->size(); ++e) {
      const NodeId first = block->info(e).first, second = block->info(e).second;
      if ((first == ground) != (second == ground)) held[part_of(model.place(first == ground ? second : first))] = true;
    }
  const std::vector<bool> loose_nodes = model.is_plan() ? loose_in_plan(model) : std::vector<bool>(part.size(), false);
  for (int i = 0; i < model.degrees_of_freedom(); ++i) {
    if (loose_nodes[static_cast<std::size_t>(i)]) loose[part_of(i)] = true;
    if (model.body(NodeId{i}).free || state.velocity(NodeId{i}) != 0.0) free[part_of(i)] = true;
  }
  const Check check{"Model", ""};
  for (int i = 0; i < model.degrees_of_freedom(); ++i) {
    const std::size_t number = part_of(i);
    if (free[number] || (held[number] && !loose[number])) continue;
    const int number_of_part = part[static_cast<std::size_t>(i)];
    const std::string remedy = " Give .free = true where a body shall float.";
    check.that(held[number],
               subject(model, part, number_of_part, "are") + " held by nothing: no path of elements to the ground.",
               "Add the missing spring, storey or isolator; a gap holds nothing." + remedy);
    const std::string weak = weak_isolators(model, part, number_of_part);
    check.that(weak.empty(), weak, "Give bearings at two places at least." + remedy);
    check.that(false,
               subject(model, part, number_of_part, "can") +
                   " move in plan without deforming an element, along a direction or about a point.",
               "Give springs or bearings along x and along y, at two places at least." + remedy);
  }
}

void check_gap_directions(const Model& model) {
  std::vector<int> body(static_cast<std::size_t>(model.nodes()));
  for (int i = 0; i < model.nodes(); ++i) body[static_cast<std::size_t>(i)] = -1 - i;
  for (std::size_t b = 0; b < model.buildings().size(); ++b)
    for (const NodeId node : model.buildings()[b].nodes())
      body[static_cast<std::size_t>(model.place(node))] = static_cast<int>(b);
  std::map<std::pair<int, int>, const ElementInfo*> known;  // by the bodies on the left and on the right
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; block->kind().contacts && !model.is_plan() && e < block->size(); ++e) {
      const ElementInfo& gap = block->info(e);
      if (gap.first == ground || gap.second == ground) continue;
      const int right = body[static_cast<std::size_t>(model.place(gap.first))],
                left = body[static_cast<std::size_t>(model.place(gap.second))];
      known.try_emplace({left, right}, &gap);
      const auto other = known.find({right, left});
      if (left == right || other == known.end() || (encloses(model, gap) && encloses(model, *other->second))) continue;
      Check{"Gap", gap.name}.that(
          false,
          "it has " + sides_of(model, gap) + ", but gap \"" + other->second->name + "\" has " +
              sides_of(model, *other->second) + ".",
          "Exchange .left and .right of one of them. A body inside another one needs its .x and "
          "a smaller .half_width.");
    }
}

void check_start(const Model& model, const AnalysisState& state, const GroundMotion& motion, double end) {
  const Check check{"Transient", motion.name()};
  check.that(&state.model() == &model && state.fits_model(),
             "the state is that of another model, or of this one before something was added to it.",
             "Give a state that an analysis of this model reached, or none.");
  const double now = state.time();
  const std::string stands = "the state stands at t = " + to_text(now) + " s";
  const GroundMotion* former = state.ground_motion();
  check.that(now <= 0.0 || former == nullptr || agree_until(now, *former, motion),
             stands + " under other accelerations of the ground, those of \"" +
                 (former != nullptr ? former->name() : "") + "\".",
             "Make a Transient without a state, which starts at rest. For shocks one after the other give one motion, "
             "joined({first, second}, 20 * s).");
  check.that(now < end, stands + ", and the analysis ends at " + to_text(end) + " s.",
             "Make a Transient without a state, which starts at rest, or give a later TransientOptions::end.");
  check.that(model.is_plan() || !motion.has_two_components(),
             "the motion has two components, and the model moves on a line.",
             "Give one component, or make the model of diaphragms.");
  for (const ElementId id : state.elements_without_axial_force())
    check.that(false,
               "the law of the element \"" + model.blocks()[id.block]->info(id.element).name +
                   "\" takes an axial force, and none acts on it: it would stay lifted.",
               "Give .axial_forces to its building, or a law under a constant weight.");
  const double* lifted = model.ground_influence().z;
  check.that(motion.samples_z().empty() || !state.weights().empty() ||
                 std::any_of(lifted, lifted + model.degrees_of_freedom(), [](double share) { return share != 0.0; }),
             "the motion has a vertical component, and the ground lifts nothing of the model.",
             "Give a motion without one, .axial_forces to a building, or coordinates with a "
             "GeneralisedCoordinate::ground_influence along z.");
}

}  // namespace moat
