#include "drivers/report/mesh_walk.hpp"

namespace anisofront {
namespace {

/// The corners of all elements, triangles first. Side s runs from corner s to the next corner of
/// its element.
class Sides {
 public:
  explicit Sides(const Mesh& mesh)
      : triangles_(static_cast<Index>(mesh.triangles.size())),
        elements_(triangles_ + static_cast<Index>(mesh.quads.size())) {
    for (const Triangle& t : mesh.triangles) corners_.insert(corners_.end(), t.begin(), t.end());
    for (const Quad& q : mesh.quads) corners_.insert(corners_.end(), q.begin(), q.end());
    first_.assign(mesh.points.size(), kNoIndex);
    next_.assign(corners_.size(), kNoIndex);
    for (Index s = static_cast<Index>(corners_.size()); s-- > 0;) {
      next_[s] = first_[corners_[s]];
      first_[corners_[s]] = s;
    }
  }

  Index elements() const { return elements_; }
  Index size(Index element) const { return element < triangles_ ? 3 : 4; }
  Index begin(Index element) const {
    return element < triangles_ ? 3 * element : 4 * element - triangles_;
  }
  Index element(Index side) const {
    return side < 3 * triangles_ ? side / 3 : (side + triangles_) / 4;
  }
  /// The vertex `steps` corners after the start of a side.
  Index vertex(Index side, Index steps) const {
    const Index e = element(side);
    return corners_[begin(e) + (side - begin(e) + steps) % size(e)];
  }
  /// The first side that runs the other way, or kNoIndex.
  Index across(Index side) const {
    const Index a = vertex(side, 0), b = vertex(side, 1);
    Index other = first_[b];
    while (other != kNoIndex && vertex(other, 1) != a) other = next_[other];
    return other;
  }

 private:
  Index triangles_, elements_;
  std::vector<Index> corners_;
  std::vector<Index> first_;  ///< first side that starts at a vertex
  std::vector<Index> next_;   ///< next side that starts where this one does
};

class Walk {
 public:
  explicit Walk(const Mesh& mesh)
      : sides_(mesh), known_(mesh.points.size()), reached_(sides_.elements()) {}

  std::vector<VertexGuess> run() {
    for (Index e = 0; e < sides_.elements(); ++e)
      if (!reached_[e]) walk_piece(e);
    for (std::size_t v = 0; v < known_.size(); ++v) add_beside_last(static_cast<Index>(v));
    return std::move(guesses_);
  }

 private:
  void walk_piece(Index start) {
    for (Index k = 0; k < sides_.size(start); ++k)
      add_beside_last(sides_.vertex(sides_.begin(start), k));
    reached_[start] = 1;
    std::vector<Index> queue{start};
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (Index k = 0; k < sides_.size(queue[i]); ++k) {
        const Index side = sides_.begin(queue[i]) + k;
        const Index other = sides_.across(side);
        if (other == kNoIndex || reached_[sides_.element(other)]) continue;
        reached_[sides_.element(other)] = 1;
        queue.push_back(sides_.element(other));
        add_beyond(side, other);
      }
  }

  /// The vertices of the element of `other` from those of the element of `side`, which runs along
  /// the same edge from a to b.
  void add_beyond(Index side, Index other) {
    const Index a = sides_.vertex(side, 0), b = sides_.vertex(side, 1);
    const Index c = sides_.vertex(side, 2),
                d = sides_.vertex(side, -1 + sides_.size(sides_.element(side)));
    const Index beyond_a = sides_.vertex(other, 2);
    if (sides_.size(sides_.element(other)) == 3) return add(beyond_a, {a, b, c, d}, 2);
    const Index beyond_b = sides_.vertex(other, 3);
    if (known_[beyond_b])
      add(beyond_a, {a, beyond_b, b, b}, 2);
    else
      add(beyond_a, {a, b, c, d}, 3);
    add(beyond_b, {b, beyond_a, a, a}, 2);
  }

  void add_beside_last(Index vertex) {
    const Index last = guesses_.empty() ? kNoIndex : guesses_.back().vertex;
    add(vertex, {last, last, last, last}, 2);
  }

  void add(Index vertex, const std::array<Index, 4>& from, int weight) {
    if (known_[vertex]) return;
    known_[vertex] = 1;
    guesses_.push_back({vertex, from, weight});
  }

  Sides sides_;
  std::vector<char> known_, reached_;
  std::vector<VertexGuess> guesses_;
};

}  // namespace

std::vector<VertexGuess> mesh_walk(const Mesh& mesh) { return Walk(mesh).run(); }

}  // namespace anisofront
