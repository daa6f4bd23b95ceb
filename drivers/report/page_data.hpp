#pragma once

#include <filesystem>
#include <string>

#include "drivers/base/json.hpp"

namespace anisofront {

/// A results folder and what the page calls it.
struct ReportRun {
  std::string name;
  std::filesystem::path directory;
  Json history;  ///< its history.json
};

/// What the page knows of a run, but for its meshes:
/// {"name", "title", "folder": way to it from the page, "command", "date", "version", "seconds":
/// {"wall", "threads"} of its run.json, "problem": "poisson" | "mindlin" | null for a prescribed
/// metric, "study": resolved text, "interpolation": of its [mesh] table or null, "vary": its [vary]
/// table, "figures": names of the drawings in figures/, "csv": {file name: text}, "variants":
/// [those of the history, with "paper" (row of the paper) where they name one, and "profiles"],
/// "comparison": [...]}. Files that are not there are null or empty: results of older versions have
/// less. `page_folder`: where the page will lie.
Json run_data(const ReportRun& run, const std::filesystem::path& page_folder);

}  // namespace anisofront
