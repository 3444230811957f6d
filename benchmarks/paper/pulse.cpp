// The paper's building under a synthetic near-fault pulse, which needs no record. Not in the paper.
#include "paper/paper_building.hpp"
#include "paper/records.hpp"
#include "paper/sweep.hpp"

using namespace moat;
using namespace moat::paper;
using namespace moat::units;

namespace {

void show(Exhibit& exhibit) {
  exhibit.text(
      "The near-fault records cannot be handed on with moat. This is the same building under a synthetic velocity "
      "pulse "
      "(Mavroeidis & Papageorgiou 2003) of period 1.3 s, scaled to 0.4 g; the paper has nothing to compare it with.");
  run_sweep(
      exhibit,
      {.name = "pulse",
       .title = "gap under a pulse",
       .axis = {.name = "gap", .unit = "cm", .values = linearly_spaced(5.0, 50.0, points(exhibit, 46))},
       .x_label = "gap [cm]",
       .build = [](Model& model, const StudyCase& each) { return add_pounding(model, {}, each.value("gap") * cm); }},
      {near_fault_pulse().scaled_to_pga(paper_pga)}, {"synthetic pulse"},
      "Peaks over the gap under the synthetic pulse; everything else as in the plain reading.");
}

}  // namespace

int main(int argc, char** argv) { return run_exhibit(argc, argv, "pulse", "Synthetic near-fault pulse", show); }
