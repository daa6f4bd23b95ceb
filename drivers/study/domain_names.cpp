#include "drivers/study/domain_names.hpp"

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

template <class Named>
Index tag_named(const std::vector<Named>& list, const char* kind, const std::string& name,
                const std::string& place) {
  std::vector<std::string> known;
  for (const Named& entry : list) {
    if (entry.name == name) return entry.tag;
    known.push_back(entry.name);
  }
  throw UsageError(
      fmt::format("{}: no {} is called \"{}\"{}", place, kind, name, name_proposal(name, known)));
}

}  // namespace

Index curve_tag(const Domain& domain, const std::string& name, const std::string& place) {
  return tag_named(domain.curves, "curve", name, place);
}

Index region_tag(const Domain& domain, const std::string& name, const std::string& place) {
  return tag_named(domain.regions, "region", name, place);
}

std::string curve_name(const Domain& domain, Index tag) {
  for (const DomainCurve& curve : domain.curves)
    if (curve.tag == tag) return curve.name;
  return {};
}

std::vector<Index> boundary_curves(const Domain& domain) {
  std::vector<int> regions(domain.curves.size(), 0);
  for (const DomainRegion& region : domain.regions)
    for (const Loop& loop : region.loops)
      for (const CurveUse& use : loop) ++regions[static_cast<std::size_t>(use.curve)];
  std::vector<Index> curves;
  for (std::size_t c = 0; c < regions.size(); ++c)
    if (regions[c] == 1) curves.push_back(static_cast<Index>(c));
  return curves;
}

}  // namespace anisofront
