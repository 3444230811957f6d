// The XML files of VTK, with raw binary data behind the XML.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace moat {

/// Collects the parts of such a file: `xml()` is the head, and every array that it declares has a block of data in the
/// order of the declarations. Nothing is copied: the data must stay where they are until the file is written, and may
/// change before.
///
///     VtkXml file{"Table"};
///     file.xml("<Table>...");
///     file.array({"time"}, std::span{values});
///     file.xml("</Table>");
///     write_file(path, file.finish());
class VtkXml {
 public:
  /// Of an array: its name, as text, and how many numbers belong together.
  struct Name {
    std::string_view name;
    int components = 1;
  };

  /// `type` is that of the data set: "UnstructuredGrid", "Table".
  explicit VtkXml(std::string_view type);

  /// Adds to the head.
  void xml(std::string_view text) { head_ += text; }
  void array(const Name& name, std::span<const double> values);
  void array(const Name& name, std::span<const std::int32_t> values);
  void array(const Name& name, std::span<const std::int64_t> values);
  void array(const Name& name, std::span<const std::uint8_t> values);
  /// Texts, each with a zero byte at its end, one after another.
  void texts(const Name& name, std::string_view zero_ended);

  /// Ends the file and returns its pieces, which point to the data and into this object.
  [[nodiscard]] std::vector<std::string_view> finish();

 private:
  void add(std::string_view element, std::string_view type, const Name& name, std::size_t tuples,
           std::string_view bytes);

  std::string head_;
  std::vector<std::string_view> blocks_;
  std::vector<std::uint64_t> sizes_;  // of the blocks, in bytes
  std::uint64_t offset_ = 0;
};

}  // namespace moat
