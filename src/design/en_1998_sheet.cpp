#include "design/en_1998_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "design/sheet_lines.hpp"

namespace moat {
namespace {

using enum ClauseSource;

class En1998Lines : SheetLines {
 public:
  explicit En1998Lines(const En1998Sheet& in)
      : SheetLines{"En1998Sheet", in.building.value(), "EN 1998-1:2004, chapter 10, and EN 15129"}, code_{in} {
    check_.between("magnification", in.magnification, 1.0, 2.0, "1");
    check_.not_negative("slow_displacement", in.slow_displacement);
    give("a_g", in.spectrum.value().ground_acceleration.value() / units::g, "g");
    give("gamma_x", in.magnification, "1");
    give("d_slow", in.slow_displacement.si(), "m");
  }

  DesignSheet made() {
    solve("d_dc", [&](std::size_t i, double d) {
      const double k = loops_[i].stiffness(Length{d}).si();
      return w_ * spectral(k, loops_[i].damping_ratio(Length{d})) / k;
    });
    s_e_ = by_bound([&](std::size_t i) { return spectral(k_[i], beta_[i]); });
    add_isolators("10.8");
    add({"K_eff", "k_2 + Q/d_dc", "10.9.2", by_statics, k_, "N/m"});
    add({"xi_eff", "2 Q (d_dc - d_y)/(pi K_eff d_dc^2)", "10.9.2", by_statics, beta_});
    add({"T_eff", "2 pi sqrt(W/(g K_eff))", "10.9.2", by_statics, t_, "s"});
    add({"eta", "sqrt(10/(5 + 100 xi_eff)) >= 0.55", "3.2.2.2", followed,
         by_bound([&](std::size_t i) { return std::max(0.55, std::sqrt(10.0 / (5.0 + 100.0 * beta_[i]))); })});
    add({"S_e", "spectrum at T_eff, xi_eff", "3.2.2.2", followed, s_e_, "g"});
    add({"d_dc", "W S_e/K_eff", "10.9.3(2)", recalled, d_, "m"}, Governs::largest);
    add({"V", "W S_e", "10.9.3", recalled, by_bound([&](std::size_t i) { return w_ * s_e_[i]; }), "N"},
        Governs::largest);
    add_floors("f", {"", "V w/W = w S_e", "10.9.3", recalled, {}, "N"}, sheet_.line("V").values,
               [&](std::size_t floor, std::size_t) { return in_.floors[floor].weight.si() / w_; });
    add_displacements();
    add_rules();
    const TargetSpectrum spectrum = code_.spectrum.value();
    sheet_.notes.push_back("Spectrum: " + spectrum.name + "; " + spectrum.source + ".");
    sheet_.notes.emplace_back(
        "Not judged: change of the force by at most 10 % with rate and load, K_v/K_eff >= 150, T_v <= 0.1 s, more than "
        "15 km to a fault, tests of isolators. The superstructure stays elastic, q <= 1.5 (10.10).");
    return finished();
  }

 private:
  /// In g.
  [[nodiscard]] double spectral(double stiffness, double damping) const {
    En1998Spectrum spectrum = code_.spectrum;
    spectrum.damping_ratio = damping;
    return TargetSpectrum(spectrum).acceleration(Time{period(stiffness)}) / units::g;
  }

  void add_displacements() {
    const double delta = 1.0 + e_ * y_ / mean_square_, gamma = code_.magnification, slow = code_.slow_displacement.si();
    add({"e_tot", "actual + 0.05 d", "4.3.2", recalled, {e_}, "m"});
    add({"r", "sqrt(sum(x_i^2 + y_i^2)/N)", "10.9.3(5)", recalled, {std::sqrt(mean_square_)}, "m"});
    add({"delta", "1 + e_tot y/r^2", "10.9.3(5)", recalled, {delta}});
    const Values d_bd = by_bound([&](std::size_t i) { return delta * d_[i]; });
    add({"d_bd", "delta d_dc", "EN 15129, 3.1", followed, d_bd, "m"}, Governs::largest);
    const Values d_max = by_bound([&](std::size_t i) { return gamma * d_bd[i] + slow; });
    add({"d_max", "gamma_x d_bd + d_slow", "10.3(2)", recalled, d_max, "m"}, Governs::largest);
    add({"d_xy", "d_max sqrt(1 + 0.3^2), both directions", "4.3.3.5.1", recalled,
         by_bound([&](std::size_t i) { return std::hypot(1.0, 0.3) * d_max[i]; }), "m"},
        Governs::largest);
    const Values corner = of_suite(&SuiteValues::corner_displacement);
    Values needed = d_max;
    if (std::ranges::max(corner) > 0.0) {
      const std::string touching = touching_records();
      add({"d_bd,dyn", "histories, corner", "10.9.4", recalled, corner, "m",
           in_.suite->statistic + (touching.empty() ? "" : "; " + touching)},
          Governs::largest);
      // A bound without histories has the displacement of the formula; nominal properties lie between.
      for (std::size_t i = 0; i < needed.size(); ++i)
        if (corner[i] > 0.0 || static_cast<Bound>(i) == Bound::nominal)
          needed[i] = corner[i] > 0.0 ? gamma * corner[i] + slow : 0.0;
    }
    add_gap("gamma_x d_bd,dyn + d_slow", corner, "d_max", "10.5.4", std::move(needed));
  }

  void add_rules() {
    const Values ratio = by_bound([&](std::size_t i) {
      const Length fifth{0.2 * d_[i]};
      return k_[i] / loops_[i].stiffness(fifth).si();
    });
    const std::string linear = "no equivalent linear model", simplified = "no simplified analysis";
    add_rule({"xi_most", "xi_eff <= 0.3", "10.9.2(5)", recalled, beta_}, Governs::largest, 0.3, linear);
    add_rule({"K_ratio", "K(d_dc)/K(0.2 d_dc) >= 0.5", "10.9.2(5)", recalled, ratio}, Governs::smallest, 0.5, linear);
    add_rule({"restoring", "(F(d_dc) - F(0.5 d_dc))/W >= 0.025", "10.9.2(5)", recalled, restoring()}, Governs::smallest,
             0.025, linear);
    add_rule({"T_least", "T_eff >= 3 T_fb", "10.9.3(1)", recalled, t_, "s"}, Governs::smallest,
             3.0 * in_.fixed_base_period.si(), simplified);
    add_rule({"T_most", "T_eff <= 3 s", "10.9.3(1)", recalled, t_, "s"}, Governs::largest, 3.0, simplified);
    add_rule({"plan", "d <= 50 m", "10.9.3(1)", recalled, {in_.longer_side.si()}, "m"}, Governs::largest, 50.0,
             simplified);
    add_rule({"e_tot/d", "e_tot/d <= 0.075", "10.9.3(1)", recalled, {e_ / in_.longer_side.si()}}, Governs::largest,
             0.075, simplified);
    add_rule({"E_s/E_h", "d_dc k_2/(2 Q) >= 0.25", "EN 15129, 4.4", recalled, by_bound([&](std::size_t i) {
                return 0.5 * d_[i] * loops_[i].post_yield_stiffness.si() / loops_[i].characteristic_strength.si();
              })},
             Governs::smallest, 0.25, "no re-centring");
  }

  const En1998Sheet& code_;
  Values s_e_{};  // g
};

}  // namespace

En1998Sheet::operator DesignSheet() const { return En1998Lines{*this}.made(); }

}  // namespace moat
