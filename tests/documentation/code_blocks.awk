# code_blocks.awk -v folder=FOLDER DOCUMENT.md: writes the C++ blocks of a document as files that compile.
#
#   script_N.cpp    a block with main(); script_NAME.cpp behind a comment "<!-- script: NAME -->"
#   fragments.cpp   all others: inside main(), each in the scope of those before it, so that it may use their names; those
#                   that begin with an #include, a struct or a template stand in front of main()
#
# Fragments may use `script`, `model`, `motion`, `base` and `building` (docs/README.md says so).
# A comment "<!-- given: TEXT -->" in the line before a block gives what the block takes for granted.
# "<!-- given at namespace scope: TEXT | TEXT -->" puts a block between two texts in front of main().

BEGIN {
  usual = "#include <moat.hpp>\n\n#include <algorithm>\n#include <cmath>\n#include <filesystem>\n#include <iostream>\n\n" \
    "using namespace moat;\nusing namespace moat::units;\n"
  usual_names = "Script script{argc, argv, \"document\"};\nModel model;\nGroundMotion motion = near_fault_pulse();\n" \
    "const NodeId base = add(model, Node{.name = \"base\", .mass = 1 * tonne});\n" \
    "Building building = add(model, ShearBuilding{.name = \"tower\", .storeys = 3, .floor_mass = 1 * tonne,\n" \
    ".storey_stiffness = 1 * MN / m});\n"
}

function finish_block(    line) {
  line = "#line " first " \"" FILENAME "\"\n"
  if (block ~ /int main\(/) {
    ++scripts
    file = folder "/script_" (name ? name : scripts) ".cpp"
    printf "%s%s\n%s%s", block ~ /#include <moat/ ? "" : usual, given, line, block >file
    close(file)
  } else if (namespace_scope) {
    split(given, around, "|")
    top = top around[1] "\n" line block around[2] "\n"
  } else if (block ~ /^(#include|struct|class|template)/) {
    top = top line block
  } else {
    body = body "{\n" given "\n" line block
    ++scopes
  }
  given = ""
  name = ""
  namespace_scope = 0
}

/^<!-- given: .* -->$/ {
  given = substr($0, 13, length($0) - 16)
  next
}
/^<!-- given at namespace scope: .* -->$/ {
  given = substr($0, 32, length($0) - 35)
  namespace_scope = 1
  next
}
/^<!-- script: .* -->$/ {
  name = $3
  next
}
/^```/ && inside {
  inside = 0
  finish_block()
  next
}
/^```cpp$/ && !recipe {
  inside = 1
  block = ""
  first = FNR + 1
  next
}
inside {
  block = block $0 "\n"
}
{ recipe = /^<!-- recipe:/ }

END {
  file = folder "/fragments.cpp"
  printf "%s%sint main(int argc, char** argv) {\n%s%s", usual, top, usual_names, body >file
  for (i = 0; i < scopes; ++i) printf "}\n" >file
  print "}" >file
  printf "%d scripts, %d fragments\n", scripts, scopes
}
