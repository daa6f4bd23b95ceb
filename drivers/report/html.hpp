#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "drivers/base/base64.hpp"
#include "drivers/base/text_table.hpp"

namespace anisofront {

/// Text with the characters that mean something in HTML replaced.
std::string html_text(std::string_view text);

std::string html_table(const TextTable& table);

/// An SVG file as a figure inside the page; above 8 MB a link to figures/NAME instead.
std::string html_figure(const std::filesystem::path& svg, const std::string& caption);

/// A complete page.
std::string html_page(const std::string& title, const std::string& body);

}  // namespace anisofront
