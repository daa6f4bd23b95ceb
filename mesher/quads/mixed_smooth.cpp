#include "mesher/quads/mixed_smooth.hpp"

#include "mesher/quads/mixed_ideal.hpp"
#include "mesher/quads/mixed_quality.hpp"
#include "mesher/quads/mixed_topology.hpp"

namespace anisofront {
namespace {

class Smoother {
 public:
  /// `quality` of the faces around a vertex is what decides on its place.
  Smoother(const BackgroundMesh& background, MixedMesh& mesh, FaceQuality quality)
      : background_(background),
        mesh_(mesh),
        quality_(quality),
        stars_(face_stars(mesh)),
        fixed_(fixed_vertices(mesh)) {}

  /// Moves each free vertex to its ideal place, if that is better.
  template <class IdealPlace>
  void cycle(IdealPlace&& ideal_place) {
    for_each_free([&](Index v) {
      Shape shape = shape_around(v);
      move_if_better(v, ideal_place(background_, mesh_, v, stars_[v]), shape);
    });
  }

  /// Moves each free vertex to the best place near by.
  void sweep() {
    for_each_free([this](Index v) { search(v); });
  }

 private:
  template <class Visit>
  void for_each_free(Visit&& visit) {
    for (Index v = 0; v < static_cast<Index>(mesh_.vertices.size()); ++v)
      if (!fixed_[v] && !stars_[v].empty()) visit(v);
  }

  Shape shape_around(Index v) const {
    Shape shape;
    for (const Corner& corner : stars_[v]) shape.add(mesh_, mesh_.faces[corner.face], quality_);
    return shape;
  }

  /// `shape` is that around the vertex, before and after. Returns whether it has moved.
  bool move_if_better(Index v, Point p, Shape& shape) {
    const WorkVertex before = mesh_.vertices[v];
    WorkVertex after{p, {}, before.hint};
    after.r = background_.factor_at(p, after.hint);
    mesh_.vertices[v] = after;
    const Shape new_shape = shape_around(v);
    if (is_better(new_shape, shape)) {
      shape = new_shape;
      return true;
    }
    mesh_.vertices[v] = before;
    return false;
  }

  /// Steps in lengths of the metric, halved where no direction is better.
  void search(Index v) {
    constexpr double kFirstStep = 0.2, kLastStep = 0.02;
    constexpr int kMostMoves = 4;  ///< with one step
    Shape shape = shape_around(v);
    move_if_better(v, ideal_place_by_shapes(background_, mesh_, v, stars_[v]), shape);
    for (double step = kFirstStep; step >= kLastStep; step *= 0.5)
      for (int moves = 0; moves < kMostMoves && make_step(v, step, shape); ++moves) {
      }
  }

  /// To the first better one of eight places around.
  bool make_step(Index v, double step, Shape& shape) {
    constexpr double kDiagonal = 0.70710678118654752;
    constexpr Vector kDirections[] = {
        {1, 0},  {kDiagonal, kDiagonal},   {0, 1},  {-kDiagonal, kDiagonal},
        {-1, 0}, {-kDiagonal, -kDiagonal}, {0, -1}, {kDiagonal, -kDiagonal}};
    const auto [p, r, hint] = mesh_.vertices[v];
    for (const Vector d : kDirections) {
      const double y = step * d.y / r.c, x = (step * d.x - r.b * y) / r.a;  // R (x, y) = step d
      if (move_if_better(v, p + Vector{x, y}, shape)) return true;
    }
    return false;
  }

  const BackgroundMesh& background_;
  MixedMesh& mesh_;
  FaceQuality quality_;
  FaceStars stars_;
  std::vector<char> fixed_;
};

}  // namespace

void smooth_mixed(const BackgroundMesh& background, MixedMesh& mesh, int cycles) {
  Smoother smoother(background, mesh, shape_quality);
  for (int cycle = 0; cycle < cycles; ++cycle) smoother.cycle(ideal_place_by_lengths);
  for (int cycle = 0; cycle < cycles; ++cycle) smoother.cycle(ideal_place_by_shapes);
}

void search_mixed(const BackgroundMesh& background, MixedMesh& mesh, int sweeps) {
  Smoother smoother(background, mesh, combined_quality);
  for (int sweep = 0; sweep < sweeps; ++sweep) smoother.sweep();
}

}  // namespace anisofront
