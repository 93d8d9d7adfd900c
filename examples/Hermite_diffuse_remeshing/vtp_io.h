// Reading and writing of VTK's XML format for polygons (.vtp), without VTK.
// Written: ascii. Read: ascii, inline base64, and appended data (raw or base64), uncompressed,
// of either byte order.

#ifndef HERMITE_DIFFUSE_REMESHING_EXAMPLES_VTP_IO_H
#define HERMITE_DIFFUSE_REMESHING_EXAMPLES_VTP_IO_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <istream>
#include <iterator>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace vtp {

typedef std::pair<std::string, std::vector<double> > Data_array; // name, one value per element

// ---- writing ------------------------------------------------------------------------------------

template <typename Values>
void write_array(std::ostream& os, const char* type, const std::string& attributes,
                 const Values& values, const std::size_t values_per_line)
{
  os << "<DataArray type=\"" << type << "\" " << attributes << " format=\"ascii\">\n";
  std::size_t i = 0;
  for(const auto value : values)
    os << value << ((++i % values_per_line == 0) ? '\n' : ' ');
  os << "</DataArray>\n";
}

inline void write_data(std::ostream& os, const char* section, const std::vector<Data_array>& data)
{
  os << '<' << section << ">\n";
  for(const Data_array& array : data)
    write_array(os, "Float64", "Name=\"" + array.first + "\"", array.second, 1);
  os << "</" << section << ">\n";
}

template <typename Points, typename Polygons>
void write(std::ostream& os, const Points& points, const Polygons& polygons,
           const std::vector<Data_array>& point_data = std::vector<Data_array>(),
           const std::vector<Data_array>& cell_data = std::vector<Data_array>())
{
  std::vector<double> coordinates;
  for(const auto& p : points)
    for(const double c : { p.x(), p.y(), p.z() })
      coordinates.push_back(c);

  std::vector<std::size_t> connectivity, offsets;
  for(const auto& polygon : polygons)
  {
    connectivity.insert(connectivity.end(), polygon.begin(), polygon.end());
    offsets.push_back(connectivity.size());
  }

  os << "<?xml version=\"1.0\"?>\n"
     << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
     << "<PolyData>\n"
     << "<Piece NumberOfPoints=\"" << points.size() << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\""
     << " NumberOfStrips=\"0\" NumberOfPolys=\"" << polygons.size() << "\">\n";
  write_data(os, "PointData", point_data);
  write_data(os, "CellData", cell_data);
  os << "<Points>\n";
  write_array(os, "Float64", "NumberOfComponents=\"3\"", coordinates, 3);
  os << "</Points>\n<Polys>\n";
  write_array(os, "Int64", "Name=\"connectivity\"", connectivity, 3);
  write_array(os, "Int64", "Name=\"offsets\"", offsets, 1);
  os << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

// ---- reading ------------------------------------------------------------------------------------

namespace internal {

struct Tag
{
  std::string name;                              // with a leading '/' if it is a closing tag
  std::map<std::string, std::string> attributes;

  std::string operator[](const std::string& key) const
  {
    const auto it = attributes.find(key);
    return (it == attributes.end()) ? std::string() : it->second;
  }
};

// finds the next tag at or after `pos`, and moves `pos` behind it
inline bool next_tag(const std::string& xml, std::size_t& pos, Tag& tag)
{
  const char* const blanks = " \t\r\n";
  std::size_t end;
  do
  {
    pos = xml.find('<', pos);
    if(pos == std::string::npos)
      return false;
    const bool is_comment = xml.compare(pos, 4, "<!--") == 0;
    end = xml.find(is_comment ? "-->" : ">", pos);
    if(end == std::string::npos)
      return false;
    if(xml[pos + 1] != '?' && xml[pos + 1] != '!')
      break;
    pos = end;
  }
  while(true);

  const std::string text = xml.substr(pos + 1, end - pos - 1);
  pos = end + 1;
  std::size_t at = text.find_first_of(" \t\r\n/", 1);
  tag.name = text.substr(0, at);
  tag.attributes.clear();
  while(at != std::string::npos && (at = text.find_first_not_of(blanks, at)) != std::string::npos)
  {
    const std::size_t equal = text.find('=', at);
    const std::size_t open = (equal == std::string::npos) ? equal
                                                          : text.find_first_of("\"'", equal);
    const std::size_t close = (open == std::string::npos) ? open
                                                          : text.find(text[open], open + 1);
    if(close == std::string::npos)
      break;
    const std::size_t key_end = text.find_last_not_of(" \t\r\n=", equal);
    tag.attributes[text.substr(at, key_end + 1 - at)] = text.substr(open + 1, close - open - 1);
    at = close + 1;
  }
  return true;
}

inline std::string decode_base64(const std::string& xml, std::size_t pos, const std::size_t bytes)
{
  std::string result;
  std::uint32_t bits = 0;
  int number_of_bits = 0;
  for(; result.size() < bytes && pos < xml.size(); ++pos)
  {
    const char c = xml[pos];
    int digit;
    if(c >= 'A' && c <= 'Z')      digit = c - 'A';
    else if(c >= 'a' && c <= 'z') digit = c - 'a' + 26;
    else if(c >= '0' && c <= '9') digit = c - '0' + 52;
    else if(c == '+')             digit = 62;
    else if(c == '/')             digit = 63;
    else if(c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    else break;
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    number_of_bits += 6;
    if(number_of_bits >= 8)
    {
      number_of_bits -= 8;
      result += static_cast<char>((bits >> number_of_bits) & 0xFF);
    }
  }
  return result;
}

template <typename T>
T number_at(const std::string& bytes, const std::size_t pos, const bool is_swapped)
{
  char raw[sizeof(T)];
  std::memcpy(raw, bytes.data() + pos, sizeof(T));
  if(is_swapped)
    std::reverse(raw, raw + sizeof(T));
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

template <typename T>
std::vector<double> numbers(const std::string& bytes, const bool is_swapped)
{
  std::vector<double> values;
  for(std::size_t pos = 0; pos + sizeof(T) <= bytes.size(); pos += sizeof(T))
    values.push_back(static_cast<double>(number_at<T>(bytes, pos, is_swapped)));
  return values;
}

inline bool is_little_endian()
{
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

// the values of a DataArray, wherever the file keeps them
class Array_reader
{
  const std::string& xml;
  bool is_swapped = false;
  bool is_header_long = false;
  std::size_t appended_begin = std::string::npos; // of the data, behind the underscore
  bool is_appended_raw = false;

  // a block starts with its number of bytes
  std::string block(const std::size_t pos, const bool is_raw) const
  {
    const std::size_t header = is_header_long ? 8 : 4;
    const auto bytes = [&](const std::size_t n)
    { return is_raw ? xml.substr((std::min)(pos, xml.size()), n) : decode_base64(xml, pos, n); };

    const std::string head = bytes(header);
    if(head.size() < header)
      throw std::runtime_error("its data end too early");
    const std::uint64_t size = is_header_long ? number_at<std::uint64_t>(head, 0, is_swapped)
                                              : number_at<std::uint32_t>(head, 0, is_swapped);
    if(size > xml.size())
      throw std::runtime_error("its data end too early");
    const std::string all = bytes(header + static_cast<std::size_t>(size));
    if(all.size() < header + size)
      throw std::runtime_error("its data end too early");
    return all.substr(header);
  }

  std::vector<double> ascii(const std::size_t pos) const
  {
    std::vector<double> values;
    const char* at = xml.c_str() + pos;
    char* end = nullptr;
    for(double value = std::strtod(at, &end); end != at; value = std::strtod(at, &end))
    {
      values.push_back(value);
      at = end;
    }
    return values;
  }

public:
  Array_reader(const std::string& xml, const Tag& file)
    : xml(xml)
  {
    if(file["type"] != "PolyData")
      throw std::runtime_error("it is not a VTK file of type PolyData");
    if(!file["compressor"].empty())
      throw std::runtime_error("its data are compressed; write it without compression");
    is_swapped = (file["byte_order"] == "BigEndian") == is_little_endian();
    is_header_long = (file["header_type"] == "UInt64");

    const std::size_t tag_begin = xml.find("<AppendedData");
    if(tag_begin != std::string::npos)
    {
      std::size_t pos = tag_begin;
      Tag tag;
      if(next_tag(xml, pos, tag))
      {
        is_appended_raw = (tag["encoding"] == "raw");
        appended_begin = xml.find('_', pos);
        if(appended_begin != std::string::npos)
          ++appended_begin;
      }
    }
  }

  // `pos` is behind the tag
  std::vector<double> operator()(const Tag& tag, const std::size_t pos) const
  {
    const std::string format = tag["format"], type = tag["type"];
    if(format == "ascii" || format.empty())
      return ascii(pos);

    std::string bytes;
    if(format == "binary")
      bytes = block(pos, false);
    else if(format == "appended" && appended_begin != std::string::npos)
      bytes = block(appended_begin + std::strtoul(tag["offset"].c_str(), nullptr, 10),
                    is_appended_raw);
    else
      throw std::runtime_error("it has data in an unknown format");

    if(type == "Float64") return numbers<double>(bytes, is_swapped);
    if(type == "Float32") return numbers<float>(bytes, is_swapped);
    if(type == "Int64")   return numbers<std::int64_t>(bytes, is_swapped);
    if(type == "UInt64")  return numbers<std::uint64_t>(bytes, is_swapped);
    if(type == "Int32")   return numbers<std::int32_t>(bytes, is_swapped);
    if(type == "UInt32")  return numbers<std::uint32_t>(bytes, is_swapped);
    throw std::runtime_error("it has data of the unknown type '" + type + "'");
  }
};

} // namespace internal

// appends the points and polygons of all pieces; throws std::runtime_error with the reason
template <typename Point, typename Polygon>
void read(std::istream& is, std::vector<Point>& points, std::vector<Polygon>& polygons)
{
  const std::string xml((std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>());
  std::size_t pos = 0;
  internal::Tag tag;
  do
  {
    if(!internal::next_tag(xml, pos, tag))
      throw std::runtime_error("it is not a VTK file");
  }
  while(tag.name != "VTKFile");
  const internal::Array_reader values_of(xml, tag);

  std::string section;
  std::vector<double> coordinates, connectivity, offsets;
  while(internal::next_tag(xml, pos, tag) && tag.name != "AppendedData")
  {
    if(tag.name == "Points" || tag.name == "Polys" || tag.name == "/Points" || tag.name == "/Polys")
      section = tag.name;
    else if(tag.name == "DataArray" && section == "Points")
      coordinates = values_of(tag, pos);
    else if(tag.name == "DataArray" && section == "Polys" && tag["Name"] == "connectivity")
      connectivity = values_of(tag, pos);
    else if(tag.name == "DataArray" && section == "Polys" && tag["Name"] == "offsets")
      offsets = values_of(tag, pos);
    else if(tag.name == "/Piece")
    {
      const std::size_t first_point = points.size();
      for(std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
        points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);

      std::size_t begin = 0;
      for(const double offset : offsets)
      {
        if(!(offset >= static_cast<double>(begin)
             && offset <= static_cast<double>(connectivity.size())))
          throw std::runtime_error("its polygons are damaged");
        polygons.emplace_back();
        for(; begin < static_cast<std::size_t>(offset); ++begin)
        {
          if(!(connectivity[begin] >= 0. && connectivity[begin] < 1e15))
            throw std::runtime_error("its polygons are damaged");
          polygons.back().push_back(first_point + static_cast<std::size_t>(connectivity[begin]));
        }
      }
      coordinates.clear();
      connectivity.clear();
      offsets.clear();
    }
  }
}

} // namespace vtp

#endif // HERMITE_DIFFUSE_REMESHING_EXAMPLES_VTP_IO_H
