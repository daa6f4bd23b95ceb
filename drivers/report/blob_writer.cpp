#include "drivers/report/blob_writer.hpp"

#include <array>
#include <cmath>

namespace anisofront {
namespace {

constexpr std::array<const char*, 3> kAfterNames{"nothing", "previous", "neighbours"};

std::string little_endian(std::size_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8)
    bytes += static_cast<char>(static_cast<unsigned char>(value >> shift & 0xff));
  return bytes;
}

}  // namespace

void BlobWriter::add(const std::string& name, const char* on, const std::vector<Codes>& components,
                     After after, CodeScale scale) {
  Codes residuals;
  for (const Codes& codes : components) {
    const Codes part = after == After::neighbours ? after_neighbours(codes, walk_)
                       : after == After::previous ? after_previous(codes)
                                                  : codes;
    residuals.insert(residuals.end(), part.begin(), part.end());
  }
  add_residuals(name, on, components.size(), residuals, after, scale);
}

void BlobWriter::add_values(const std::string& name, const char* on, const Components& components,
                            After after, CodeScale scale) {
  std::vector<Codes> codes;
  for (const std::vector<double>& values : components) codes.push_back(codes_of(values, scale));
  add(name, on, codes, after, scale);
}

void BlobWriter::add_points(const std::vector<Point>& points, const std::vector<int>& exponents) {
  Codes residuals;
  for (const auto coordinate : {&Point::x, &Point::y}) {
    std::vector<double> rounded(points.size());
    const auto known = [&](Index v) { return v == kNoIndex ? 0 : rounded[v]; };
    for (const auto& [vertex, from, weight] : walk_) {
      const double unit = std::ldexp(1, exponents[vertex]);
      const double code = std::floor(points[vertex].*coordinate / unit + 0.5);
      const double twice =
          weight * known(from[0]) + (4 - weight) * known(from[1]) - known(from[2]) - known(from[3]);
      residuals.push_back(std::llround(code - std::floor(0.5 * twice / unit + 0.5)));
      rounded[vertex] = code * unit;
    }
  }
  add_residuals("point", "vertex", 2, residuals, After::neighbours, {});
}

void BlobWriter::add_residuals(const std::string& name, const char* on, std::size_t components,
                               const Codes& residuals, After after, CodeScale scale) {
  const std::vector<std::string> planes = byte_planes(residuals);
  Json array{{"name", name}, {"on", on}, {"count", residuals.size()}};
  if (components != 1) array["components"] = components;
  if (planes.size() != 1) array["planes"] = planes.size();
  if (after != After::nothing) array["after"] = kAfterNames[static_cast<std::size_t>(after)];
  if (scale.logarithmic) array["scale"] = "log2";
  if (scale.step != 1) array["step"] = scale.step;
  arrays_.push_back(array);
  blocks_.insert(blocks_.end(), planes.begin(), planes.end());
}

std::vector<std::string> BlobWriter::blocks() const {
  Json whole = header_;
  whole["arrays"] = arrays_;
  std::string header = whole.dump(-1, ' ', false, Json::error_handler_t::replace);
  header.resize((header.size() + 3) / 4 * 4, ' ');
  std::vector<std::string> blocks{little_endian(header.size()) + header};
  blocks.insert(blocks.end(), blocks_.begin(), blocks_.end());
  return blocks;
}

}  // namespace anisofront
