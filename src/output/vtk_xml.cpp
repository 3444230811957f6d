#include "output/vtk_xml.hpp"

#include <algorithm>
#include <bit>

#include "output/xml_text.hpp"

namespace moat {
namespace {

template <class Value>
std::string_view bytes_of(std::span<const Value> values) {
  const auto bytes = std::as_bytes(values);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string_view bytes_of(const std::uint64_t& value) { return {reinterpret_cast<const char*>(&value), sizeof value}; }

constexpr std::string_view data_start = "<AppendedData encoding=\"raw\">\n_";
constexpr std::string_view file_end = "\n</AppendedData>\n</VTKFile>\n";

}  // namespace

VtkXml::VtkXml(std::string_view type) {
  constexpr bool little = std::endian::native == std::endian::little;
  head_ = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + std::string{type} +
          "\" version=\"1.0\" header_type=\"UInt64\" byte_order=\"" + (little ? "LittleEndian" : "BigEndian") + "\">\n";
}

void VtkXml::add(std::string_view element, std::string_view type, const Name& name, std::size_t tuples,
                 std::string_view bytes) {
  head_.append("<").append(element).append(" type=\"").append(type).append("\" Name=\"");
  head_ += escaped_for_xml(name.name);
  if (name.components != 1) head_ += "\" NumberOfComponents=\"" + std::to_string(name.components);
  head_ += "\" NumberOfTuples=\"" + std::to_string(tuples) + "\" format=\"appended\" offset=\"" +
           std::to_string(offset_) + "\"/>\n";
  blocks_.push_back(bytes);
  sizes_.push_back(bytes.size());
  offset_ += sizeof(std::uint64_t) + bytes.size();
}

void VtkXml::array(const Name& name, std::span<const double> values) {
  add("DataArray", "Float64", name, values.size() / static_cast<std::size_t>(name.components), bytes_of(values));
}
void VtkXml::array(const Name& name, std::span<const std::int32_t> values) {
  add("DataArray", "Int32", name, values.size() / static_cast<std::size_t>(name.components), bytes_of(values));
}
void VtkXml::array(const Name& name, std::span<const std::int64_t> values) {
  add("DataArray", "Int64", name, values.size() / static_cast<std::size_t>(name.components), bytes_of(values));
}
void VtkXml::array(const Name& name, std::span<const std::uint8_t> values) {
  add("DataArray", "UInt8", name, values.size() / static_cast<std::size_t>(name.components), bytes_of(values));
}

void VtkXml::texts(const Name& name, std::string_view zero_ended) {
  const auto count = static_cast<std::size_t>(std::ranges::count(zero_ended, '\0'));
  add("Array", "String", name, count, zero_ended);
}

std::vector<std::string_view> VtkXml::finish() {
  head_ += data_start;
  std::vector<std::string_view> pieces{head_};
  pieces.reserve(2 * blocks_.size() + 2);
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    pieces.push_back(bytes_of(sizes_[i]));
    pieces.push_back(blocks_[i]);
  }
  pieces.push_back(file_end);
  return pieces;
}

}  // namespace moat
