#include "drivers/problem/adapt_setup.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/study/domain_names.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// The smallest size of plates as a share of the thickness: layers are t/3 wide.
constexpr double kLeastSizeOfPlates = 0.01;
constexpr double kGradationOfProblems = 3;

double longer_side(const Domain& domain) {
  const Box box = control_box(domain);
  return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

/// The longer side of the whole plate: a part cut along a line of symmetry counts twice.
double plate_length(const PlateProblemText& plate, const Domain& domain) {
  const bool is_part = std::any_of(plate.boundary.begin(), plate.boundary.end(),
                                   [](const PlateBoundaryText& boundary) {
                                     return boundary.support == SupportKind::symmetry ||
                                            boundary.support == SupportKind::antisymmetry;
                                   });
  return (is_part ? 2 : 1) * longer_side(domain);
}

double least_thickness(const PlateProblemText& plate) {
  double t = plate.material.thickness;
  for (const PlateRegionText& region : plate.regions) t = std::min(t, region.material.thickness);
  return t;
}

/// Decay exp(-sqrt(12 k) d / t) of the twist at soft supports and free edges (FE.md 3.2).
double layer_width(const PlateMaterial& material) {
  return material.thickness / std::sqrt(12 * material.shear_factor);
}

double least_layer_width(const PlateProblemText& plate) {
  double width = layer_width(plate.material);
  for (const PlateRegionText& region : plate.regions)
    width = std::min(width, layer_width(region.material));
  return width;
}

bool has_layer(SupportKind kind) {
  return kind == SupportKind::soft_support || kind == SupportKind::free;
}

void add_once(std::vector<Index>& tags, Index tag) {
  if (std::find(tags.begin(), tags.end(), tag) == tags.end()) tags.push_back(tag);
}

/// Soft supports and free edges; a boundary curve that no condition mentions is free.
std::vector<Index> layer_tags(const PlateProblemText& plate, const Domain& domain) {
  std::vector<Index> tags, held;
  for (const PlateBoundaryText& boundary : plate.boundary)
    add_once(has_layer(boundary.support) ? tags : held,
             curve_tag(domain, boundary.curve, boundary.place));
  for (const Index c : boundary_curves(domain)) {
    const Index tag = domain.curves[static_cast<std::size_t>(c)].tag;
    if (std::find(held.begin(), held.end(), tag) == held.end()) add_once(tags, tag);
  }
  return tags;
}

std::vector<Index> named_tags(const LayerText& layer, const Domain& domain) {
  std::vector<Index> tags;
  for (const std::string& name : *layer.curves)
    add_once(tags, curve_tag(domain, name, layer.place + ".curves"));
  return tags;
}

void require_complete(const LayerText& layer, const LayerSettings& settings) {
  const bool is_given = layer.curves || layer.width || layer.first_size || layer.reach ||
                        layer.growth || layer.metric;
  if (is_given && (!layer.curves || settings.width == 0))
    throw UsageError(layer.place +
                     ": expected curves = [\"NAME\", ...] and width = ..., the length over which "
                     "the layer decays by e (only those of plates are known)");
}

}  // namespace

Box control_box(const Domain& domain) {
  const Point first = domain.curves.front().curve.points.front();
  Box box{first, first};
  for (const DomainCurve& curve : domain.curves)
    for (const Point p : curve.curve.points) box = enclosing(box, p);
  return box;
}

MetricLimits prescribed_limits(const Study& study) {
  const LimitsText& text = study.adapt.limits;
  const MetricLimits none;
  return {.hmin = text.hmin.value_or(none.hmin),
          .hmax = text.hmax.value_or(none.hmax),
          .stretch = text.stretch.value_or(none.stretch),
          .gradation = study.preset == Preset::paper ? 0 : text.gradation.value_or(0)};
}

MetricLimits problem_limits(const Study& study, const Domain& domain) {
  const LimitsText& text = study.adapt.limits;
  MetricLimits limits = prescribed_limits(study);
  if (!text.gradation && study.preset != Preset::paper) limits.gradation = kGradationOfProblems;
  if (!study.plate) return limits;
  const double t = least_thickness(*study.plate);
  if (!text.hmin) limits.hmin = std::min(kLeastSizeOfPlates * t, limits.hmax);
  if (!text.stretch) limits.stretch = plate_stretch_limit(plate_length(*study.plate, domain), t);
  return limits;
}

LayerSettings layer_settings(const Study& study, const Domain& domain) {
  const LayerText& text = study.adapt.layer;
  LayerSettings layers;
  if (!text.is_on) return layers;
  if (study.plate) layers.width = least_layer_width(*study.plate);
  layers.width = text.width.value_or(layers.width);
  layers.first_size = text.first_size.value_or(layers.first_size);
  layers.reach = text.reach.value_or(layers.reach);
  layers.growth = text.growth.value_or(layers.growth);
  if (!study.plate) require_complete(text, layers);
  if (text.curves)
    layers.tags = named_tags(text, domain);
  else if (study.plate)
    layers.tags = layer_tags(*study.plate, domain);
  return layers;
}

std::optional<Goal> study_goal(const Study& study, const Domain& domain) {
  if (!study.adapt.goal) return {};
  const GoalText& text = *study.adapt.goal;
  Goal goal = text.goal;
  if (goal.kind == Goal::Kind::region_mean)
    goal.tag = region_tag(domain, text.name, text.place + ".region");
  if (goal.kind == Goal::Kind::curve_flux)
    goal.tag = curve_tag(domain, text.name, text.place + ".curve");
  return goal;
}

AdaptSettings adapt_settings(const Study& study, const Domain& domain) {
  const AdaptSection& adapt = study.adapt;
  AdaptSettings settings;
  settings.target = adapt.target;
  settings.density = {adapt.mode, adapt.norm, adapt.p, adapt.combination, adapt.curvature_floor};
  settings.limits = problem_limits(study, domain);
  settings.layers = layer_settings(study, domain);
  settings.align = adapt.align;
  settings.equidistribute = adapt.equidistribute;
  // Isotropic elements that resolve a layer from the start are as many as its length asks for.
  settings.layer_metric = adapt.layer.metric.value_or(adapt.mode == AdaptMode::anisotropic);
  settings.elements = study.elements;
  settings.use_goal = adapt.goal && adapt.goal->steers;
  settings.keep_stages = adapt.stages;
  return settings;
}

}  // namespace anisofront
