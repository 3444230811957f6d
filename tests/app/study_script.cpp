// A study of many short cases: a pulse on an isolated mass beside a wall. --wait makes every case longer.
#include <chrono>
#include <moat.hpp>
#include <thread>

using namespace moat;
using namespace moat::units;

int main(int argc, char** argv) {
  Script script{argc, argv, "Study of a mass"};
  const Time wait = script.time("wait", 0 * s, "sleep in every case");
  const Length mass_gap = script.length("last-gap", 30 * cm, "largest gap");
  const int gaps = script.integer("gaps", 20, "how many");
  const int failing = script.integer("failing", -1, "a case that fails");
  const int stuck = script.integer("stuck", -1, "a case that does not converge");
  const GroundMotion motion = script.motion(near_fault_pulse({.pulse_period = 1 * s})).scaled_to_pga(0.3 * g);
  const StudyResult study = script.study(
      {{.name = "gap", .unit = "cm", .values = linearly_spaced(5.0, mass_gap / cm, gaps)},
       StudyAxis::of_names("stiffness", {"soft", "stiff, \"rigid\""})},
      [&](const StudyCase& each) {
        std::this_thread::sleep_for(std::chrono::duration<double>{wait.si()});
        if (static_cast<int>(each.number()) == failing) throw InputError{"this case fails"};
        if (static_cast<int>(each.number()) == stuck)
          throw ConvergenceError{"this case is stuck", 1.0, 0.1, 1.0, "mass"};
        StudyModel one{Model{}, motion};
        const NodeId mass = add(one.model, Node{.name = "mass", .mass = 1000 * tonne});
        add(one.model, ShearSpring{.name = "spring", .lower = ground, .upper = mass, .stiffness = 10 * MN / m});
        add(one.model,
            Moat{.around = mass,
                 .clearance = each.value("gap") * cm,
                 .law = HertzDamp{.stiffness = (each.value("stiffness") + 1.0) * 1e9 * N / m_3_2, .restitution = 0.6}});
        return one;
      });
  double impacts = 0.0;
  for (const double each : study.values("impacts", "")) impacts += each;
  std::printf("%.17g impacts\n", impacts);
  return script.finish();
}
