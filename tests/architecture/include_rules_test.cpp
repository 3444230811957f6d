#include "include_rules.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "in_folder.hpp"

namespace moat::architecture {
namespace {

template <class... Text>
std::vector<std::string> sentences(const Text&... text) {
  return {std::string{text}...};
}

/// One file in every folder that may include something, including all it may.
std::vector<SourceFile> tree_in_order() {
  return {
      {"src/base/error.hpp", "#include <string>\n"},
      {"src/model/model.hpp", "#include \"base/error.hpp\"\n"},
      {"src/solvers/newton.cpp", "#include <NOX.H>\n#include \"base/error.hpp\"\n"},
      {"src/solvers/factorisation.cpp", "#include <klu.h>\n"},
      {"src/motions/motion.hpp", "#include \"base/error.hpp\"\n"},
      {"src/output/vtk/vtk_writers.cpp",
       "#include <vtkNew.h>\n#include \"model/model.hpp\"\n#include \"motions/motion.hpp\"\n"},
      {"src/output/files/table.hpp", "#include \"base/error.hpp\"\n"},
      {"src/solvers/newton.hpp", ""},
      {"materials/hertz.hpp", "#include \"base/error.hpp\"\n"},
      {"elements/contact/gap.hpp", "#include \"materials/hertz.hpp\"\n#include \"model/model.hpp\"\n"},
      {"structures/moat.hpp", "#include \"elements/contact/gap.hpp\"\n#include \"materials/hertz.hpp\"\n"},
      {"src/study/file/store.cpp", "#include <sqlite3.h>\n#include \"output/files/table.hpp\"\n"},
      {"analyses/time_history/transient.hpp",
       "#include \"model/model.hpp\"\n#include \"output/files/table.hpp\"\n#include \"motions/motion.hpp\"\n"
       "#include \"solvers/newton.hpp\"\n"},
      {"src/app/script/script.hpp",
       "#include \"analyses/time_history/transient.hpp\"\n#include \"structures/moat.hpp\"\n"},
      {"src/moat.hpp", "#include \"app/script/script.hpp\"\n"},
  };
}

std::vector<std::string> broken_with(const SourceFile& one_more) {
  std::vector<SourceFile> tree = tree_in_order();
  tree.push_back(one_more);
  return broken_rules(tree);
}

TEST(IncludeRules, AcceptTheArrowsOfTheDesign) { EXPECT_EQ(broken_rules(tree_in_order()), sentences()); }

TEST(IncludeRules, RefuseOneFileMore) {
  struct Row {
    std::string path, text;
    std::vector<std::string> broken;  // behind the path
  };
  const std::string knows_model = "includes src/model/model.hpp, but materials must not know src/model";
  const std::vector<Row> rows{
      // Arrows against the design, in any spelling, and the one header for scripts inside the library.
      {"src/base/bad.hpp",
       "\n#include \"model/model.hpp\"\n",
       {":2 includes src/model/model.hpp, but src/base must not know src/model"}},
      {"analyses/bad.cpp",
       "#include \"elements/contact/gap.hpp\"\n",
       {":1 includes elements/contact/gap.hpp, but analyses must not know elements"}},
      {"materials/bad.hpp", "  #  include <model/model.hpp>\n", {":1 " + knows_model}},
      {"materials/bad.hpp", "#include \"../src/model/model.hpp\"\n", {":1 " + knows_model}},
      {"materials/bad.hpp", "#include \"src/model/model.hpp\"\n", {":1 " + knows_model}},
      {"elements/bad.cpp",
       "#include \"moat.hpp\"\n",
       {":1 includes src/moat.hpp, but elements must not know src/app or src/moat.hpp"}},
      // Libraries in all files but one.
      {"analyses/bad.cpp",
       "#include <NOX.H>\n#include <Teuchos_RCP.hpp>\n#include <klu.h>\n",
       {":1 includes NOX.H, which belongs in src/solvers/newton.cpp",
        ":2 includes Teuchos_RCP.hpp, which belongs in src/solvers/newton.cpp",
        ":3 includes klu.h, which belongs in src/solvers/factorisation.cpp"}},
      {"src/output/bad.cpp",
       "#include <vtkNew.h>\n#include <SMP/Common/vtkSMPToolsAPI.h>\n",
       {":1 includes vtkNew.h, which belongs in src/output/vtk/vtk_writers.cpp",
        ":2 includes SMP/Common/vtkSMPToolsAPI.h, which belongs in src/output/vtk/vtk_writers.cpp"}},
      {"src/solvers/bad.cpp",
       "#include <cholmod.h>\n#include <Eigen/UmfPackSupport>\n",
       {":1 includes cholmod.h, which is under the GPL", ":2 includes Eigen/UmfPackSupport, which is under the GPL"}},
      // Names that are no file, and folders without a rule.
      {"src/base/bad.cpp", "#include \"base/eror.hpp\"\n", {":1 includes \"base/eror.hpp\", no file of the project"}},
      {"src/helpers/bad.hpp", "", {" lies in a folder that has no rule for its includes"}}};
  for (const auto& [path, text, broken] : rows) {
    std::vector<std::string> expected;
    for (const std::string& sentence : broken) expected.push_back(path + sentence);
    EXPECT_EQ(broken_with({path, text}), expected);
  }
}

TEST(IncludeRules, RefuseACircle) {
  EXPECT_EQ(broken_rules({{"materials/a.hpp", "#include \"materials/b.hpp\"\n"},
                          {"materials/b.hpp", "#include \"c.hpp\"\n"},
                          {"materials/c.hpp", "#include \"a.hpp\"\n"}}),
            sentences("files include each other: materials/a.hpp -> materials/b.hpp -> materials/c.hpp -> "
                      "materials/a.hpp"));
}

TEST(IncludeRules, RefuseHeavyLibrariesInHeaders) {
  for (const std::string name :
       {"NOX.H", "NOX_Abstract_Group.H", "Teuchos_RCP.hpp", "klu.h", "camd.h", "trilinos/NOX.H", "suitesparse/klu.h",
        "vtk-9.1/vtkSmartPointer.h", "sqlite3.h", "mpi.h"})
    EXPECT_EQ(broken_with({"src/output/bad.hpp", "#include <" + name + ">\n"}),
              sentences("src/output/bad.hpp:1 includes " + name + " in a header; it belongs in a .cpp file"));
}

using IncludeRulesOnDisk = testing::InFolder;

TEST_F(IncludeRulesOnDisk, AreRead) {
  for (const char* root : {"src/base", "materials", "elements", "structures", "analyses"}) {
    std::filesystem::create_directories(folder / root);
  }
  std::ofstream{folder / "src/base/bad.hpp"} << "#include \"materials/law.hpp\"\n";
  std::ofstream{folder / "materials/law.hpp"} << "#pragma once\n";
  EXPECT_EQ(broken_rules(read_sources(folder)),
            sentences("src/base/bad.hpp:1 includes materials/law.hpp, but src/base must not know materials"));
}

TEST(Moat, KeepsTheIncludeRules) {
  const std::vector<SourceFile> sources = read_sources(MOAT_SOURCE_DIR);
  ASSERT_GT(sources.size(), 8U) << "the checkout was not read";
  EXPECT_EQ(broken_rules(sources), sentences());
}

}  // namespace
}  // namespace moat::architecture
