#include "drivers/problem/watched_lines.hpp"

#include <memory>
#include <utility>

#include "drivers/problem/samples.hpp"
#include "mesher/geometry/stopwatch.hpp"

namespace anisofront {
namespace {

Profile profile_of(const WatchedLine& watched, const FeMesh& mesh, const PointState& state) {
  const SampleLine line{watched.name, watched.line, nearest_places(watched.line.points, mesh)};
  return {watched.name, sample_line(line, state), watched.reference};
}

}  // namespace

std::vector<WatchedLine> watched_lines(const Study& study, const Domain& domain) {
  std::vector<WatchedLine> lines;
  for (const LineRequest& request : study.output.lines) {
    LinePoints line = line_points(request, domain);
    std::optional<NumberTable> reference = line_reference(study, request, line);
    lines.push_back({request.name, std::move(line), std::move(reference)});
  }
  return lines;
}

Model with_profiles(Model model, std::vector<WatchedLine> lines) {
  if (lines.empty()) return model;
  const auto shared = std::make_shared<const std::vector<WatchedLine>>(std::move(lines));
  return [model = std::move(model), shared](const FeMesh& mesh, const Monitor& monitor) {
    SolvedModel solved = model(mesh, monitor);
    Stopwatch watch;
    for (const WatchedLine& line : *shared)
      solved.profiles.push_back(profile_of(line, mesh, solved.state));
    solved.aside_seconds += watch.lap();
    return solved;
  };
}

}  // namespace anisofront
