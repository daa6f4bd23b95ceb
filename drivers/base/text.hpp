#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace anisofront {

/// Number of inserted, deleted and replaced characters that turn one word into the other
/// (Levenshtein distance); a swap of neighbours counts once.
int edit_distance(std::string_view a, std::string_view b);

/// The known name nearest to `name`, ties by order; empty when none is near enough to be meant
/// (more than a third of the letters, at least two, would have to change).
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// Tail of an error message: `; did you mean "preset"?`, or `; known: a, b, c` when no name is
/// near.
std::string name_proposal(std::string_view name, const std::vector<std::string>& known);

/// "a, b, c".
std::string joined(const std::vector<std::string>& words, std::string_view separator = ", ");

/// Whole content of a file. Throws UsageError when it does not exist or cannot be read and
/// InputError when it is larger than `max_bytes`.
std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes = 1u << 28);

/// Writes under a temporary name and renames, so that nobody sees half a file.
/// Throws InputError when the file cannot be written (an old file stays).
void write_text_file(const std::filesystem::path& path, std::string_view content);

/// Creates a folder and those above it. Throws InputError when that is not possible.
void make_folder(const std::filesystem::path& path);

}  // namespace anisofront
