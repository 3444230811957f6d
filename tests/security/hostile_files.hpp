// Whether a hostile text stays a text in every file and on the terminal.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/xml_parser.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "base/text/terminal.hpp"
#include "base/text/utf8_text.hpp"
#include "hostile_strings.hpp"
#include "in_folder.hpp"

namespace moat::testing {

/// The name of a file with this text, as far as there can be one.
inline std::string file_name(std::string text) {
  constexpr std::size_t longest = 200;
  for (char& c : text)
    if (c == '/' || c == '\0') c = '_';
  return text.substr(0, longest);
}

/// With `by` for every `old`, which must be there.
inline std::string replaced(std::string text, const std::string& old, const std::string& by) {
  EXPECT_NE(text.find(old), std::string::npos) << old;
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += by.size())
    text.replace(at, old.size(), by);
  return text;
}

class Hostile : public InFolder {
 protected:
  // Whether all files lie in a folder, and the text stays one in each.
  void expect_harmless_files(const std::filesystem::path& in, const std::string& text) const {
    for (const auto& entry : std::filesystem::recursive_directory_iterator{folder}) {
      const std::filesystem::path path = std::filesystem::relative(entry.path(), folder);
      EXPECT_EQ(*path.begin(), in) << path << " lies outside";
      EXPECT_NE(path.filename(), "pwned") << path;
      EXPECT_EQ(printable(path.string()), path.string());
      if (entry.is_regular_file()) expect_harmless_file(entry.path(), text);
    }
  }
  // Whether the text runs, or leaves its field.
  static void expect_harmless_file(const std::filesystem::path& path, const std::string& text) {
    SCOPED_TRACE(path);
    const std::string kind = path.extension(), content = read_file(path);
    if (content.starts_with("SQLite format 3")) return;
    EXPECT_TRUE(is_utf8(content));
    if (kind == ".csv") expect_harmless_table(content);
    EXPECT_TRUE(kind != ".json" || nlohmann::json::accept(content));
    if (kind != ".html" && kind != ".svg" && kind != ".vtu" && kind != ".vtt" && kind != ".pvd") return;
    if (text.find('<') != std::string::npos) {
      if (const std::size_t at = content.find(text); at != std::string::npos)
        ADD_FAILURE() << "not escaped: " << printable(content.substr(at - std::min<std::size_t>(at, 60), 120));
    }
    for (const char* mark : {"\xE2\x80\xAE", "\xE2\x81\xA7", "\xEF\xBF\xBE", "\xEF\xBF\xBF", "\x1b"})
      EXPECT_EQ(content.find(mark), std::string::npos) << printable(mark);
    EXPECT_EQ(content.find('\0'), std::string::npos);
    if (kind == ".html" || content.find("encoding=\"appended\"") != std::string::npos ||
        content.find("encoding=\"raw\"") != std::string::npos)
      return;
    std::istringstream stream{content};
    boost::property_tree::ptree tree;
    EXPECT_NO_THROW(boost::property_tree::read_xml(stream, tree));
  }
  // As many fields in every row, and no formula.
  static void expect_harmless_table(const std::string& content) {
    std::vector<std::string> fields{""};
    std::size_t columns = 0;
    bool in_quotes = false;
    const auto end_row = [&] {
      if (columns == 0) columns = fields.size();
      EXPECT_EQ(fields.size(), columns) << printable(fields.front());
      for (const std::string& field : fields) {
        EXPECT_TRUE(field.empty() || std::string{"=@\t\r"}.find(field.front()) == std::string::npos) << field;
        EXPECT_FALSE((field.starts_with('+') || field.starts_with('-')) && field.find('|') != std::string::npos)
            << field;
      }
      fields = {""};
    };
    for (const char c : content) {
      if (c == '"')
        in_quotes = !in_quotes;
      else if (c == ',' && !in_quotes)
        fields.emplace_back();
      else if (c == '\n' && !in_quotes)
        end_row();
      else
        fields.back() += c;
    }
    EXPECT_FALSE(in_quotes);
  }
};

}  // namespace moat::testing
