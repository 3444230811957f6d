// Ground motions and records.
#include <gtest/gtest.h>

#include "constructions.hpp"

namespace moat::constructions {
namespace {

using namespace units;

std::function<void()> pulse(const NearFaultPulse& parameters) {
  return [parameters] { static_cast<void>(near_fault_pulse(parameters)); };
}
std::function<void()> motion(double step, std::vector<double> samples) {
  return [=] { GroundMotion("quake", step, samples); };
}
GroundMotion ramp(double step = 0.01) { return {"ramp", step, {0.0, 1.0, 2.0}}; }
template <class Change>
std::function<void()> pair(Change change) {
  return [change] {
    PlanMotion both{ramp(), ramp()};
    change(both);
    static_cast<void>(both.resolved());
  };
}

}  // namespace

Constructions motions() {
  return {
      {"a pulse of no period",
       pulse({.pulse_period = 0 * s}),
       {"NearFaultPulse", "pulse_period", "0 s", "> 0 s and finite", "Check its sign and its unit"}},
      {"a pulse of no speed",
       pulse({.amplitude = 0 * m / s}),
       {"NearFaultPulse", "amplitude", "0 m/s", "> 0 m/s and finite",
        "Use scaled_by(-1) to turn the direction of the motion"}},
      {"a pulse shorter than its wave",
       pulse({.oscillation_ratio = 1}),
       {"NearFaultPulse", "oscillation_ratio", "1", "> 1 and <= 20",
        "It is the length of the pulse over its period; observed"}},
      {"a pulse turned too often",
       pulse({.phase = 100}),
       {"NearFaultPulse", "phase", "100 rad", "from -6.28319 rad to 6.28319 rad", "Give it in radians"}},
      {"a pulse in steps too long",
       pulse({.time_step = 1 * s}),
       {"NearFaultPulse", "time_step", "1 s", "> 0 s and <= 0.065 s",
        "The period of the pulse needs at least 20 samples"}},
      {"a pulse after an age",
       pulse({.lead_in = 10000 * s}),
       {"NearFaultPulse", "lead_in", "10000 s", "from 0 s to 1000 s", "Check its sign and its unit"}},
      {"a pulse before its end",
       pulse({.quiet_after = -1 * s}),
       {"NearFaultPulse", "quiet_after", "-1 s", "from 0 s to 1000 s", "Check its sign and its unit"}},
      {"a pulse of ten million samples",
       pulse({.time_step = 1e-6 * s}),
       {"NearFaultPulse", "total duration / time_step", "2e+07", "< 1e7",
        "Give a longer time_step or a shorter lead_in and quiet_after"}},
      {"a motion of no step",
       motion(0.0, {0.0, 1.0}),
       {"GroundMotion \"quake\"", "time step", "0 s", "from 1e-09 s to 1e+06 s",
        "Give the interval between two samples"}},
      {"a motion of one sample",
       motion(0.01, {0.0}),
       {"GroundMotion \"quake\"", "number of samples", "1", ">= 2",
        "Give the acceleration at the beginning and at the end of at"}},
      {"a motion with a hole",
       motion(0.01, {0.0, not_a_number}),
       {"GroundMotion \"quake\"", "sample 1 (counted from 0)", "nan m/s^2", "a finite number",
        "Repair the record before using it"}},
      {"a motion as of a gun",
       motion(0.01, {0.0, 2e6}),
       {"GroundMotion \"quake\"", "sample 1 (counted from 0)", "2e+06 m/s^2", "from -1e+06 m/s^2 to 1e+06 m/s^2",
        "Check the unit of the record"}},
      {"a motion scaled by nothing known",
       [] { static_cast<void>(ramp().scaled_by(infinite)); },
       {"GroundMotion \"ramp\"", "scale factor", "inf", "a finite number", "division by zero"}},
      {"a motion at rest scaled to a peak",
       [] { static_cast<void>(still_ground(1 * s).scaled_to_pga(1 * g)); },
       {"GroundMotion \"still ground\"", "zero everywhere", "cannot be scaled", "peak acceleration", "Check the file"}},
      {"a motion scaled to no peak",
       [] { static_cast<void>(ramp().scaled_to_pga(0 * g)); },
       {"GroundMotion \"ramp\"", "target PGA", "0 m/s^2", "> 0 m/s^2 and finite", "Give it as, for example, 0.4 * g"}},
      {"a motion scaled to no spectrum",
       [] { static_cast<void>(scaled_to_sa(ramp(), 1 * s, -1 * g)); },
       {"GroundMotion \"ramp\"", "target spectral acceleration", "-9.80665 m/s^2", "> 0 m/s^2 and finite",
        "Check its sign and its unit"}},
      {"a pair turned more than once",
       pair([](auto& both) { both.incidence = 400 * deg; }),
       {"PlanMotion \"ramp + ramp\"", "incidence", "400 deg", "> -360 and < 360", "Write it with its unit: 30 * deg"}},
      {"a pair with a factor for nothing",
       pair([](auto& both) { both.vertical_factor = 2; }),
       {"PlanMotion \"ramp + ramp\"", "vertical_factor", "without", "a vertical component",
        "Give the record as `vertical`"}},
      {"a pair in steps that do not fit",
       pair([](auto& both) { both.second = ramp(0.007); }),
       {"PlanMotion \"ramp + ramp\"", "sampling intervals", "0.01 s and 0.007 s", "do not divide each other",
        "Resample one of them"}},
      {"a vertical motion of a pair",
       [] {
         static_cast<void>(with_vertical(PlanMotion{ramp(), ramp()}, ramp()));
       },
       {"with_vertical", "ramp + ramp", "several components", "Give motions", "one component each"}},
      {"no shock",
       [] { static_cast<void>(joined({}, 1 * s)); },
       {"joined", "there is no", "motion", "Give the shocks", "in their order"}},
      {"shocks before each other",
       [] {
         static_cast<void>(joined({ramp(), ramp()}, -1 * s));
       },
       {"joined", "rest", "-1 s", "from 0 s to 1e+06 s", "Give the time between two shocks"}},
      {"shocks in other steps",
       [] {
         static_cast<void>(joined({ramp(), ramp(0.02)}, 1 * s));
       },
       {"joined \"ramp\"", "time step", "0.02 s", "that of the first motion, 0.01 s",
        "Make a GroundMotion of samples at that interval;"}},
      {"a filter above the samples",
       [] { static_cast<void>(high_passed(ramp(), 60 * Hz, 2)); },
       {"high_passed \"ramp\"", "corner", "60 Hz", "> 0 Hz and < 50 Hz",
        "A record holds nothing above half its sampling frequency"}},
      {"a filter of order 30",
       [] { static_cast<void>(high_passed(ramp(), 1 * Hz, 30)); },
       {"high_passed \"ramp\"", "order", "30", "from 1 to 20", "Give a number in this range"}},
      {"a record of one component as a pair",
       [] { static_cast<void>(Record{.name = "KBU000", .first = ramp()}.plan()); },
       {"Record \"KBU000\"", "one", "horizontal component", "A model in plan needs two",
        "a model on a line takes .first"}},
      {"records in no folder",
       [] { static_cast<void>(read_records("no such folder", RecordOptions{})); },
       {"records", "no such folder", "No such file or directory", "Give", "a folder with records"}},
      {"a record in no file",
       [] { static_cast<void>(read_motion("no such record.AT2", TextColumns{})); },
       {"no such record.AT2", "there is", "no such file", "Check", "the path"}},
      {"one shock of rest",
       [] {
         // The last sample of one and the first of the next are one sample, their sum.
         const GroundMotion both = joined({ramp(), ramp()}, 0 * s);
         EXPECT_EQ(both.duration(), 0.04);
         EXPECT_EQ(both.acceleration_at(0.02), 2.0);
       }},
      {"a motion of the least step",
       [] {
         // v = a t^2/(2 T) at the end of a ramp.
         const GroundMotion short_ramp{"ramp", 1e-9, {0.0, 1e6}};
         EXPECT_NEAR(short_ramp.velocity().back(), 0.5e-3, 1e-18);
       }},
  };
}

}  // namespace moat::constructions
