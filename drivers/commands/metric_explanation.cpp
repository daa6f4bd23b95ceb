#include "drivers/commands/metric_explanation.hpp"

#include <cmath>

#include <spdlog/fmt/fmt.h>

#include "adapt/point_location.hpp"
#include "drivers/base/text_table.hpp"
#include "drivers/problem/adapt_setup.hpp"
#include "drivers/problem/loop_input.hpp"
#include "drivers/problem/prescribed_metric.hpp"
#include "drivers/run/cycle_files.hpp"

namespace anisofront {
namespace {

/// The study with the mesh of the question as its initial mesh.
Study asked_study(const Variant& variant, const MetricQuestion& question) {
  Study study = variant.study;
  study.adapt.stages = true;
  if (!question.mesh.empty()) study.initial = {question.mesh, 0};
  return study;
}

int asked_cycle(const Study& study, const MetricQuestion& question) {
  if (question.mesh.empty()) return 0;
  const int cycle = cycle_of(question.mesh.filename().string());
  return cycle >= 0 ? cycle : study.adapt.cycles;
}

void require_inside(const LoopInput& input, Point p) {
  // Meshes stay this close to curved boundaries (attach_to_domain()), as a share of the diagonal.
  constexpr double kTolerance = 1e-3;
  const FeMesh fe = curved_fe_mesh(input.initial, input.domain);
  const MetricField unit(input.initial.points.size(), Metric{1, 0, 1});
  const BackgroundMesh background(input.initial, unit);
  const Box& box = background.bounds();
  if (PointLocation(fe).find(p, kTolerance * norm(box.high - box.low))) return;
  const Point near = background.nearest(p).point;
  throw UsageError(fmt::format(
      "--at {},{}: lies outside the domain; the nearest point of it is --at {:.6g},{:.6g}", p.x,
      p.y, near.x, near.y));
}

MetricField sampled(const Mesh& mesh, const MetricFunction& metric) {
  MetricField field;
  for (const Point p : mesh.points) field.push_back(metric(p));
  return field;
}

std::string entry_name(std::size_t entry) { return fmt::format("prescribed[{}]", entry); }

/// A prescribed metric by its entries, intersected one after the other, and its limits.
std::vector<MetricStage> prescribed_stages(const Study& study, const LoopInput& input,
                                           const MetricField& final_field) {
  std::vector<MetricStage> stages;
  const auto add = [&](const std::string& name, const PrescribedMetric& metric,
                       const MetricLimits& limits) {
    stages.push_back(
        {name, sampled(input.initial, prescribed_metric(metric, input.domain, limits))});
  };
  PrescribedMetric part{study.metric->constants, {}, false};
  for (const DirectionalSizes& entry : study.metric->list) {
    part.list.push_back(entry);
    add(entry_name(part.list.size() - 1), part, {});
  }
  part.isotropic = study.metric->isotropic;
  if (part.isotropic) add("isotropic", part, {});
  const MetricLimits limits = prescribed_limits(study);
  if (limits.hmin > 0 || std::isfinite(limits.hmax))
    add("size limits", part, {.hmin = limits.hmin, .hmax = limits.hmax});
  if (std::isfinite(limits.stretch)) add("stretch limit", part, limits);
  if (limits.gradation > 1) stages.push_back({"gradation", final_field});
  return stages;
}

/// What stands in the entries of the list, one line each.
std::string prescribed_legend(const PrescribedMetric& metric) {
  std::string text;
  for (std::size_t i = 0; i < metric.list.size(); ++i) {
    const DirectionalSizes& entry = metric.list[i];
    text +=
        fmt::format("{}: h1 = \"{}\", h2 = \"{}\"", entry_name(i), entry.h1.text, entry.h2.text);
    if (entry.e1)
      text += fmt::format(", e1 = [\"{}\", \"{}\"]", (*entry.e1)[0].text, (*entry.e1)[1].text);
    text += fmt::format(" ({})\n", entry.place);
  }
  return text;
}

std::string decided_text(const StageSizes& stage) {
  if (stage.decided_h1 && stage.decided_h2) return "h1 h2";
  if (stage.decided_h1) return "h1";
  return stage.decided_h2 ? "h2" : "";
}

TextTable stage_table(const std::vector<StageSizes>& stages) {
  TextTable table;
  table.header = {"stage", "sets", "h1", "h2", "h2/h1", "direction of h1"};
  for (const StageSizes& s : stages) {
    const Vector e = s.e1.x < 0 || (s.e1.x == 0 && s.e1.y < 0) ? -s.e1 : s.e1;
    const auto shown = [](double value) { return std::round(1000 * value) / 1000 + 0.; };
    table.rows.push_back({s.stage, decided_text(s), fmt::format("{:.4g}", s.h1),
                          fmt::format("{:.4g}", s.h2), fmt::format("{:.2f}", s.h2 / s.h1),
                          fmt::format("({:.3f}, {:.3f})", shown(e.x), shown(e.y))});
    table.is_reference.push_back(false);
  }
  return table;
}

std::string formula_line(const MetricFunction& metric, Point p) {
  const PrincipalAxes axes = principal_axes(metric(p));
  return fmt::format(
      "The formulas themselves ask for {:.4g} and {:.4g} there; between the vertices of the mesh "
      "the metric is interpolated.\n",
      axes.h1, axes.h2);
}

}  // namespace

std::string explain_study_metric(const Variant& variant, const MetricQuestion& question,
                                 const Monitor& monitor) {
  const Study study = asked_study(variant, question);
  const LoopInput input = loop_input(study, monitor);
  require_inside(input, question.at);
  const int cycle = asked_cycle(study, question);
  const Analysis analysis = input.analyse(input.initial, cycle);
  for (const std::string& warning : analysis.warnings) monitor.warning(warning);
  const auto stages = explain_metric(
      input.initial,
      study.metric ? prescribed_stages(study, input, analysis.metric) : analysis.stages,
      question.at);
  std::string text =
      fmt::format("{} at ({:.6g}, {:.6g}), on the mesh of cycle {} ({} vertices):\n", variant.name,
                  question.at.x, question.at.y, cycle, input.initial.points.size());
  text += describe_stages(stages) + "\n";
  if (study.metric) text += formula_line(input.exact_metric, question.at);
  text += "\n" + as_text(stage_table(stages));
  if (study.metric) text += "\n" + prescribed_legend(*study.metric);
  return text;
}

}  // namespace anisofront
