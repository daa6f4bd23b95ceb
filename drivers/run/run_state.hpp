#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adapt/loop.hpp"
#include "drivers/study/study_file.hpp"

namespace anisofront {

/// What decides the results of a variant, as 16 hexadecimal digits: the study with the values of
/// the variant, the contents of the files it reads (meshes, references of lines), and the version
/// of the program.
/// Throws UsageError when such a file does not exist.
std::string variant_key(const StudyFile& study, const Variant& variant);

/// What a variant leaves on disk beside its meshes, so that it can be gone on with.
struct RunRecord {
  std::string key;
  bool is_finished = false;
  VariantHistory history;            ///< all cycles whose files are complete
  std::vector<std::string> digests;  ///< of cycle-K.msh, per cycle (file_digest())
};

/// Writes record.json into the folder of a variant, under a temporary name first. To be called when
/// the files of a cycle are complete: a run that is killed loses no more than the cycle at work.
void write_record(const std::filesystem::path& folder, const RunRecord& record);

/// From now on the folder counts as empty: nothing of it will be gone on with.
void remove_record(const std::filesystem::path& folder);

/// What an earlier run has left in the folder of a variant.
struct EarlierRun {
  enum class State { none, other_settings, unfinished, finished };
  State state = State::none;
  RunRecord record;                   ///< cut after the last intact cycle
  std::vector<FinishedCycle> cycles;  ///< the same with their meshes; empty when finished
  std::string damage;                 ///< what was wrong with the files, or empty
};

/// Never throws for damaged or missing files: a cycle whose mesh is not what the record says is
/// left out with all that follow, and the run counts as unfinished.
EarlierRun read_earlier_run(const std::filesystem::path& folder, const std::string& key);

/// FNV-1a of the bytes of a file, 16 hexadecimal digits.
/// Throws UsageError when there is no such file and InputError when it cannot be read.
std::string file_digest(const std::filesystem::path& path);

/// "cycle-3.msh".
std::string cycle_mesh_name(int cycle);

}  // namespace anisofront
