#include "drivers/run/run_state.hpp"

#include <cstdint>
#include <sstream>

#include <spdlog/fmt/fmt.h>

#include "drivers/base/text.hpp"
#include "drivers/history/history_json.hpp"
#include "drivers/study/toml_table.hpp"
#include "mesher/io/gmsh.hpp"
#include "mesher/io/mapped_file.hpp"

namespace anisofront {
namespace {

namespace fs = std::filesystem;

constexpr int kSchema = 1;

/// FNV-1a with 64 bits: G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake,
/// draft-eastlake-fnv (2019), section 5.
std::string digest(std::string_view bytes) {
  constexpr std::uint64_t kOffset = 0xcbf29ce484222325u, kPrime = 0x100000001b3u;
  std::uint64_t hash = kOffset;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  return fmt::format("{:016x}", hash);
}

fs::path record_path(const fs::path& folder) { return folder / "record.json"; }

void erase_key(toml::table& root, const char* section, const char* key) {
  if (toml::table* table = root.get_as<toml::table>(section)) table->erase(key);
}

/// The study without what does not change the results of this variant: title, names of files
/// (their contents count) and the other variants.
std::string common_text(const StudyFile& study) {
  toml::table root = parse_toml(study.resolved, study.path.string());
  root.erase("title");
  root.erase("vary");
  erase_key(root, "domain", "mesh");
  erase_key(root, "mesh", "initial");
  change_reference_files(root, [](const std::string&) { return std::string(); });
  std::ostringstream stream;
  stream << toml::toml_formatter{root} << '\n';
  return stream.str();
}

/// In a fixed order, empty where the study names none.
std::vector<fs::path> files_read_by(const Study& study) {
  std::vector<fs::path> files{study.domain_mesh, study.initial.file};
  for (const LineRequest& line : study.output.lines)
    if (line.reference && !line.reference->file.empty())
      files.push_back(beside_study(study.file, line.reference->file));
  return files;
}

Json record_json(const RunRecord& record) {
  return {{"schema", kSchema},
          {"key", record.key},
          {"finished", record.is_finished},
          {"meshes", record.digests},
          {"variant", variant_json(record.history, record.key)}};
}

RunRecord read_record(const fs::path& path) {
  const Json json = Json::parse(read_text_file(path));
  RunRecord record;
  record.key = json.at("key");
  record.is_finished = json.at("finished");
  record.digests = json.at("meshes").get<std::vector<std::string>>();
  if (json.at("schema") == kSchema) record.history = variant_history(json.at("variant"));
  return record;
}

/// Empty for a mesh that is what the record says, else what is wrong with it.
std::string mesh_damage(const fs::path& folder, const RunRecord& record, std::size_t cycle) {
  const fs::path path = folder / cycle_mesh_name(static_cast<int>(cycle));
  if (cycle >= record.digests.size() ||
      record.history.cycles[cycle].cycle != static_cast<int>(cycle))
    return record_path(folder).string() + " contradicts itself";
  if (!fs::exists(path)) return path.string() + " is missing";
  if (file_digest(path) != record.digests[cycle]) return path.string() + " has been changed";
  return {};
}

/// Cuts the record before the first cycle whose mesh is damaged.
void keep_intact_cycles(const fs::path& folder, EarlierRun& earlier) {
  RunRecord& record = earlier.record;
  std::size_t intact = 0;
  for (; intact < record.history.cycles.size() && earlier.damage.empty(); ++intact)
    earlier.damage = mesh_damage(folder, record, intact);
  if (earlier.damage.empty()) return;
  --intact;
  record.is_finished = false;
  record.history.cycles.resize(intact);
  record.digests.resize(std::min(intact, record.digests.size()));
}

std::vector<FinishedCycle> with_meshes(const fs::path& folder, const RunRecord& record) {
  std::vector<FinishedCycle> cycles;
  for (const CycleRecord& cycle : record.history.cycles)
    cycles.push_back({cycle, read_gmsh(folder / cycle_mesh_name(cycle.cycle)).mesh});
  return cycles;
}

EarlierRun intact_run(const fs::path& folder, const std::string& key) {
  EarlierRun earlier;
  earlier.record = read_record(record_path(folder));
  if (earlier.record.key != key) {
    earlier.state = EarlierRun::State::other_settings;
    return earlier;
  }
  keep_intact_cycles(folder, earlier);
  if (earlier.record.history.cycles.empty())
    return {.state = EarlierRun::State::none, .record = {}, .cycles = {}, .damage = earlier.damage};
  earlier.state =
      earlier.record.is_finished ? EarlierRun::State::finished : EarlierRun::State::unfinished;
  if (!earlier.record.is_finished) earlier.cycles = with_meshes(folder, earlier.record);
  return earlier;
}

}  // namespace

std::string variant_key(const StudyFile& study, const Variant& variant) {
  std::string text = "anisofront " ANISOFRONT_VERSION "\n" + common_text(study);
  for (const Override& value : variant.values) text += value.key + " = " + value.value + "\n";
  for (const fs::path& file : files_read_by(variant.study))
    text += file.empty() ? "-\n" : file_digest(file) + "\n";
  return digest(text);
}

void write_record(const fs::path& folder, const RunRecord& record) {
  write_text_file(record_path(folder),
                  record_json(record).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void remove_record(const fs::path& folder) { fs::remove(record_path(folder)); }

EarlierRun read_earlier_run(const fs::path& folder, const std::string& key) {
  if (!fs::exists(record_path(folder))) return {};
  EarlierRun nothing;
  try {
    return intact_run(folder, key);
  } catch (const Json::exception& error) {
    nothing.damage = record_path(folder).string() + " is damaged";
  } catch (const Error& error) {
    nothing.damage = error.what();
  }
  return nothing;
}

std::string file_digest(const fs::path& path) { return digest(MappedFile(path).bytes()); }

std::string cycle_mesh_name(int cycle) { return fmt::format("cycle-{}.msh", cycle); }

}  // namespace anisofront
