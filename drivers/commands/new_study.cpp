#include "drivers/commands/new_study.hpp"

#include "drivers/base/json.hpp"
#include "drivers/base/text.hpp"
#include "drivers/commands/study_templates.hpp"
#include "drivers/problem/loop_input.hpp"
#include "drivers/study/toml_table.hpp"
#include "mesher/io/mesh_io.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

const StudyTemplate& asked_template(const NewStudy& wish, const fs::path& study) {
  const std::string kind = wish.kind.empty() ? study.stem().string() : wish.kind;
  for (const StudyTemplate& candidate : study_templates())
    if (candidate.kind == kind) return candidate;
  return study_templates().front();
}

/// "floor" and "floor.toml" are the same; "floor-0.1" keeps its dot.
fs::path study_path(const std::string& name) {
  const fs::path path = name.ends_with(".toml") ? name : name + ".toml";
  if (path.stem().empty() || path.filename() == ".toml")
    throw UsageError("\"" + name + "\": expected a name for the study, such as floor");
  const fs::path folder = path.parent_path();
  if (!folder.empty() && !fs::is_directory(folder))
    throw UsageError(folder.string() + ": no such folder (for " + path.string() + ")");
  return path;
}

void refuse_existing(const fs::path& path) {
  if (fs::exists(path))
    throw UsageError(path.string() +
                     ": exists and is not overwritten; give another name, or remove it first");
}

/// A text of a TOML file is written as in JSON (TOML 1.0.0, "String").
std::string toml_text(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

void replace(std::string& text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), by);
}

}  // namespace

std::vector<fs::path> write_new_study(const NewStudy& wish, const Monitor& monitor) {
  const fs::path path = study_path(wish.name);
  const StudyTemplate& chosen = asked_template(wish, path);
  refuse_existing(path);
  std::string text = chosen.text;
  std::vector<fs::path> written{path};
  if (!chosen.mesh_source.empty()) {
    fs::path mesh = path;
    mesh.replace_extension(".msh");
    refuse_existing(mesh);
    const Study source = parse_study(parse_toml(chosen.mesh_source, "mesh"), "mesh");
    write_mesh_file(mesh, {study_start(source, InitialElements::triangles, monitor).mesh, {}, {}});
    replace(text, "@MESH@", toml_text(mesh.filename().string()));
    written.push_back(mesh);
  }
  write_text_file(path, text);
  return written;
}

}  // namespace anisofront
