#include "mesher/generate.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>

#include "mesher/background/background_mesh.hpp"
#include "mesher/enhance/required_points.hpp"
#include "mesher/geometry/error.hpp"
#include "mesher/mesh/check.hpp"
#include "mesher/metric/gradation.hpp"

namespace anisofront {
namespace {

/// CPU time of this thread: variants of a study may run side by side.
double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Adds the time since its construction to a phase.
class PhaseTimer {
 public:
  explicit PhaseTimer(double& seconds) : seconds_(seconds), start_(cpu_seconds()) {}
  ~PhaseTimer() { seconds_ += cpu_seconds() - start_; }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double& seconds_;
  double start_;
};

/// A unit equilateral triangle has area sqrt(3)/4.
double expected_triangles(const BackgroundMesh& background) {
  return 4 / std::sqrt(3.) * background.complexity();
}

void require_budget(double expected, std::int64_t limit) {
  if (expected <= static_cast<double>(limit)) return;
  throw BudgetError("the metric asks for about " +
                    std::to_string(static_cast<std::int64_t>(std::min(expected, 9e18))) +
                    " elements, more than the limit of " + std::to_string(limit) +
                    "; ask for larger sizes or raise the limit");
}

std::vector<PhysicalGroup> groups_of(const Domain& domain) {
  std::vector<PhysicalGroup> groups;
  const auto add = [&](int dimension, Index tag, const std::string& name) {
    if (tag == 0 || name.empty()) return;
    for (const PhysicalGroup& g : groups)
      if (g.dimension == dimension && g.tag == tag) return;
    groups.push_back({dimension, tag, name});
  };
  for (const DomainPoint& p : domain.points) add(0, p.tag, p.name);
  for (const DomainCurve& c : domain.curves) add(1, c.tag, c.name);
  for (const DomainRegion& r : domain.regions) add(2, r.tag, r.name);
  return groups;
}

/// Region of each triangle, spread from the segments over the neighbours.
std::vector<Index> triangle_regions(const WorkMesh& work) {
  std::vector<Index> region(work.triangles.size(), kNoIndex);
  std::vector<Index> queue;
  for (std::size_t t = 0; t < work.triangles.size(); ++t) {
    const WorkTriangle& triangle = work.triangles[t];
    for (int k = 0; k < 3 && !triangle.dead(); ++k) {
      if (triangle.neighbours[k] >= 0) continue;
      const Segment& s = work.segments[~triangle.neighbours[k]];
      region[t] = triangle.vertices[kNext[k]] == s.a ? s.left_region : s.right_region;
      queue.push_back(static_cast<Index>(t));
      break;
    }
  }
  while (!queue.empty()) {
    const Index t = queue.back();
    queue.pop_back();
    for (const Index n : work.triangles[t].neighbours) {
      if (n < 0 || region[n] != kNoIndex) continue;
      region[n] = region[t];
      queue.push_back(n);
    }
  }
  return region;
}

/// Numbers of the vertices in the result: those in use, in order of creation.
std::vector<Index> compact_numbers(const WorkMesh& work) {
  std::vector<Index> number(work.vertices.size(), kNoIndex);
  for (const WorkTriangle& t : work.triangles)
    if (!t.dead())
      for (const Index v : t.vertices) number[v] = 0;
  Index next = 0;
  for (Index& n : number)
    if (n != kNoIndex) n = next++;
  return number;
}

void add_curve_edges(const Domain& domain, const WorkMesh& work, const std::vector<Index>& number,
                     Mesh& mesh) {
  for (const Segment& s : work.segments) {
    CurveEdge edge{{number[s.a], number[s.b]},
                   domain.curves[s.curve].tag,
                   s.curve,
                   {s.parameter_a, s.parameter_b}};
    if (s.left_region == kNoIndex) {  // the domain lies to the left of boundary edges
      std::swap(edge.vertices[0], edge.vertices[1]);
      std::swap(edge.parameters[0], edge.parameters[1]);
    }
    mesh.edges.push_back(edge);
  }
}

/// Ends of open curves are corners.
void add_corners(const Domain& domain, Mesh& mesh) {
  for (const CurveEdge& edge : mesh.edges) {
    const NurbsCurve& curve = domain.curves[edge.curve].curve;
    if (is_closed(curve)) continue;
    for (int k = 0; k < 2; ++k)
      if (edge.parameters[k] == curve.begin_parameter() ||
          edge.parameters[k] == curve.end_parameter())
        mesh.corners.push_back(edge.vertices[k]);
  }
  std::sort(mesh.corners.begin(), mesh.corners.end());
  mesh.corners.erase(std::unique(mesh.corners.begin(), mesh.corners.end()), mesh.corners.end());
}

void add_points(const Domain& domain, const std::vector<Index>& point_vertices,
                const std::vector<Index>& number, Mesh& mesh) {
  for (std::size_t i = 0; i < domain.points.size(); ++i) {
    const Index v = number[point_vertices[i]];
    mesh.required_vertices.push_back(v);
    if (domain.points[i].tag == 0) continue;
    mesh.vertex_tags.resize(mesh.points.size(), 0);
    mesh.vertex_tags[v] = domain.points[i].tag;
  }
}

GenerateResult collect(const Domain& domain, const WorkMesh& work,
                       const std::vector<Index>& point_vertices) {
  GenerateResult result;
  Mesh& mesh = result.mesh;
  const std::vector<Index> number = compact_numbers(work);
  mesh.points.reserve(work.vertices.size());
  result.metric.reserve(work.vertices.size());
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNoIndex) continue;
    mesh.points.push_back(work.vertices[v].p);
    result.metric.push_back(metric_of(work.vertices[v].r));
  }
  const std::vector<Index> region = triangle_regions(work);
  mesh.triangles.reserve(work.triangles.size());
  mesh.triangle_regions.reserve(work.triangles.size());
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (work.triangles[t].dead()) continue;
    const auto& v = work.triangles[t].vertices;
    mesh.triangles.push_back({number[v[0]], number[v[1]], number[v[2]]});
    mesh.triangle_regions.push_back(domain.regions[region[t]].tag);
  }
  mesh.groups = groups_of(domain);
  add_curve_edges(domain, work, number, mesh);
  add_corners(domain, mesh);
  add_points(domain, point_vertices, number, mesh);
  return result;
}

/// Domain points inside regions become vertices; those on curves are vertices already.
void insert_inner_points(const Domain& domain, Patch& patch, std::vector<Index>& point_vertices) {
  std::vector<Point> inner;
  for (std::size_t i = 0; i < point_vertices.size(); ++i)
    if (point_vertices[i] == kNoIndex) inner.push_back(domain.points[i].point);
  const std::vector<Index> inserted = insert_required_points(patch, inner);
  std::size_t next = 0;
  for (Index& v : point_vertices)
    if (v == kNoIndex) v = inserted[next++];
}

}  // namespace

GenerateOptions generate_options(Preset preset) {
  GenerateOptions options;
  options.preset = preset;
  if (preset == Preset::best) return options;
  options.interpolation = Interpolation::simultaneous_reduction;
  options.boundary.over_old_segments = true;
  options.front = paper_front_options();
  options.enhance.paper = true;
  return options;
}

GenerateResult generate(const Domain& domain, const Mesh& background_mesh, const MetricField& field,
                        const GenerateOptions& options, const Monitor& monitor) {
  PhaseSeconds seconds;
  std::optional<BackgroundMesh> background;
  {
    const PhaseTimer timer(seconds.background);
    validate(domain);
    MetricField limited = field;
    if (options.gradation > 1) limit_gradation(background_mesh, limited, options.gradation);
    background.emplace(background_mesh, limited, options.interpolation);
  }
  const double expected = expected_triangles(*background);
  require_budget(expected, options.max_elements);
  Boundary boundary;
  {
    const PhaseTimer timer(seconds.boundary);
    boundary = discretise_boundary(domain, background_mesh, *background, options.boundary,
                                   options.max_elements, monitor);
  }
  WorkMesh& work = boundary.mesh;
  work.triangles.reserve(static_cast<std::size_t>(1.15 * expected) + 64);
  work.vertices.reserve(static_cast<std::size_t>(0.58 * expected) + work.vertices.size() + 64);
  FrontStatistics front;
  {
    const PhaseTimer timer(seconds.front);
    front = advance_front(*background, work, options.front, expected, monitor);
  }
  EnhanceStatistics statistics;
  {
    const PhaseTimer timer(seconds.enhance);
    std::vector<Index> required;
    for (const Index v : boundary.point_vertices)
      if (v != kNoIndex) required.push_back(v);
    Patch patch = make_patch(*background, work, required);
    insert_inner_points(domain, patch, boundary.point_vertices);
    enhance(patch, options.enhance, monitor);
    statistics = patch.statistics;
  }
  background.reset();
  GenerateResult result;
  {
    const PhaseTimer timer(seconds.verify);
    result = collect(domain, work, boundary.point_vertices);
    require_valid(result.mesh);
  }
  result.front = front;
  result.enhance = statistics;
  result.seconds = seconds;
  return result;
}

}  // namespace anisofront
