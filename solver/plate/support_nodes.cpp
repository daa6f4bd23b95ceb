#include "solver/plate/support_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "mesher/geometry/error.hpp"
#include "solver/plate/nearest_vertex.hpp"
#include "solver/plate/plate_text.hpp"
#include "solver/space/reference_quadrature.hpp"

namespace anisofront {
namespace {

/// Directions that differ by a smaller angle are one.
constexpr double kSameDirection = 1e-6;
/// Chords that turn by less (cosine of 30 degrees) approximate a smooth curve.
constexpr double kSmoothCosine = 0.8660254037844386;
/// Tangents that leave the chord by less are those of the chord.
constexpr double kAlongChord = 1e-9;
/// Deflections contradict each other beyond this share of the largest one prescribed.
constexpr double kSameDeflection = 1e-9;
/// Of the quadrature that takes the mean of a deflection along an edge.
constexpr int kMeanDegree = 5;

Vector unit(Vector v) { return (1 / norm(v)) * v; }

/// The end of a supported curve edge at a vertex.
struct EdgeEnd {
  std::size_t support;
  Vector away;    ///< unit tangent, away from the vertex
  double length;  ///< of the chord
  bool is_chord;  ///< the tangent is that of the chord
};

/// What meets in a vertex.
struct VertexSupports {
  std::vector<EdgeEnd> ends;
  std::vector<const PlatePointSupport*> points;
};

EdgeEnd edge_end(const FeMesh& mesh, std::size_t curve_edge, int end, std::size_t support) {
  const auto& [a, b] = mesh.mesh.edges[curve_edge].vertices;
  const Vector chord = mesh.mesh.points[b] - mesh.mesh.points[a];
  const Vector tangent = mesh.curve_tangents[curve_edge][end];
  const double length = norm(chord);
  return {support, end == 0 ? tangent : -tangent, length,
          std::abs(cross(tangent, chord)) <= kAlongChord * length};
}

void add_direction(Vector direction, std::vector<Vector>& directions) {
  for (const Vector d : directions)
    if (std::abs(cross(d, direction)) <= kSameDirection) return;
  // Two directions span the plane; a third adds nothing.
  if (directions.size() < 2) directions.push_back(direction);
}

void add_rotation(HeldRotation held, SupportNode& node) {
  for (const Vector d : held.directions) add_direction(d, node.directions);
  node.rotations.push_back(std::move(held));
}

/// Two chords that stand for a smooth curve: their turn is small.
bool is_smooth_joint(const std::vector<EdgeEnd>& ends, bool is_corner) {
  return ends.size() == 2 && !is_corner && ends[0].is_chord && ends[1].is_chord &&
         -dot(ends[0].away, ends[1].away) > kSmoothCosine;
}

/// The tangent of the circle through the three vertices of two chords, to second order: the longer
/// chord has the lesser weight.
Vector mean_tangent(const EdgeEnd& first, const EdgeEnd& second) {
  return unit(second.length * first.away - first.length * second.away);
}

class SupportGathering {
 public:
  SupportGathering(const FeMesh& mesh, PlateElement element, const PlateProblem& problem)
      : mesh_(mesh),
        problem_(problem),
        at_vertex_(vertex_components(element)),
        at_edge_(edge_components(element)) {
    result_.smooth_joints.assign(problem.supports.size(), 0);
  }

  SupportNodes run() {
    add_vertices();
    add_edges();
    require_consistent();
    return std::move(result_);
  }

 private:
  /// Ordered by vertex; ends in the order of the supports.
  std::map<Index, VertexSupports> meetings() const {
    std::map<Index, VertexSupports> meetings;
    for (std::size_t s = 0; s < problem_.supports.size(); ++s) {
      if (problem_.supports[s].kind == SupportKind::free) continue;
      for (std::size_t i = 0; i < mesh_.mesh.edges.size(); ++i) {
        const CurveEdge& edge = mesh_.mesh.edges[i];
        if (edge.tag != problem_.supports[s].tag) continue;
        for (const int end : {0, 1})
          meetings[edge.vertices[end]].ends.push_back(edge_end(mesh_, i, end, s));
      }
    }
    for (const PlatePointSupport& point : problem_.point_supports)
      meetings[nearest_vertex(mesh_, point.at, "the point support")].points.push_back(&point);
    return meetings;
  }

  void add_vertices() {
    std::vector<char> is_corner(mesh_.mesh.points.size(), 0);
    for (const Index v : mesh_.mesh.corners) is_corner[v] = 1;
    for (const auto& [vertex, meeting] : meetings()) {
      SupportNode node{vertex, false, mesh_.mesh.points[vertex], {}, {}, {}};
      for (std::size_t s = 0; s < problem_.supports.size(); ++s) {
        std::vector<EdgeEnd> ends;
        for (const EdgeEnd& end : meeting.ends)
          if (end.support == s) ends.push_back(end);
        if (!ends.empty())
          hold(s, kNoIndex, tangents(s, ends, is_corner[vertex]), at_vertex_, node);
      }
      for (const PlatePointSupport* point : meeting.points) hold(*point, node);
      add(std::move(node));
    }
  }

  void add_edges() {
    if (at_edge_.w < 0 && at_edge_.rotation < 0) return;
    std::map<Index, SupportNode> nodes;
    for (std::size_t s = 0; s < problem_.supports.size(); ++s)
      for (std::size_t i = 0; i < mesh_.mesh.edges.size(); ++i) {
        if (mesh_.mesh.edges[i].tag != problem_.supports[s].tag) continue;
        const Index edge = mesh_.edges.curve_edges[i];
        SupportNode& node = nodes[edge];
        node.number = edge;
        node.on_edge = true;
        node.at = mesh_.edge_points[edge];
        const auto curve_edge = static_cast<Index>(i);
        hold(s, curve_edge, {curve_point(mesh_, curve_edge, 0.5).tangent}, at_edge_, node);
      }
    for (auto& [edge, node] : nodes) add(std::move(node));
  }

  /// Tangents at a vertex of the curve edges of one support.
  std::vector<Vector> tangents(std::size_t support, const std::vector<EdgeEnd>& ends,
                               bool is_corner) {
    if (is_smooth_joint(ends, is_corner)) {
      if (std::abs(cross(ends[0].away, ends[1].away)) > kSameDirection)
        ++result_.smooth_joints[support];
      return {mean_tangent(ends[0], ends[1])};
    }
    std::vector<Vector> tangents;
    for (const EdgeEnd& end : ends) tangents.push_back(end.away);
    return tangents;
  }

  /// `curve_edge` kNoIndex: at a vertex.
  void hold(std::size_t s, Index curve_edge, const std::vector<Vector>& tangents,
            PlateComponents components, SupportNode& node) const {
    const PlateSupport& support = problem_.supports[s];
    const HeldComponents holds = held_components(support.kind);
    if (holds.deflection && components.w >= 0)
      node.deflections.push_back({support.tag, deflection(support, curve_edge, node.at)});
    if (components.rotation < 0 || !(holds.normal_rotation || holds.tangential_rotation)) return;
    HeldRotation held{support.tag, {}};
    for (const Vector t : tangents) {
      if (holds.normal_rotation) add_direction({t.y, -t.x}, held.directions);
      if (holds.tangential_rotation) add_direction(t, held.directions);
    }
    add_rotation(std::move(held), node);
  }

  /// At the node or, where edges alone carry w (Crouzeix-Raviart), the mean along the edge.
  double deflection(const PlateSupport& support, Index curve_edge, Point at) const {
    const auto value = [&](Point p) {
      return finite_value(support.deflection, p, "the prescribed deflection");
    };
    if (curve_edge == kNoIndex || at_vertex_.w >= 0) return value(at);
    double integral = 0, length = 0;
    for (const auto& [t, weight] : edge_quadrature(kMeanDegree)) {
      const CurvePoint point = curve_point(mesh_, curve_edge, t);
      integral += weight * point.speed * value(point.x);
      length += weight * point.speed;
    }
    return integral / length;
  }

  void hold(const PlatePointSupport& point, SupportNode& node) const {
    if (at_vertex_.w < 0)
      throw UsageError("these elements have no deflection at vertices, a point support at " +
                       describe(point.at) + " cannot hold them: use mitc elements");
    node.deflections.push_back({0, point.deflection});
    if (point.holds_rotations) add_rotation({0, {{1, 0}, {0, 1}}}, node);
  }

  void add(SupportNode node) {
    if (!node.deflections.empty() || !node.directions.empty())
      result_.nodes.push_back(std::move(node));
  }

  std::string name_of(Index tag) const {
    return tag == 0 ? "a point support" : describe_tag(mesh_.mesh, 1, tag);
  }

  void require_consistent() const {
    double scale = 0;
    for (const SupportNode& node : result_.nodes)
      for (const auto& [tag, value] : node.deflections) scale = std::max(scale, std::abs(value));
    for (const SupportNode& node : result_.nodes)
      for (const auto& [tag, value] : node.deflections) {
        const HeldDeflection& first = node.deflections.front();
        if (std::abs(value - first.value) <= kSameDeflection * scale) continue;
        throw InputError("at " + describe(node.at) + " the deflection is held at " +
                         describe(first.value) + " by " + name_of(first.tag) + " and at " +
                         describe(value) + " by " + name_of(tag) +
                         ", expected one value where supports meet");
      }
  }

  const FeMesh& mesh_;
  const PlateProblem& problem_;
  PlateComponents at_vertex_, at_edge_;
  SupportNodes result_;
};

}  // namespace

SupportNodes support_nodes(const FeMesh& mesh, PlateElement element, const PlateProblem& problem) {
  return SupportGathering(mesh, element, problem).run();
}

NodeUnknowns unknowns_of(const SupportNode& node, const DofMap& dofs, PlateElement element) {
  if (node.on_edge) return {dofs.at_edge(node.number), edge_components(element)};
  return {dofs.at_vertex(node.number), vertex_components(element)};
}

}  // namespace anisofront
