#pragma once

#include <string>
#include <vector>

#include "drivers/base/json.hpp"
#include "drivers/report/mesh_codes.hpp"

namespace anisofront {

/// What the codes of an array are stored as differences to.
enum class After { nothing, previous, neighbours };

using Components = std::vector<std::vector<double>>;

/// Header and arrays of a mesh blob (mesh_blob.hpp) as they grow. `on`: what an array has values
/// for, "vertex", "element", "edge" ...
class BlobWriter {
 public:
  explicit BlobWriter(const Mesh& mesh) : walk_(mesh_walk(mesh)) {}

  void set(const char* key, Json value) { header_[key] = std::move(value); }

  void add(const std::string& name, const char* on, const std::vector<Codes>& components,
           After after, CodeScale scale = {});
  void add_values(const std::string& name, const char* on, const Components& components,
                  After after, CodeScale scale);
  /// The array "point": coordinates in units of 2^exponent, which differ from vertex to vertex, so
  /// that it is numbers that are guessed from the neighbours, not codes.
  void add_points(const std::vector<Point>& points, const std::vector<int>& exponents);

  /// The blob in blocks of one kind: length and header, then the arrays.
  std::vector<std::string> blocks() const;

 private:
  void add_residuals(const std::string& name, const char* on, std::size_t components,
                     const Codes& residuals, After after, CodeScale scale);

  std::vector<VertexGuess> walk_;
  Json header_ = Json::object(), arrays_ = Json::array();
  std::vector<std::string> blocks_;
};

}  // namespace anisofront
