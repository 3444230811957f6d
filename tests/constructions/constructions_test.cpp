// Every construction of the table, and the table itself.
#include "constructions.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "in_folder.hpp"

namespace moat::constructions {
namespace {

namespace fs = std::filesystem;

Constructions table() {
  Constructions all;
  for (const auto family : {laws, laws_in_plan, bearings, contacts, contact_estimates, elements, buildings,
                            buildings_in_plan, neighbours_and_moats, superstructures, frames, motions, spectra,
                            analyses, studies, charts, sheets, script_options}) {
    const Constructions rows = family();
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
}

std::string message_of(const Construction& row) {
  try {
    row.build();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Constructions, GiveTheRightAnswerOrAMessageWithItsRemedy) {
  for (const Construction& row : table()) {
    SCOPED_TRACE(row.name);
    const std::string message = message_of(row);
    if (row.words.empty()) {
      EXPECT_EQ(message, "");
    }
    std::size_t behind = 0;
    for (const std::string& words : row.words) {
      const std::size_t at = message.find(words, behind);
      if (at == std::string::npos) {
        ADD_FAILURE() << "\"" << words << "\" is missing from character " << behind << " on in \"" << message << "\"";
        break;
      }
      behind = at + words.size();
    }
  }
}

TEST(Constructions, HaveObjectParameterValueRangeAndRemedy) {
  std::set<std::string> names;
  std::map<std::string, std::string> kinds;
  for (const Construction& row : table()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name << " stands twice in the table";
    if (row.words.empty()) continue;
    ASSERT_EQ(row.words.size(), 5U) << row.name;
    for (const std::string& words : row.words) EXPECT_NE(words, "") << row.name;
    // Two rows that differ in a number only say the same in words.
    const std::string kind = std::regex_replace(row.words[0] + "|" + row.words[1] + "|" + row.words[3] + row.words[4],
                                                std::regex{"[-+0-9.]+"}, "#");
    const auto [other, is_new] = kinds.try_emplace(kind, row.name);
    EXPECT_TRUE(is_new) << row.name << " and " << other->second << " differ in a number only";
  }
  EXPECT_NE(testing::read_file(MOAT_SOURCE_DIR "/docs/reliability.md")
                .find("\n" + std::to_string(names.size()) + " constructions are wrong or extreme"),
            std::string::npos)
      << "docs/reliability.md counts other than " << names.size() << " constructions";
}

// The headers that a script sees, from src/moat.hpp on.
std::set<fs::path> public_headers() {
  const fs::path root = MOAT_SOURCE_DIR;
  std::set<fs::path> seen;
  std::vector<fs::path> open{root / "src/moat.hpp"};
  const std::regex directive{"#include \"([^\"]+)\""};
  while (!open.empty()) {
    const fs::path header = open.back();
    open.pop_back();
    if (!seen.insert(header).second) continue;
    const std::string text = testing::read_file(header);
    for (std::sregex_iterator each{text.begin(), text.end(), directive}, end; each != end; ++each)
      for (const fs::path& folder : {header.parent_path(), root / "src", root})
        if (fs::exists(folder / (*each)[1].str())) {
          open.push_back((folder / (*each)[1].str()).lexically_normal());
          break;
        }
  }
  return seen;
}

// The structs that a script fills: with a field that must be given, a range in a comment, a check of its own, or a name
// that messages of the library begin with.
std::set<std::string> aggregates_of(const std::set<fs::path>& headers, const std::set<std::string>& named) {
  const std::regex aggregate{R"((?:^|\n)struct (\w+)(?: final)?(?: :[^\n{]*)? \{\n)"};
  const std::regex filled{R"(Required<|PerStorey<|check\(const Check|///[^\n]*[ (][<>]=? [-\w]|from \S+ to )"};
  std::set<std::string> found;
  for (const fs::path& header : headers) {
    const std::string text = testing::read_file(header);
    for (std::sregex_iterator each{text.begin(), text.end(), aggregate}, end; each != end; ++each) {
      const std::string name = (*each)[1],
                        rest = text.substr(static_cast<std::size_t>(each->position()) + each->length());
      const std::string body = rest.substr(0, rest.find("\n};"));
      if (named.contains(name) || name.ends_with("Options") || std::regex_search(body, filled)) found.insert(name);
    }
  }
  return found;
}

std::set<std::string> words_in_quotes() {
  const std::regex quoted{R"re("([A-Z]\w+)(?:::\w+)?")re"};
  std::set<std::string> found;
  for (const char* folder : {"src", "materials", "elements", "structures", "analyses"})
    for (const auto& entry : fs::recursive_directory_iterator{fs::path{MOAT_SOURCE_DIR} / folder}) {
      if (!entry.is_regular_file()) continue;
      const std::string text = testing::read_file(entry.path());
      for (std::sregex_iterator each{text.begin(), text.end(), quoted}, end; each != end; ++each)
        found.insert((*each)[1]);
    }
  return found;
}

// The library makes these of others, or gives them as results; no script fills them.
const std::set<std::string> made_by_the_library{"AxialSupport",
                                                "BearingOnSlab",
                                                "BearingPlace",
                                                "BilinearContact",
                                                "Body",
                                                "Bounds",
                                                "Carrying",
                                                "CircularFriction",
                                                "ContactFriction",
                                                "ContactState",
                                                "ContactView",
                                                "CornerAndEdge",
                                                "CornerLaw",
                                                "CornerPair",
                                                "CornerPlace",
                                                "DemandAt",
                                                "EffectiveProperties",
                                                "EnergyBalance",
                                                "Estimate",
                                                "Facing",
                                                "FacingCorner",
                                                "GapClearance",
                                                "GapPlace",
                                                "HeatedSlidingIsolator",
                                                "HeatedUnderWeight",
                                                "Impact",
                                                "Interval",
                                                "LevelPair",
                                                "LinkStep",
                                                "MotionInterval",
                                                "NewtonOptions",
                                                "NewtonReport",
                                                "Peak",
                                                "PlanarHeatedPendulum",
                                                "PlanarRubberUnderWeight",
                                                "PlanarSeriesOfSliders",
                                                "PlanarSliderUnderWeight",
                                                "RecordChannel",
                                                "RecordFrame",
                                                "Repeated",
                                                "RootDampedHertzContact",
                                                "RubberCompound",
                                                "RubberUnderWeight",
                                                "SaturatingState",
                                                "SeriesOfSliders",
                                                "SeriesUnderWeight",
                                                "SheetLine",
                                                "SlidingIsolator",
                                                "SlidingUnderWeight",
                                                "SofteningLaw",
                                                "SteelAroundLead",
                                                "StepScheme",
                                                "StepSettings",
                                                "StepTask",
                                                "ViscousHertzContact",
                                                "ViscousLinearContact"};

TEST(Constructions, HaveEveryPublicAggregate) {
  std::string text;
  for (const auto& entry : fs::directory_iterator{MOAT_SOURCE_DIR "/tests/constructions"})
    if (entry.path().extension() == ".cpp" && entry.path().filename() != "constructions_test.cpp")
      text += testing::read_file(entry.path());
  text = std::regex_replace(text, std::regex{"//[^\n]*|\"[^\"\n]*\""}, "");
  const std::set<std::string> all = aggregates_of(public_headers(), words_in_quotes());
  EXPECT_GE(all.size(), 150U);
  for (const std::string& name : all)
    if (!made_by_the_library.contains(name)) {
      EXPECT_TRUE(std::regex_search(text, std::regex{"\\b" + name + "\\b"}))
          << name << " occurs in no construction; write one, with the answer or the words of its message";
    }
  for (const std::string& name : made_by_the_library) EXPECT_TRUE(all.contains(name)) << name << " is no aggregate";
}

}  // namespace
}  // namespace moat::constructions
