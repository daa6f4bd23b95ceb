#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "mesher/io/svg_frame.hpp"

namespace anisofront {

/// Dark blue to yellow, even steps of lightness (viridis, S. van der Walt and
/// N. Smith, 2015).
inline constexpr std::array<std::string_view, 16> kValueColours{
    "#440154", "#481a6c", "#472f7d", "#414487", "#39568c", "#31688e", "#2a788e", "#23888e",
    "#1f988b", "#22a884", "#35b779", "#54c568", "#7ad151", "#a5db36", "#d2e21b", "#fde725"};

/// Height in pixels of the key of a drawing of this width.
inline constexpr double key_height(double width) { return 0.065 * width; }

/// The greatest of 1, 2 or 5 times a power of ten that is not above `length`.
/// Precondition: > 0.
double round_length(double length);

/// The scale bar, in the bottom left corner.
void write_scale_bar(AtomicFile& out, const SvgFrame& frame);

/// Colours between the least and the greatest value, in the bottom right
/// corner.
void write_colour_key(AtomicFile& out, const SvgFrame& frame, const std::string& name, double least,
                      double greatest);

}  // namespace anisofront
