// Table 2 of Zhao, Liu & Li (2017): peaks of the five-storey building for five impact laws.
//
// Gebze record at 0.4 g, walls at 10 cm. Asserted: the plain reading against peaks that an independent program
// computed, one impact, the order within the families of laws, displacements within 8 % of the paper's. Everything
// else stands beside the paper's number with its ratio.
#include <moat.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "paper/exhibit.hpp"
#include "paper/paper_building.hpp"
#include "paper/printed_table.hpp"
#include "paper/records.hpp"

namespace moat::paper {
namespace {

using namespace units;

const TransientOptions converged{.tolerance = 1e-5, .steps_per_contact = 128};

// ------------------------------------------------------------------------------------------------ laws

/// One set of contact stiffnesses; the laws of the paper do not pull where it says nothing, but its equations do.
struct ContactStiffness {
  Stiffness linear = linear_impact_stiffness;
  HertzStiffness hertz = hertz_impact_stiffness;
};

struct PaperLaw {
  std::string reference;  ///< name in reference_peaks.csv
  std::string printed;    ///< column of table2.csv; empty if the paper has none
  std::string label;
  std::function<void(Model&, NodeId base, const ContactStiffness&)> add_walls;
};

template <class MakeLaw>
PaperLaw paper_law(std::string reference, std::string printed, std::string label, MakeLaw make) {
  return {std::move(reference), std::move(printed), std::move(label),
          [make](Model& model, NodeId base, const ContactStiffness& stiffness) {
            add(model, Moat{.around = base, .clearance = paper_gap, .law = make(stiffness)});
          }};
}

const std::vector<PaperLaw> laws{
    paper_law("linear_elastic", "linear_elastic", "linear elastic",
              [](const ContactStiffness& k) { return LinearElastic{.stiffness = k.linear}; }),
    paper_law("hertz", "hertz", "Hertz", [](const ContactStiffness& k) { return Hertz{.stiffness = k.hertz}; }),
    paper_law("kelvin", "kelvin", "Kelvin",
              [](const ContactStiffness& k) {
                return KelvinByDampingRatio{.stiffness = k.linear, .damping_ratio = 0.14, .may_pull = true};
              }),
    paper_law("hertz_damp", "hertz_damp", "Hertz-damp",
              [](const ContactStiffness& k) {
                return HertzDamp{.stiffness = k.hertz, .restitution = restitution, .may_pull = true};
              }),
    paper_law("modified_hertz_damp_tabulated", "modified_hertz_damp", "modified Hertz-damp",
              [](const ContactStiffness& k) {
                return ModifiedHertzDamp{.stiffness = k.hertz, .restitution = restitution, .may_pull = true};
              }),
    paper_law("modified_hertz_damp_printed_approach_only", "", "modified Hertz-damp as printed, on approach",
              [](const ContactStiffness& k) {
                return ModifiedHertzDampPrinted{.stiffness = k.hertz, .restitution = restitution};
              }),
    paper_law("nonlinear_viscoelastic", "", "non-linear viscoelastic (Jankowski)",
              [](const ContactStiffness& k) {
                return NonlinearViscoelastic{.stiffness = k.hertz, .restitution = restitution};
              }),
    paper_law("ye_2009", "", "Ye 2009", [](const ContactStiffness& k) {
      return Ye2009{.stiffness = k.hertz, .restitution = restitution, .may_pull = true};
    })};
constexpr std::size_t printed_laws = 5;

std::vector<std::string> law_labels(std::size_t count) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < count; ++i) labels.push_back(laws[i].label);
  return labels;
}

// ------------------------------------------------------------------------------------------ references

struct ReferenceColumn {
  std::string name, quantity, where;
  double unit;
};

const std::vector<ReferenceColumn> reference_columns{
    {"base_displacement_cm", "displacement", "base", 0.01},
    {"top_displacement_cm", "displacement", "floor 5", 0.01},
    {"base_acceleration_m_s2", "absolute_acceleration", "base", 1.0},
    {"top_acceleration_m_s2", "absolute_acceleration", "floor 5", 1.0},
    {"impact_force_kN", "impact_force", "moat", 1e3},
    {"isolator_force_kN", "isolator_force", "bearings", 1e3},
    {"first_storey_shear_kN", "storey_shear", "storey 1", 1e3},
    {"total_base_shear_kN", "total_base_shear", "base", 1e3},
    {"impacts", "impacts", "", 1.0},
    {"sum_of_floor_inertia_maxima_kN", "sum_of_floor_inertia_maxima", "base", 1e3}};

constexpr double reference_bound = 5e-4;

void compare_with_references(Exhibit& exhibit) {
  const std::vector<PrintedRow> rows = printed_table("reference_peaks.csv");
  ShownTable shown{
      "Plain reading beside peaks computed by an independent program (Runge-Kutta, every change located): "
      "largest relative difference over " +
          std::to_string(reference_columns.size()) + " peaks and the three records of the reference",
      {"law", "largest difference [%]", "in"},
      {}};
  std::vector<std::string> records;  // without KBU000, for which there is no reference
  std::vector<GroundMotion> motions;
  for (const PaperRecord& record : paper_records) {
    const std::string name = std::filesystem::path{record.file}.stem().string();
    if (std::ranges::none_of(rows, [&](const PrintedRow& row) { return row.at("record") == name; })) continue;
    records.push_back(name);
    motions.push_back(read_unscaled(record).scaled_to_pga(paper_pga));
  }
  const StudyCases axes{StudyAxis::of_names("law", law_labels(laws.size())), StudyAxis::of_names("record", records)};
  const StudyResult result = run_study(axes,
                                       [&](const StudyCase& each) {
                                         StudyModel study{Model{}, motions[each.position("record")]};
                                         const Building nodes = add(study.model, PaperBuilding{});
                                         laws[each.position("law")].add_walls(study.model, nodes.base, {});
                                         return study;
                                       },
                                       {.transient = converged, .progress = ProgressBar{"Table 2, references"}});

  for (std::size_t law = 0; law < laws.size(); ++law) {
    double largest = 0.0;
    std::string in;
    for (const PrintedRow& row : rows) {
      if (row.at("case") != laws[law].reference) continue;
      const auto record = static_cast<std::size_t>(std::ranges::find(records, row.at("record")) - records.begin());
      for (const ReferenceColumn& column : reference_columns) {
        const double expected = number(row, column.name) * column.unit;
        const double computed = result.values(column.quantity, column.where, {{"law", law}, {"record", record}}).at(0);
        const double difference = std::abs(computed / expected - 1.0);
        exhibit.assert_that(difference <= reference_bound, laws[law].label + ", " + row.at("record") + ", " +
                                                               column.name + ": " + to_text(computed / column.unit) +
                                                               " within 0.05 % of " + to_text(expected / column.unit));
        if (difference < largest) continue;
        largest = difference;
        in = column.name + ", " + row.at("record");
      }
    }
    shown.rows.push_back({laws[law].label, to_fixed(100 * largest, 4), in});
  }
  exhibit.documented_table(shown);
}

// -------------------------------------------------------------------------------------------- readings

/// One way to read the paper's numbers.
struct Reading {
  std::string name;
  PaperBuilding building{};
  ContactStiffness contact{};
  GroundMotion motion;
};

/// Peaks of the printed laws, for each of them.
std::vector<StudyRecord> peaks_of_laws(const Reading& reading) {
  std::vector<StudyRecord> peaks;
  for (std::size_t law = 0; law < printed_laws; ++law) {
    Model model;
    const Building nodes = add(model, reading.building);
    laws[law].add_walls(model, nodes.base, reading.contact);
    peaks.push_back(peaks_of(model, reading.motion, converged));
  }
  return peaks;
}

struct PrintedResponse {
  std::string name, label, quantity, where;
  double unit;
  int decimals;

  [[nodiscard]] double in(const StudyRecord& peaks) const { return value_of(peaks, quantity, where) / unit; }
};

const std::vector<PrintedResponse> printed_responses{
    {"base_floor_displacement", "base displacement [cm]", "displacement", "base", 0.01, 2},
    {"top_floor_displacement", "top displacement [cm]", "displacement", "floor 5", 0.01, 2},
    {"base_floor_acceleration", "base acceleration [m/s²]", "absolute_acceleration", "base", 1.0, 2},
    {"top_floor_acceleration", "top acceleration [m/s²]", "absolute_acceleration", "floor 5", 1.0, 2}};

PrintedResponse shear(const std::string& label, const std::string& quantity, const std::string& where) {
  return {"base_shear_force", label + " / paper's base shear [kN]", quantity, where, 1e3, 0};
}
/// The paper does not say which force its base shear is.
const std::vector<PrintedResponse> printed_shears{
    shear("isolator force", "isolator_force", "bearings"),
    shear("total base shear (isolator + impact)", "total_base_shear", "base"),
    shear("first-storey shear", "storey_shear", "storey 1"),
    shear("sum of floor inertia maxima", "sum_of_floor_inertia_maxima", "base")};

std::map<std::string, PrintedRow> printed_rows() {
  std::map<std::string, PrintedRow> rows;
  for (const PrintedRow& row : printed_table("table2.csv")) rows[row.at("response")] = row;
  return rows;
}

/// Returns all numbers of Table 2 for one reading, each "computed / printed = ratio", and counts them as reported.
ShownTable reading_table(Exhibit& exhibit, const std::string& caption, const std::vector<StudyRecord>& peaks) {
  const std::map<std::string, PrintedRow> printed = printed_rows();
  ShownTable shown{caption, {"moat / paper = ratio"}, {}};
  for (std::size_t law = 0; law < printed_laws; ++law) shown.header.push_back(laws[law].label);
  for (const auto* responses : {&printed_responses, &printed_shears})
    for (const PrintedResponse& each : *responses) {
      std::vector<std::string> cells{each.label};
      for (std::size_t law = 0; law < printed_laws; ++law) {
        const double computed = each.in(peaks[law]), paper = number(printed.at(each.name), laws[law].printed);
        cells.push_back(to_fixed(computed, each.decimals) + " / " + to_fixed(paper, each.decimals) + " = " +
                        ratio(computed, paper));
      }
      exhibit.report(printed_laws);
      shown.rows.push_back(cells);
    }
  std::vector<std::string> impacts{"impacts"};
  for (const StudyRecord& each : peaks) impacts.push_back(to_fixed(value_of(each, "impacts", ""), 0));
  shown.rows.push_back(impacts);
  return shown;
}

/// How many of the 25 printed numbers agree, with the base shear read as the sum of floor inertia maxima.
struct Agreement {
  int within_five_percent = 0;
  double root_mean_square = 0.0;
};

Agreement agreement_of(const std::vector<StudyRecord>& peaks) {
  const std::map<std::string, PrintedRow> printed = printed_rows();
  std::vector<PrintedResponse> responses = printed_responses;
  responses.push_back(printed_shears.back());
  Agreement agreement;
  for (std::size_t law = 0; law < printed_laws; ++law)
    for (const PrintedResponse& each : responses) {
      const double difference = each.in(peaks[law]) / number(printed.at(each.name), laws[law].printed) - 1.0;
      agreement.within_five_percent += std::abs(difference) <= 0.05 ? 1 : 0;
      agreement.root_mean_square += difference * difference;
    }
  agreement.root_mean_square =
      std::sqrt(agreement.root_mean_square / static_cast<double>(printed_laws * responses.size()));
  return agreement;
}

/// Readings C and E: undamped storeys, viscous damping of the isolator, harder contact.
Reading found_afterwards(std::string name, Stiffness post_yield_stiffness, GroundMotion motion) {
  PaperBuilding building{.damping_ratio = 0.0, .post_yield_stiffness = post_yield_stiffness};
  building.isolator_damping = 7.67e5 * N / (m / s);
  return {std::move(name), building, {.linear = 2.95e9 * N / m, .hertz = 2.95e10 * N / m_3_2}, std::move(motion)};
}

// --------------------------------------------------------------------------------------------- checks

void assert_what_holds(Exhibit& exhibit, const std::vector<StudyRecord>& peaks) {
  const std::map<std::string, PrintedRow> printed = printed_rows();
  for (std::size_t law = 0; law < printed_laws; ++law) {
    exhibit.assert_that(value_of(peaks[law], "impacts", "") == 1.0, laws[law].label + ", Gebze: one impact");
    for (const PrintedResponse& each : printed_responses) {
      if (each.quantity != "displacement") continue;
      const double computed = each.in(peaks[law]), paper = number(printed.at(each.name), laws[law].printed);
      exhibit.assert_that(std::abs(computed / paper - 1.0) <= 0.08,
                          laws[law].label + ", " + each.label + ": " + to_fixed(computed, 2) +
                              " within 8 % of the paper's " + to_fixed(paper, 2));
    }
  }
  enum Law { linear, hertz, kelvin, hertz_damp, modified };
  for (const char* where : {"base", "floor 5"}) {
    const auto displacement = [&](Law law) { return value_of(peaks[law], "displacement", where); };
    exhibit.assert_that(displacement(kelvin) < displacement(linear),
                        std::string{"displacement of "} + where + ": Kelvin < linear elastic");
    exhibit.assert_that(
        displacement(modified) < displacement(hertz_damp) && displacement(hertz_damp) < displacement(hertz),
        std::string{"displacement of "} + where + ": modified Hertz-damp < Hertz-damp < Hertz");
  }
}

void find_claims(Exhibit& exhibit, const std::vector<StudyRecord>& peaks) {
  std::string spreads;
  double largest = 0.0;
  for (const PrintedResponse& each : printed_responses) {
    double low = 1e300, high = 0.0;
    for (const StudyRecord& law : peaks) {
      low = std::min(low, value_of(law, each.quantity, each.where));
      high = std::max(high, value_of(law, each.quantity, each.where));
    }
    largest = std::max(largest, high / low - 1.0);
    spreads += (spreads.empty() ? "" : ", ") + each.label.substr(0, each.label.find(" [")) + " " +
               to_fixed(100 * (high / low - 1.0), 0) + " %";
  }
  exhibit.finding({"4.2, Table 2", "The peaks for the five impact laws differ by less than 10 %",
                   "largest over smallest peak below 1.10 for every response", spreads,
                   largest <= 0.10 ? Verdict::holds : Verdict::fails});
  const auto base = [&](std::size_t law) { return value_of(peaks[law], "displacement", "base"); };
  std::vector<std::size_t> sorted{0, 1, 2, 3, 4};
  const bool descending = std::ranges::is_sorted(sorted, std::greater{}, base);
  std::ranges::sort(sorted, std::greater{}, base);
  std::string found;
  for (const std::size_t law : sorted) found += (found.empty() ? "" : " > ") + laws[law].label;
  exhibit.finding({"4.2, Table 2", "Base displacement: linear > Hertz > Kelvin > Hertz-damp > modified Hertz-damp",
                   "the same order in the plain reading", found + "; within the linear and the Hertz family as printed",
                   descending ? Verdict::holds : Verdict::partly, found});
}

void explain(Exhibit& exhibit) {
  const std::map<std::string, PrintedRow> printed = printed_rows();
  const auto indentation = [&](const char* law) {
    return number(printed.at("base_floor_displacement"), law) - paper_gap / cm;
  };
  const auto acceleration = [&](const char* law) { return number(printed.at("base_floor_acceleration"), law); };
  // Elastic impacts of one energy E: F = 2 E/d for a linear spring, F = 2.5 E/d for one with exponent 3/2.
  const double demanded = 1.25 * indentation("linear_elastic") / indentation("hertz");
  const double given = acceleration("hertz") / acceleration("linear_elastic");
  exhibit.text(
      "Table 2 does not follow from the numbers that the paper states. Displacements come within 8 % of it, but 10 of "
      "their 11 cm are the gap. Accelerations stay 60 to 80 % below; other definitions of damping and of acceleration, "
      "tried in a search that is not part of this benchmark, did not change that. The paper's base shear of 48 MN is "
      "near "
      "none of isolator force, total base shear or first-storey shear; only the sum over floors of mass times peak "
      "absolute acceleration reaches that size, and only with the paper's own accelerations. The table also "
      "contradicts "
      "itself: for one elastic impact, equal approach energy demands contact forces of Hertz and linear elastic model "
      "in "
      "the ratio 1.25 d_linear/d_Hertz = " +
      to_fixed(demanded, 2) + ", but its base accelerations have the ratio " + to_fixed(given, 2) + ".");
}

}  // namespace

void show_table2(Exhibit& exhibit) {
  const GroundMotion gebze_record = scaled_records()[gebze];
  const std::vector<StudyRecord> plain = peaks_of_laws({.name = "plain", .motion = gebze_record});
  assert_what_holds(exhibit, plain);
  exhibit.documented_table(
      reading_table(exhibit, "Plain reading, GBZ000 as it is in the NGA-West2 database, scaled to 0.4 g", plain));
  explain(exhibit);
  compare_with_references(exhibit);

  const GroundMotion reconstructed = reconstructed_gebze().scaled_to_pga(paper_pga);
  const std::vector<StudyRecord> with_reconstructed = peaks_of_laws({.name = "plain", .motion = reconstructed});
  exhibit.table(reading_table(exhibit,
                              "Plain reading, GBZ000 reconstructed: causal 5th-order Butterworth high-pass at 0.068 Hz",
                              with_reconstructed));

  const Reading reading_c =
      found_afterwards("C: reconstructed record, k_post = 1.93e7 N/m", 19.3 * MN / m, reconstructed);
  const Reading reading_e = found_afterwards("E: GBZ000, k_post = 1.93e6 N/m as printed", 1.93 * MN / m, gebze_record);
  const std::vector<StudyRecord> peaks_c = peaks_of_laws(reading_c), peaks_e = peaks_of_laws(reading_e);
  exhibit.text(
      "Readings C and E were found after the fact, by searching some 56,000 combinations (not part of this benchmark) "
      "for "
      "those that come nearest to Table 2. They contradict the printed contact stiffnesses and the printed damping: "
      "undamped storeys, a dashpot of "
      "7.67e5 N s/m beside the bearings (5 % of critical at 2.5 s), k_l = k_k = 2.95e9 N/m, k_h = 2.95e10 N/m^1.5. "
      "They are "
      "no evidence that the paper computed this; none of the combinations gives all 25 numbers, and with the printed "
      "contact stiffnesses at most 8 of 25 come within 5 %. A slip of one exponent in the contact stiffness is likely, "
      "not proven.");
  exhibit.table(reading_table(exhibit, "Found after the fact, " + reading_c.name, peaks_c));
  exhibit.table(reading_table(exhibit, "Found after the fact, " + reading_e.name, peaks_e));

  ShownTable summary{
      "How many of the 25 numbers of Table 2 come within 5 % (base shear as sum of floor inertia maxima)",
      {"reading", "within 5 %", "root mean square of the differences [%]"},
      {}};
  const auto summarise = [&](const std::string& name, const std::vector<StudyRecord>& peaks) {
    const Agreement agreement = agreement_of(peaks);
    summary.rows.push_back({name, std::to_string(agreement.within_five_percent) + " of 25",
                            to_fixed(100 * agreement.root_mean_square, 1)});
    exhibit.report(2);
  };
  summarise("plain, GBZ000", plain);
  summarise("plain, reconstructed record", with_reconstructed);
  summarise("found after the fact, " + reading_c.name, peaks_c);
  summarise("found after the fact, " + reading_e.name, peaks_e);
  exhibit.table(summary);
  find_claims(exhibit, plain);
}

}  // namespace moat::paper
