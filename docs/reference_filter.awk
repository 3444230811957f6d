# For Doxygen, which reads every header through this filter. Lines keep their numbers.
#
# Members that every law has (materials/response.hpp) get their sentence here, once for all laws. A comment on a list of
# members, "double low, high;", becomes that of each.

function note(pattern, sentence) {
  if ($0 ~ pattern) $0 = "/** " sentence " */ " $0
}

function notes_of_all() {
  note("^extern template", "Compiled in the library.")
  if ($0 !~ /\/\/\//) note("[)] (const )?(noexcept )?override[ ;]", "As the function of the base class says.")
  note("^  [A-Za-z]+[(][A-Za-z]+&&[)] noexcept", "Moves.")
  note("^  [A-Za-z]+& operator=[(][A-Za-z]+&&[)] noexcept", "Moves.")
}

function notes_of_integrators() {
  note("^  static constexpr std::string_view name =", "Of the option `--integrator`.")
  note("std::optional<StepScheme> scheme\\(\\)", "The numbers of an implicit step; empty where there are none.")
  note("^  void check\\(const Check", "Throws InputError for a number outside its range.")
  note("std::string description\\(\\)", "Name and numbers, for reports.")
}

function notes_of_laws() {
  note("^struct [A-Za-z0-9]*Factor \\{", "The damping factor z(e) of the law below.")
  note("^  static constexpr std::string_view name =", "Of the law, in reports and options.")
  note("^  static constexpr std::string_view alias =", "Another name of the option.")
  note("^  static constexpr std::string_view formula =", "Of the law, for tables.")
  note("^  static constexpr std::string_view assumption =", "Its limits, for reports.")
  note("^  static constexpr bool linear_within_regimes =", "The force is linear from one change of regime to the next.")
  note("^  static constexpr bool divides_by_restitution =", "Whether the damping grows as 1/e; e >= 0.001 then.")
  note("^  static constexpr bool is_damper =", "It carries no static force.")
  note("^  static constexpr (std::array.*|auto) quantities", "Reported besides deformation and force.")
  note("double weight_work\\(", "Work of a changing weight between two states, J.")
  note("double weight_power\\(", "Power of a changing weight, W.")
  note("double weight_lever\\(", "Lever of a changing weight between two states, m.")
  note("^  static constexpr double time_of_rate", "Constants of the search for a change of regime.")
  note("^  static [A-Za-z]+ typical\\(\\)", "Ordinary parameters, for tests and tables.")
  note("^  static double of\\(double e\\)", "At a restitution 0 < e <= 1.")
  note("^  (using State =|struct State )", "Remembered from step to step.")
  note("^  void check\\(const Check", "Throws InputError for a parameter outside its range.")
  note("std::vector<Parameter> parameters\\(\\)", "Names, values and units of the parameters.")
  note("Response evaluate\\(", "Force and tangents at a deformation and a rate; a pure function.")
  note("double force_rate\\(", "Rate of the force at a given state, N/s.")
  note("double stored_energy\\(", "Recoverable energy, J.")
  note("double dissipation_rate\\(", "Dissipated power, W, >= 0.")
  note("double dissipated_energy\\(", "Dissipated from one committed state to another, J.")
  note("double (linear|initial)_stiffness\\(", "N/m")
  note("double regime_margin\\(", "Distance to the next change of regime, m.")
  note("ReportedValue quantity\\(std::size_t", "One of `quantities`, in its SI unit, and its rate.")
  note("^  State next_regime\\(", "The state after the change of regime.")
  note(" carrying\\(Force", "The same law with this weight on it, > 0 N.")
  note("FrictionCoefficient at\\(double", "At a speed, m/s, under a normal force, N.")
}

# The declarators of a list, parted at commas outside brackets and texts.
function split_list(text, parts,    i, c, depth, quoted, count) {
  count = 1
  parts[1] = ""
  for (i = 1; i <= length(text); ++i) {
    c = substr(text, i, 1)
    if (c == "\"") quoted = !quoted
    if (!quoted && index("([{<", c)) ++depth
    if (!quoted && index(")]}>", c)) --depth
    if (c == "," && depth == 0 && !quoted) parts[++count] = ""
    else parts[count] = parts[count] c
  }
  return count
}

function expand_list(    line, behind, count, parts, type, i) {
  line = $0
  behind = ""
  if (match(line, / *\/\/\/< .*$/)) {
    behind = line
    sub(/^.*\/\/\/< */, "", behind)
    behind = " /**< " behind " */"
    line = substr(line, 1, RSTART - 1)
  }
  sub(/ *$/, "", line)
  sub(/;$/, "", line)
  count = split_list(line, parts)
  if (count < 2) return
  type = parts[1]
  sub(/( = .*|[{].*)$/, "", type)
  sub(/[*]?[A-Za-z_0-9]+$/, "", type)
  line = parts[1] ";" behind
  for (i = 2; i <= count; ++i) {
    sub(/^ */, "", parts[i])
    line = line (behind == "" && above != "" ? " /** " above " */ " : " ") type parts[i] ";" behind
  }
  $0 = line
}

{
  original = $0
  notes_of_all()
  if (FILENAME ~ /analyses\//) notes_of_integrators()
  if (FILENAME ~ /materials\//) notes_of_laws()
  if ($0 ~ /^ *(static |inline |constexpr |const )*[A-Za-z_][A-Za-z_0-9:]*(<[^(]*>)? [*]?[a-zA-Z_0-9]+( = [^;()]*| *[{][^;]*)?, [^()]*;( *\/\/\/<.*)?$/ && $0 !~ /^ *(using|return|friend|template)/)
    expand_list()
  print
  if (original ~ /^ *\/\/\/ /) {
    sub(/^ *\/\/\/ /, "", original)
    above = above (above == "" ? "" : " ") original
  } else {
    above = ""
  }
}
