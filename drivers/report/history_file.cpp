#include "drivers/report/history_file.hpp"

#include <array>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

constexpr std::array kOfVariant{"name", "settings", "cycles", "stop_reason"};
constexpr std::array kOfCycle{
    "cycle", "vertices", "elements", "edges",       "triangles",         "boundary_edges",
    "quads", "dofs",     "quality",  "edge_length", "metric_complexity", "background",
    "error", "goal",     "values",   "seconds",     "warnings"};
constexpr std::array kOfStatistics{"/quality/against",
                                   "/quality/mean",
                                   "/quality/min",
                                   "/edge_length/min",
                                   "/edge_length/max",
                                   "/edge_length/in_0.5_1.5",
                                   "/edge_length/in_unit_band",
                                   "/edge_length/histogram/bounds",
                                   "/edge_length/histogram/counts"};
constexpr std::array kOfError{"estimate", "relative_energy", "effectivity"};

/// Refuses a history in which something that reports read is missing.
class HistoryCheck {
 public:
  explicit HistoryCheck(std::string file) : file_(std::move(file)) {}

  void check(const Json& history) const {
    if (!history.is_object() || history.value("schema", Json()) != 1) fail("schema 1");
    if (!history.value("title", Json()).is_string()) fail("a title");
    if (!history.value("variants", Json()).is_array()) fail("variants");
    for (const Json& variant : history["variants"]) check_variant(variant);
  }

 private:
  void check_variant(const Json& variant) const {
    for (const char* key : kOfVariant)
      if (!variant.is_object() || !variant.contains(key)) fail(fmt::format("variants: {}", key));
    if (!variant["name"].is_string() || !variant["settings"].is_object() ||
        !variant["cycles"].is_array() || !variant["stop_reason"].is_string())
      fail("variants with name, settings, cycles and stop_reason");
    for (const Json& cycle : variant["cycles"]) check_cycle(cycle);
  }

  void check_cycle(const Json& cycle) const {
    for (const char* key : kOfCycle)
      if (!cycle.is_object() || !cycle.contains(key)) fail(fmt::format("cycles: {}", key));
    for (const char* pointer : kOfStatistics)
      for (const Json& statistics : {cycle, cycle["background"]})
        if (!statistics.contains(Json::json_pointer(pointer)))
          fail(fmt::format("cycles: {}", pointer + 1));
    for (const char* key : kOfError)
      if (!cycle["error"].is_object() || !cycle["error"].contains(key))
        fail(fmt::format("cycles: error/{}", key));
  }

  [[noreturn]] void fail(const std::string& missing) const {
    throw InputError(file_ + ": damaged or of another program: expected " + missing +
                     "; `anisofront run` writes it anew");
  }

  std::string file_;
};

}  // namespace

Json read_history_file(const fs::path& directory) {
  const fs::path path = directory / "history.json";
  if (!fs::exists(path))
    throw UsageError(path.string() +
                     ": no such file; give a folder that `anisofront run` has left");
  Json history = Json::parse(read_text_file(path), nullptr, false);
  HistoryCheck(path.string()).check(history);
  if (!history.contains("comparison")) history["comparison"] = Json::array();
  return history;
}

}  // namespace anisofront
