#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "drivers/base/json.hpp"
#include "drivers/report/mesh_walk.hpp"

namespace anisofront::testing {

/// Reads a mesh blob from what drivers/report/mesh_blob.hpp says about it.
class BlobReader {
 public:
  explicit BlobReader(const std::vector<std::string>& blocks)
      : BlobReader(std::accumulate(blocks.begin(), blocks.end(), std::string())) {}

  explicit BlobReader(const std::string& bytes) {
    std::size_t length = 0;
    for (int i = 3; i >= 0; --i) length = length * 256 + static_cast<unsigned char>(bytes[i]);
    header = Json::parse(bytes.substr(4, length));
    is_padded = length % 4 == 0;
    std::size_t offset = 4 + length;
    for (const Json& array : header["arrays"]) {
      const std::size_t count = array["count"], planes = array.value("planes", 1);
      arrays_[array["on"].get<std::string>() + ":" + array["name"].get<std::string>()] = {
          array, unfold(bytes, offset, count, planes)};
      offset += count * planes;
    }
    is_complete = offset == bytes.size();
    read_corners();
    read_points();
  }

  Json header;
  bool is_padded = false, is_complete = false;
  Mesh mesh;  ///< points (from the centre), triangles and quads

  bool has(const std::string& key) const { return arrays_.count(key) != 0; }
  std::string scale(const std::string& key) const {
    return arrays_.at(key).header.value("scale", "linear");
  }

  /// One component of an array, "vertex:u".
  std::vector<double> values(const std::string& key, std::size_t component = 0) const {
    const Array& array = arrays_.at(key);
    const double step = array.header.value("step", 1.);
    std::vector<double> result;
    for (const double code : codes(array, component)) {
      if (code == 1 << 30)
        result.push_back(std::numeric_limits<double>::quiet_NaN());
      else if (array.header.value("scale", "linear") == "linear")
        result.push_back(code * step);
      else
        result.push_back(code == -(1 << 30) ? 0 : std::exp2(code * step));
    }
    return result;
  }

 private:
  struct Array {
    Json header;
    std::vector<double> residuals;
  };

  static std::vector<double> unfold(const std::string& bytes, std::size_t offset, std::size_t count,
                                    std::size_t planes) {
    std::vector<double> numbers(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::uint64_t folded = 0;
      for (std::size_t k = planes; k-- > 0;)
        folded = folded * 256 + static_cast<unsigned char>(bytes.at(offset + k * count + i));
      const double half = static_cast<double>(folded / 2);
      numbers[i] = folded % 2 == 0 ? half : -half - 1;
    }
    return numbers;
  }

  static double plain(double code) { return std::fabs(code) == 1 << 30 ? 0 : code; }

  double guess(const VertexGuess& g, const std::vector<double>& known) const {
    const auto value = [&](int i) { return g.from[i] == kNoIndex ? 0 : plain(known[g.from[i]]); };
    return 0.5 * (g.weight * value(0) + (4 - g.weight) * value(1) - value(2) - value(3));
  }

  std::vector<double> codes(const Array& array, std::size_t component) const {
    const std::size_t components = array.header.value("components", 1);
    const std::size_t length = array.residuals.size() / components;
    const auto begin = array.residuals.begin() + static_cast<std::ptrdiff_t>(component * length);
    std::vector<double> codes(begin, begin + static_cast<std::ptrdiff_t>(length));
    const std::string after = array.header.value("after", "nothing");
    if (after == "previous")
      for (std::size_t i = 1; i < length; ++i) codes[i] += plain(codes[i - 1]);
    if (after != "neighbours") return codes;
    const std::vector<double> residuals = codes;
    for (std::size_t i = 0; i < length; ++i)
      codes[walk_[i].vertex] = residuals[i] + std::floor(guess(walk_[i], codes) + 0.5);
    return codes;
  }

  void read_corners() {
    const std::vector<double> recent_codes = values("corner:corner-recent");
    const std::vector<double> far = values("corner:corner-far");
    std::vector<Index> corners, recent;
    Index highest = kNoIndex;
    std::size_t used = 0;
    for (const double code : recent_codes) {
      const auto k = static_cast<std::ptrdiff_t>(code);
      const Index v = k == 0    ? highest + 1
                      : k == -1 ? static_cast<Index>(far.at(used++))
                                : recent.at(recent.size() - static_cast<std::size_t>(k));
      if (k > 0) recent.erase(recent.end() - k);
      recent.push_back(v);
      if (recent.size() > 127) recent.erase(recent.begin());
      highest = std::max(highest, v);
      corners.push_back(v);
    }
    const std::size_t triangles = header["triangles"];
    for (std::size_t i = 0; i < 3 * triangles; i += 3)
      mesh.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    for (std::size_t i = 3 * triangles; i < corners.size(); i += 4)
      mesh.quads.push_back({corners[i], corners[i + 1], corners[i + 2], corners[i + 3]});
    mesh.points.resize(header["vertices"]);
    walk_ = mesh_walk(mesh);
  }

  void read_points() {
    const std::vector<double> exponents = values("vertex:point-exponent");
    const std::vector<double>& residuals = arrays_.at("vertex:point").residuals;
    for (const std::size_t c : {0, 1}) {
      std::vector<double> known(walk_.size());
      for (std::size_t i = 0; i < walk_.size(); ++i) {
        const Index v = walk_[i].vertex;
        const double unit = std::exp2(exponents[v]);
        known[v] = unit * (std::floor(guess(walk_[i], known) / unit + 0.5) +
                           residuals[c * walk_.size() + i]);
        (c == 0 ? mesh.points[v].x : mesh.points[v].y) = known[v];
      }
    }
  }

  std::map<std::string, Array> arrays_;
  std::vector<VertexGuess> walk_;
};

}  // namespace anisofront::testing
