#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/background/background_mesh.hpp"
#include "mesher/geometry/domain.hpp"
#include "mesher/quads/quad_energy.hpp"
#include "mesher/quads/quad_mesh.hpp"

namespace anisofront {

/// The segments before and after a boundary vertex that may slide along their curve.
struct SlideTrack {
  Index before = kNoIndex, after = kNoIndex;
};

/// A quadrilateral mesh with the energy of every quadrilateral, changed in transactions that can be
/// undone: begin, touch what will change, change it, then commit or undo.
class QuadWork {
 public:
  /// Energies and ideal valences are computed here.
  QuadWork(const BackgroundMesh& background, QuadMesh mesh, const QuadWeights& weights);

  const BackgroundMesh& background;
  QuadMesh mesh;
  QuadWeights weights;
  std::vector<double> energy;             ///< per quad, without the potential
  std::vector<char> convex;               ///< per quad, as the energy sees it
  std::vector<std::uint8_t> ideal;        ///< per vertex: ideal valence, 4 inside
  std::vector<std::uint32_t> changed_at;  ///< per vertex: number of the last commit at it

  /// Lets vertices between two segments of one curve slide along it while the mesh is smoothed, but
  /// those at the ends of curves, at junctions, on interfaces and the `pinned`.
  void allow_sliding(const Domain& domain, std::vector<Segment> segments,
                     const std::vector<Index>& pinned);
  bool may_slide(Index v) const {
    return v < static_cast<Index>(tracks.size()) && tracks[v].before != kNoIndex;
  }
  const Domain* domain = nullptr;  ///< of the curves, where sliding is allowed
  std::vector<Segment> segments;   ///< with the parameters of the vertices
  std::vector<SlideTrack> tracks;  ///< per vertex of the first mesh, or empty

  struct Energy {
    double value;
    bool convex;
  };
  Energy energy_of(Index quad) const;
  /// z^2 + z^4 of the edge ab.
  double edge_defect(const WorkVertex& a, const WorkVertex& b) const {
    const Vector u = b.p - a.p;
    const double at_a = squared_length(a.r, u), at_b = squared_length(b.r, u);
    return weights.middle_lengths ? middle_length_defect(a, b, at_a, at_b)
                                  : length_defect(at_a, at_b);
  }
  /// beta~ (Eqn 16), not positive where the quadrilateral is not convex.
  double beta_of(Index quad) const;
  void update_energy(Index quad) {
    const Energy e = energy_of(quad);
    energy[quad] = e.value;
    convex[quad] = e.convex;
  }
  void update_all_energies();
  std::uint32_t commits() const { return commits_; }

  void begin();
  /// Remember a quad or a vertex (once) before it is changed.
  void touch_quad(Index quad) {
    if (quad_stamp_[quad] != stamp_) save_quad(quad);
  }
  void touch_vertex(Index v) {
    if (vertex_stamp_[v] != stamp_) save_vertex(v);
  }
  Index add_quad();
  Index add_vertex(const WorkVertex& vertex);
  /// Twins of each other; t may be ~segment.
  void sew(Index h, Index t);
  void set_corner(Index h, Index v) { mesh.corner[h] = v; }
  /// Lets `leaving` of the origin of h start its fan or ring, and counts its quads.
  void recount(Index h);
  void remove_quad(Index quad);
  void remove_vertex(Index v);
  /// Moves a vertex, remembering it and its quads.
  void move(Index v, const WorkVertex& to);

  /// Growth of sum (valence - ideal)^2 since begin().
  int valence_growth() const;
  /// Energies of the live quads that the transaction has touched are computed again; their sum
  /// (with the potential) minus that before. `not_convex` counts the quads that are not convex,
  /// after minus before.
  double energy_change(int& not_convex);
  /// The free vertices of the live touched quads, ascending.
  const std::vector<Index>& free_vertices();
  void commit();
  void undo();

 private:
  struct SavedQuad {
    Index quad;
    std::array<Index, 4> corner, twin;
    double energy;
    bool convex;
  };
  struct SavedVertex {
    Index vertex;
    Index leaving;
    WorkVertex value;
    std::uint8_t valence;
  };

  QuadShape shape_of(Index quad) const;
  double middle_length_defect(const WorkVertex& a, const WorkVertex& b, double at_a,
                              double at_b) const;
  void save_quad(Index quad);
  void save_vertex(Index v);
  void set_ideal_valences();

  std::vector<std::uint32_t> quad_stamp_, vertex_stamp_;
  std::uint32_t stamp_ = 0, commits_ = 1;
  std::vector<SavedQuad> saved_quads_;
  std::vector<SavedVertex> saved_vertices_;
  Index quads_before_ = 0, vertices_before_ = 0;
  std::vector<Index> free_vertices_;
};

}  // namespace anisofront
