#include "model/with_contacts.hpp"

#include <algorithm>
#include <set>

#include "model/analysis_state.hpp"

namespace moat {
namespace {

// Calls a function for every contact and for soil: with block, element, and the parameters that can be changed, null
// without any.
template <class Function>
void for_each_changeable(const Model& model, Function function) {
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    for (std::size_t e = 0; e < model.blocks()[b]->size(); ++e) {
      const ChangeableContact* contact = model.blocks()[b]->info(e).detail(&ElementDetails::changeable_contact);
      if (contact != nullptr || model.blocks()[b]->kind().contacts) function(b, e, contact);
    }
  }
}

void check_change(const ContactChange& change, const ChangeableParameters& can) {
  const Check check{"ContactChange", ""};
  check.positive("stiffness_factor", change.stiffness_factor, "1");
  check.between("restitution_change", change.restitution_change, -1.0, 1.0, "1");
  check.not_negative("clearance_factor", change.clearance_factor, "1");
  check.positive("soil_factor", change.soil_factor, "1");
  check.that(can.stiffness || change.stiffness_factor == 1.0, "stiffness_factor", change.stiffness_factor, "1",
             "left out here", "No law of a contact of the model has a stiffness that can be changed.");
  check.that(can.restitution || change.restitution_change == 0.0, "restitution_change", change.restitution_change, "1",
             "left out here", "No law of a contact of the model has a restitution that can be changed.");
  check.that(can.clearance || change.clearance_factor == 1.0, "clearance_factor", change.clearance_factor, "1",
             "left out here", "The model has no gap with a clearance.");
  check.that(can.soil || change.soil_factor == 1.0, "soil_factor", change.soil_factor, "1", "left out here",
             "The model has no soil: give FlexibleWall::backfill.");
}

}  // namespace

ChangeableParameters changeable_parameters(const Model& model) {
  ChangeableParameters can;
  std::set<std::string> unchanged;
  for_each_changeable(model, [&](std::size_t b, std::size_t e, const ChangeableContact* contact) {
    const ElementBlock& block = *model.blocks()[b];
    if (!block.kind().contacts) {
      can.soil = true;
      return;
    }
    if (contact == nullptr) {
      unchanged.insert(block.law(e).name);
      return;
    }
    if (!contact->has_stiffness && !contact->restitution) unchanged.insert(contact->law);
    can.stiffness |= contact->has_stiffness;
    can.restitution |= contact->restitution.has_value();
    can.clearance |= block.info(e).offset > 0.0;
  });
  can.unchanged_laws = {unchanged.begin(), unchanged.end()};
  return can;
}

Model with_contacts(const Model& model, const ContactChange& change) {
  check_change(change, changeable_parameters(model));
  Model changed = model;
  const AnalysisState at_rest{model};
  for_each_changeable(model, [&](std::size_t b, std::size_t e, const ChangeableContact* contact) {
    if (contact == nullptr) return;
    ContactChange of_gap = change;
    if (model.blocks()[b]->kind().contacts && at_rest.elements(b).results()[e].deformation > 0.0)
      of_gap.clearance_factor = 1.0;
    contact->change(*changed.blocks()[b], e, of_gap);
  });
  return changed;
}

std::vector<double> restitutions_of_contacts(const Model& model) {
  std::set<double> all;
  for_each_changeable(model, [&](std::size_t, std::size_t, const ChangeableContact* contact) {
    if (contact != nullptr && contact->restitution) all.insert(*contact->restitution);
  });
  return {all.begin(), all.end()};
}

}  // namespace moat
