#include "mesher/quads/mixed_smooth.hpp"

#include "mesher/quads/mixed_ideal.hpp"
#include "mesher/quads/mixed_quality.hpp"
#include "mesher/quads/mixed_topology.hpp"

namespace anisofront {
namespace {

class Smoother {
 public:
  Smoother(const BackgroundMesh& background, MixedMesh& mesh)
      : background_(background),
        mesh_(mesh),
        stars_(face_stars(mesh)),
        fixed_(fixed_vertices(mesh)) {}

  /// Moves each free vertex to its ideal place, if that is better.
  template <class IdealPlace>
  void cycle(IdealPlace&& ideal_place) {
    for (Index v = 0; v < static_cast<Index>(mesh_.vertices.size()); ++v)
      if (!fixed_[v] && !stars_[v].empty())
        move_if_better(v, ideal_place(background_, mesh_, v, stars_[v]));
  }

 private:
  Shape shape_around(Index v) const {
    Shape shape;
    for (const Corner& corner : stars_[v]) shape.add(mesh_, mesh_.faces[corner.face]);
    return shape;
  }

  void move_if_better(Index v, Point p) {
    const WorkVertex before = mesh_.vertices[v];
    const Shape old_shape = shape_around(v);
    WorkVertex after{p, {}, before.hint};
    after.r = background_.factor_at(p, after.hint);
    mesh_.vertices[v] = after;
    if (!is_better(shape_around(v), old_shape)) mesh_.vertices[v] = before;
  }

  const BackgroundMesh& background_;
  MixedMesh& mesh_;
  FaceStars stars_;
  std::vector<char> fixed_;
};

}  // namespace

void smooth_mixed(const BackgroundMesh& background, MixedMesh& mesh, int cycles) {
  Smoother smoother(background, mesh);
  for (int cycle = 0; cycle < cycles; ++cycle) smoother.cycle(ideal_place_by_lengths);
  for (int cycle = 0; cycle < cycles; ++cycle) smoother.cycle(ideal_place_by_shapes);
}

}  // namespace anisofront
