#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/json.hpp"
#include "drivers/base/text_table.hpp"

namespace anisofront {

/// A mesh that the page carries along: mesh_blob() in base64.
struct PageMesh {
  std::string id;  ///< letters, digits and hyphens
  std::string text;
};

struct PageContent {
  std::string title;
  std::vector<TextTable> tables;  ///< for readers without scripts
  Json data;                      ///< {"version", "runs":[...]}, see run_data()
  std::vector<PageMesh> meshes;
};

/// The complete page, one file. Nothing in `content` is taken for markup or script.
std::string page_html(const PageContent& content);

/// Text with the characters that mean something in HTML replaced.
std::string html_text(std::string_view text);

/// What a page consists of besides its content: drivers/report/page/, embedded when the program is
/// built (embed.cmake). Styles and scripts are joined in the order of their names.
std::string_view page_skeleton();
std::string_view page_style();
std::string_view page_script();

}  // namespace anisofront
