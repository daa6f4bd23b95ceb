#include "drivers/report/page_meshes.hpp"

#include <algorithm>
#include <future>
#include <span>
#include <thread>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/base64.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

/// A variant of a run whose meshes are wanted.
struct MeshSource {
  Json* variant;
  std::string id;  ///< start of the ids of its meshes
  fs::path folder;
  Interpolation interpolation;
};

/// As the study says for the variant or for all, else the default of the preset.
Interpolation interpolation_of(const Json& run, const Json& variant) {
  const Json& settings = variant["settings"];
  Json name = settings.value("mesh.interpolation", run.value("interpolation", Json()));
  if (name.is_null() && settings.value("mesh.preset", Json()) == "paper")
    name = "simultaneous-reduction";
  if (name == "simultaneous-reduction") return Interpolation::simultaneous_reduction;
  return name == "log-euclidean" ? Interpolation::log_euclidean : Interpolation::linear_size;
}

/// The sources with their cycles listed.
std::vector<MeshSource> sources_of(Json& runs, const std::vector<fs::path>& folders) {
  std::vector<MeshSource> sources;
  for (std::size_t r = 0; r < runs.size(); ++r)
    for (std::size_t v = 0; v < runs[r]["variants"].size(); ++v) {
      Json& variant = runs[r]["variants"][v];
      variant["meshes"] = Json::array();
      for (const Json& cycle : variant["cycles"])
        variant["meshes"].push_back({{"cycle", cycle["cycle"]}, {"id", nullptr}});
      sources.push_back({&variant, fmt::format("mesh-{}-{}", r, v),
                         folders[r] / variant["name"].get<std::string>(),
                         interpolation_of(runs[r], variant)});
    }
  return sources;
}

/// A mesh that is wanted: its entry in the data, {"cycle", "id": null} so far.
struct MeshTask {
  Json* entry;
  const MeshSource* source;
  std::size_t vertices;

  int cycle() const { return entry->at("cycle"); }
};

/// The last cycles of all sources, then the others.
std::vector<MeshTask> tasks_of(const std::vector<MeshSource>& sources) {
  std::vector<MeshTask> last, others;
  for (const MeshSource& source : sources) {
    Json& entries = (*source.variant)["meshes"];
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const std::size_t vertices = (*source.variant)["cycles"][i]["vertices"];
      (i + 1 == entries.size() ? last : others).push_back({&entries[i], &source, vertices});
    }
  }
  last.insert(last.end(), others.begin(), others.end());
  return last;
}

/// Meshes are read and packed by all cores but put on the page in order.
class MeshBudget {
 public:
  MeshBudget(std::size_t max_bytes, const MeshEncoder& encode)
      : left_(max_bytes), encode_(encode) {}

  void add(std::span<const MeshTask> tasks) {
    const std::size_t at_once = std::max(1u, std::thread::hardware_concurrency());
    for (; !tasks.empty(); tasks = tasks.subspan(std::min(at_once, tasks.size())))
      add_at_once(tasks.first(std::min(at_once, tasks.size())));
  }

  std::vector<PageMesh> meshes;

 private:
  /// What the page gets for a mesh, or why it gets nothing.
  struct Packed {
    std::string text, note;
  };

  void add_at_once(std::span<const MeshTask> tasks) {
    std::vector<std::future<Packed>> packed;
    for (const MeshTask& task : tasks)
      packed.push_back(std::async(std::launch::async, [this, task] { return pack(task); }));
    for (std::size_t i = 0; i < tasks.size(); ++i) place(tasks[i], packed[i].get());
  }

  Packed pack(const MeshTask& task) const {
    constexpr std::size_t kLeastBytesPerVertex = 2;
    if (task.vertices * kLeastBytesPerVertex > left_) return {{}, left_out(task)};
    try {
      return {base64(encode_(task.source->folder, task.cycle(), task.source->interpolation)), {}};
    } catch (const Error& error) {
      return {{}, error.what()};
    }
  }

  static std::string left_out(const MeshTask& task) {
    return fmt::format("left out to keep the page small; it lies in {}/cycle-{}.msh",
                       task.source->folder.filename().string(), task.cycle());
  }

  void place(const MeshTask& task, Packed packed) {
    Json& entry = *task.entry;
    if (packed.text.size() > left_) packed = {{}, left_out(task)};
    if (packed.text.empty()) {
      entry["note"] = packed.note;
      return;
    }
    left_ -= packed.text.size();
    entry["id"] = fmt::format("{}-{}", task.source->id, task.cycle());
    meshes.push_back({entry["id"], std::move(packed.text)});
  }

  std::size_t left_;
  const MeshEncoder& encode_;
};

}  // namespace

std::vector<PageMesh> add_meshes(Json& runs, const std::vector<fs::path>& folders,
                                 std::size_t max_bytes, const MeshEncoder& encode) {
  MeshBudget budget(max_bytes, encode);
  const std::vector<MeshSource> sources = sources_of(runs, folders);
  budget.add(tasks_of(sources));
  return std::move(budget.meshes);
}

}  // namespace anisofront
