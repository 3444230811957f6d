#include "design/asce_7_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "design/sheet_lines.hpp"

namespace moat {
namespace {

using enum ClauseSource;
using std::numbers::pi;

/// B_M of table 17.5-1 by straight lines; held beyond its ends.
double asce_7_damping_coefficient(double beta) {
  constexpr std::array<double, 7> ratios{0.02, 0.05, 0.10, 0.20, 0.30, 0.40, 0.50};
  constexpr std::array<double, 7> coefficients{0.8, 1.0, 1.2, 1.5, 1.7, 1.9, 2.0};
  if (beta <= ratios.front()) return coefficients.front();
  for (std::size_t i = 1; i < ratios.size(); ++i)
    if (beta <= ratios[i])
      return std::lerp(coefficients[i - 1], coefficients[i], (beta - ratios[i - 1]) / (ratios[i] - ratios[i - 1]));
  return coefficients.back();
}

class Asce7Lines : SheetLines {
 public:
  explicit Asce7Lines(const Asce7Sheet& in)
      : SheetLines{"Asce7Sheet", in.building.value(), "ASCE/SEI 7-16 and 7-22, chapter 17"},
        code_{in},
        spectrum_{in.spectrum.value()} {
    check_.above_up_to("s_1", in.s_1, 0.0, 5.0, "g", "It is a fraction of g: 60 % of g is 0.6.");
    static_cast<void>(spectrum_.design());  // its checks
    check_.between("response_modification", in.response_modification, 1.0, 8.0, "1");
    check_.between("importance", in.importance, 1.0, 1.5, "1");
    check_.not_negative("wind", in.wind);
    if (in.mce_spectrum)
      check_.that(in.mce_spectrum->damping_ratio == 0.05, "mce_spectrum.damping_ratio", in.mce_spectrum->damping_ratio,
                  "1", "0.05", "B_M brings the damping of the isolators.");
    give("S_M1", s_m1_, "g");
    give("S_DS", spectrum_.s_ds, "g");
    give("S_D1", spectrum_.s_d1, "g");
    give("S_1", in.s_1, "g");
    give("T_L", spectrum_.long_period.si(), "s");
    give("R", in.response_modification, "1");
    give("I_e", in.importance, "1");
  }

  DesignSheet made() {
    const auto spectrum = [&](Time t) {
      return code_.mce_spectrum ? code_.mce_spectrum->acceleration(t).si() / standard_gravity : s_m1_ / t.si();
    };
    solve("D_M", [&](std::size_t i, double d) {
      const double t = period(loops_[i].stiffness(Length{d}).si());
      return standard_gravity * spectrum(Time{t}) * t * t /
             (4.0 * pi * pi * asce_7_damping_coefficient(loops_[i].damping_ratio(Length{d})));
    });
    add_isolators("17.2.8.4");
    add({"k_M", "k_2 + Q/D_M", "17.2.8", followed, k_, "N/m"});
    add({"beta_M", "2 Q (D_M - d_y)/(pi k_M D_M^2)", "17.2.8", followed, beta_});
    add({"T_M", "2 pi sqrt(W/(k_M g))", "17.5.3.2", followed, t_, "s"});
    add({"B_M", "table at beta_M", "table 17.5-1", followed,
         by_bound([&](std::size_t i) { return asce_7_damping_coefficient(beta_[i]); })});
    if (const double most = std::ranges::max(beta_); most > 0.5)
      sheet_.notes.push_back("beta_M " + to_text(most) +
                             " is beyond table 17.5-1, which ends at 0.5: B_M is held at 2.0.");
    if (code_.mce_spectrum) {
      sheet_.notes.push_back("Spectrum: " + code_.mce_spectrum->name + "; " + code_.mce_spectrum->source + ".");
      add({"S_aM", "MCE_R spectrum at T_M", "11.4", recalled,
           by_bound([&](std::size_t i) { return spectrum(Time{t_[i]}); }), "g"});
      add({"D_M", "g S_aM T_M^2/(4 pi^2 B_M)", "17.5.3.1", recalled, d_, "m"}, Governs::largest);
    } else {
      add({"D_M", "g S_M1 T_M/(4 pi^2 B_M)", "17.5.3.1", followed, d_, "m"}, Governs::largest);
    }
    add_torsion();
    add_forces();
    add_procedure();
    add_minima();
    sheet_.notes.emplace_back(
        "Not judged: limits of height, uplift of isolators, site class F, dampers beside the isolators, displacement "
        "by wind, tests of isolators, peer review.");
    return finished();
  }

 private:
  void add_torsion() {
    const double b = in_.shorter_side.si(), d = in_.longer_side.si();
    const double r_i = std::sqrt((b * b + d * d) / 12.0), p_t = std::max(1.0, std::sqrt(mean_square_) / r_i);
    amplification_ = std::max(1.15, 1.0 + y_ * e_ / (p_t * p_t * r_i * r_i));
    add({"e", "actual + 0.05 d", "17.5.3.3", followed, {e_}, "m"});
    add({"r_I", "sqrt((b^2 + d^2)/12)", "17.5.3.3", followed, {r_i}, "m"});
    add({"P_T", "sqrt(sum(x_i^2 + y_i^2)/N)/r_I >= 1", "17.5.3.3", followed, {p_t}});
    add({"D_TM", "D_M (1 + y/P_T^2 12 e/(b^2 + d^2)) >= 1.15 D_M", "17.5.3.3", followed,
         by_bound([&](std::size_t i) { return amplification_ * d_[i]; }), "m"},
        Governs::largest);
  }

  void add_forces() {
    const double slope = code_.abrupt_transition ? 3.5 : 2.5, r = code_.response_modification;
    const std::string exponent = "(W_s/W)^(1 - " + to_text(slope) + " beta_M)";
    if (const double most = std::ranges::max(beta_); slope * most > 1.0)
      sheet_.notes.push_back("beta_M " + to_text(most) + " makes the exponent 1 - " + to_text(slope) +
                             " beta_M negative: it is held at 0, V_st at V_b.");
    const double r_i = std::clamp(0.375 * r, 1.0, 2.0);
    // Beyond beta_M = 1/slope the formula would give the superstructure more than the base.
    const auto above = [&](double force, double beta) {
      return force * std::pow(w_s_ / w_, std::max(0.0, 1.0 - slope * beta));
    };
    v_b_ = by_bound([&](std::size_t i) { return k_[i] * d_[i]; });
    const Values v_st = by_bound([&](std::size_t i) { return above(v_b_[i], beta_[i]); });
    add({"V_b", "k_M D_M", "17.5.4.1", followed, v_b_, "N"}, Governs::largest);
    add({"V_st", "V_b " + exponent, "17.5.4.2", followed, v_st, "N"}, Governs::largest);
    add({"R_I", "3 R/8, at least 1, at most 2", "17.5.4.2", followed, {r_i}});
    add_least_shear(r / code_.importance, exponent, above);
    const Values v_s = by_bound([&](std::size_t i) { return std::max(v_st[i] / r_i, least_shear_); });
    add({"V_s", code_.wind.si() > 0.0 ? "V_st/R_I >= V_s1, V_s2, V_s3" : "V_st/R_I >= V_s1, V_s3", "17.5.4.3", recalled,
         v_s, "N"},
        Governs::largest);
    add({"F_1", "(V_b - V_st)/R_I, base level", "17.5.5", followed,
         by_bound([&](std::size_t i) { return (v_b_[i] - v_st[i]) / r_i; }), "N"},
        Governs::largest);
    const Values k = by_bound([&](std::size_t i) { return 14.0 * beta_[i] * in_.fixed_base_period.si(); });
    add({"k", "14 beta_M T_fb", "17.5.5", followed, k});
    Values sum(3, 0.0);
    const auto moment = [&](const SheetFloor& floor, std::size_t i) {
      return floor.weight.si() * std::pow(floor.height.si(), k[i]);
    };
    for (const SheetFloor& floor : in_.floors)
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += moment(floor, i);
    add_floors("F", {"", "V_s C_v, C_v = w h^k/sum(w h^k)", "17.5.5", followed, {}, "N"}, v_s,
               [&](std::size_t x, std::size_t i) { return moment(in_.floors[x], i) / sum[i]; });
    r_i_ = r_i;
  }

  template <class Above>
  void add_least_shear(double reduction, const std::string& exponent, const Above& above) {
    const bool is_long = t_[2] > spectrum_.long_period.si(), is_near = code_.s_1 >= 0.6;
    const double falling = spectrum_.s_d1 * (is_long ? spectrum_.long_period.si() / t_[2] : 1.0) / (t_[2] * reduction);
    const double c_s =
        std::max({std::min(spectrum_.s_ds / reduction, falling), 0.044 * spectrum_.s_ds * code_.importance, 0.01,
                  is_near ? 0.5 * code_.s_1 / reduction : 0.0});
    const double f_y = std::max(loops_[2].yield_force().si(), 1.5 * loops_[1].yield_force().si());
    const double by_yield = above(f_y, beta_[2]);
    add({"C_s",
         std::string{is_long ? "S_D1 T_L/(T_M^2 R/I_e)" : "S_D1/(T_M R/I_e)"} +
             " <= S_DS/(R/I_e); >= 0.044 S_DS I_e, 0.01" + (is_near ? ", 0.5 S_1/(R/I_e)" : ""),
         "12.8",
         recalled,
         {c_s}})
        .of = Bound::upper;
    add({"V_s1", "C_s W_s", "17.5.4.3", recalled, {c_s * w_s_}, "N"});
    if (code_.wind.si() > 0.0) add({"V_s2", "wind", "17.5.4.3", recalled, {code_.wind.si()}, "N"});
    add({"F_y", "Q + k_2 d_y", "", by_statics, by_bound([&](std::size_t i) { return loops_[i].yield_force().si(); }),
         "N"});
    add({"F_s", "F_y of upper bounds, >= 1.5 times nominal", "17.5.4.3", recalled, {f_y}, "N"}).of = Bound::upper;
    add({"V_s3", "F_s " + exponent, "17.5.4.3", recalled, {by_yield}, "N"}).of = Bound::upper;
    least_shear_ = std::max({c_s * w_s_, code_.wind.si(), by_yield});
  }

  void add_procedure() {
    const Values restoring_force = restoring();
    add_rule({"restoring", "(F(D_M) - F(0.5 D_M))/W >= 0.025", "17.2.4.4", recalled, restoring_force},
             Governs::smallest, 0.025, "too little");
    const double three = 3.0 * in_.fixed_base_period.si();
    std::string reasons;
    const auto require = [&](bool is_met, const std::string& otherwise) {
      if (!is_met) reasons += (reasons.empty() ? "" : ", ") + otherwise;
    };
    const auto [shortest, longest] = std::ranges::minmax(t_);
    const double most_damping = std::ranges::max(beta_);
    const std::string least_period = "3 T_fb " + sheet_value(three, "s");
    require(longest <= 5.0, "T_M " + sheet_value(longest, "s") + " > 5 s");
    require(shortest > three, "T_M " + sheet_value(shortest, "s") + " <= " + least_period);
    require(most_damping <= 0.3, "beta_M " + sheet_value(most_damping, "1") + " > 0.3");
    require(std::ranges::min(restoring_force) >= 0.025, "restoring force");
    judge(add({"static",
               "3 T_fb < T_M <= 5 s, beta_M <= 0.3, restoring force",
               "17.4.1",
               recalled,
               {},
               "1",
               least_period + ", T_M " + bare(shortest, "s") + " to " + sheet_value(longest, "s") + ", beta_M to " +
                   bare(most_damping, "1")}),
          reasons.empty(),
          reasons.empty() ? "static procedure allowed" : "static procedure as minimum only: " + reasons);
  }

  void add_minima() {
    const double t_fb = in_.fixed_base_period.si();
    const Values least = by_bound(
        [&](std::size_t i) { return 0.8 * amplification_ * d_[i] / std::sqrt(1.0 + t_fb * t_fb / (t_[i] * t_[i])); });
    const auto share = [&](double part) { return by_bound([&](std::size_t i) { return part * v_b_[i]; }); };
    add({"D_min", "0.8 D_TM/sqrt(1 + (T_fb/T_M)^2), of histories", "17.6.4", recalled, least, "m"}, Governs::largest);
    add({"V_min", "0.9 V_b, of histories, isolators and below", "17.6.4", recalled, share(0.9), "N"}, Governs::largest);
    const Values corner = of_suite(&SuiteValues::corner_displacement), shear = of_suite(&SuiteValues::base_shear);
    if (in_.suite) {
      if (const Values centre = of_suite(&SuiteValues::displacement); std::ranges::max(centre) > 0.0)
        add({"D_M,dyn", "histories, centre", "17.6", recalled, centre, "m", in_.suite->statistic}, Governs::largest);
      const bool hides = in_.suite->base_shear_has_impacts;
      const std::string of = hides ? "histories, base shear" : "histories, isolators alone";
      compare({"D_TM,dyn", "histories, corner, resultant, >= D_min", "17.6.4", recalled, corner, "m"}, least, false);
      compare({"V_b,dyn", of + ", both directions, >= V_min", "17.6.4", recalled, shear, "N"}, share(0.9), hides);
      compare({"V_above",
               of + (code_.regular ? ", both directions, >= 0.8 V_b, regular" : ", both directions, >= V_b, irregular"),
               "17.6.4", recalled, shear, "N"},
              share(code_.regular ? 0.8 : 1.0), hides);
      Values above = of_suite(&SuiteValues::storey_shear);
      for (double& each : above) each /= r_i_;
      compare({"V_s,dyn", "histories, storey 1, both directions, V_st,dyn/R_I >= V_s1 to V_s3", "17.6.4", recalled,
               above, "N"},
              Values(3, least_shear_), true);
      if (const Values drift = of_suite(&SuiteValues::drift); std::ranges::max(drift) > 0.0)
        add_rule({"drift", "histories, <= 0.020 h", "17.6.4.4", recalled, drift, "1", in_.suite->statistic},
                 Governs::largest, 0.02, "too much");
    }
    const bool is_dynamic = std::ranges::max(corner) > 0.0;
    add_gap("D_TM,dyn", corner, "D_TM", "17.2.5.2", by_bound([&](std::size_t i) {
              // A bound without histories has the displacement of the formula; nominal properties lie between.
              const bool by_histories = is_dynamic && (corner[i] > 0.0 || static_cast<Bound>(i) == Bound::nominal);
              return by_histories ? std::max(corner[i], least[i]) : amplification_ * d_[i];
            }));
  }

  /// A result of histories against its minimum, at the bound with the smallest ratio. Impacts that add to the result
  /// may hide that it is too small: then the rule is not judged as kept.
  void compare(SheetLine line, const Values& least, bool impacts_add) {
    std::optional<std::size_t> worst;
    const Values& found = line.values;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i] > 0.0 && (!worst || found[i] / least[i] < found[*worst] / least[*worst])) worst = i;
    if (!worst) return;
    const std::string touching = touching_records();
    line.numbers = in_.suite->statistic + (touching.empty() ? "" : "; " + touching);
    SheetLine& added = add(std::move(line));
    added.of = static_cast<Bound>(*worst);
    added.governs = true;
    const double ratio = added.value() / least[*worst];
    const bool hidden = ratio >= 1.0 && impacts_add && !touching.empty();
    judge(added, ratio >= 1.0,
          named_value(added) + (ratio >= 1.0 ? " >= " : " < ") + sheet_value(least[*worst], added.unit) +
              (ratio < 1.0 ? ": multiply the results by " + sheet_value(1.0 / ratio, "1")
               : hidden    ? ", not judged: " + touching + ", and the forces of impacts are in it"
                           : ""));
    if (hidden) added.is_kept.reset();
  }

  const Asce7Sheet& code_;
  const Asce7Spectrum spectrum_;
  const double s_m1_ = 1.5 * spectrum_.s_d1;  // of MCE_R
  Values v_b_{};
  double amplification_ = 1.0, least_shear_ = 0.0, r_i_ = 1.0;
};

}  // namespace

Asce7Sheet::operator DesignSheet() const { return Asce7Lines{*this}.made(); }

}  // namespace moat
