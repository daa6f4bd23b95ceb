#include "mesher/io/svg_key.hpp"

#include <cstdio>

#include "mesher/io/xml.hpp"

namespace anisofront {

namespace {

constexpr std::string_view kInk = "#222222";

/// With few digits: "0.05", "2e-05".
std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

double font_size(const SvgFrame& frame) { return 0.03 * frame.width; }

/// Height of the base line of texts.
double base_line(const SvgFrame& frame) { return frame.height - 0.022 * frame.width; }

void write_text(AtomicFile& out, const SvgFrame& frame, double x, std::string_view anchor,
                const std::string& text) {
  out.text("<text");
  write_attribute(out, "x", x);
  write_attribute(out, "y", base_line(frame));
  write_attribute(out, "font-size", font_size(frame));
  out.text(" font-family=\"sans-serif\" fill=\"" + std::string(kInk) + "\" text-anchor=\"");
  out.text(anchor);
  out.text("\">" + xml_escaped(text) + "</text>\n");
}

void write_box(AtomicFile& out, Point corner, Vector size, std::string_view colour) {
  out.text("<rect");
  write_attribute(out, "x", corner.x);
  write_attribute(out, "y", corner.y);
  write_attribute(out, "width", size.x);
  write_attribute(out, "height", size.y);
  out.text(" fill=\"");
  out.text(colour);
  out.text("\"/>\n");
}

}  // namespace

double round_length(double length) {
  constexpr double kRounding = 1e-9;
  const double power = std::pow(10, std::floor(std::log10(length) + kRounding));
  for (const double digit : {5., 2.})
    if (digit * power <= length * (1 + kRounding)) return digit * power;
  return power;
}

void write_scale_bar(AtomicFile& out, const SvgFrame& frame) {
  const double length = round_length((frame.shown.high.x - frame.shown.low.x) / 4);
  const double pixels = frame.scale * length;
  const double thick = 0.005 * frame.width, tick = 0.018 * frame.width;
  const double x = frame.margin, y = base_line(frame) - 0.011 * frame.width;
  out.text("<g class=\"scale\">\n");
  write_box(out, {x, y - thick / 2}, {pixels, thick}, kInk);
  for (const double end : {x, x + pixels - thick / 2})
    write_box(out, {end, y - tick / 2}, {thick / 2, tick}, kInk);
  write_text(out, frame, x + pixels + 0.012 * frame.width, "start", short_number(length));
  out.text("</g>\n");
}

void write_colour_key(AtomicFile& out, const SvgFrame& frame, const std::string& name, double least,
                      double greatest) {
  const double step = 0.015 * frame.width, bar = step * kValueColours.size();
  const double gap = 0.012 * frame.width;
  // Rounding errors are 0 beside the other end.
  const double zero = 1e-3 * std::max(std::fabs(least), std::fabs(greatest));
  const std::string low = short_number(std::fabs(least) < zero ? 0 : least);
  const std::string high = short_number(std::fabs(greatest) < zero ? 0 : greatest);
  const double right =
      frame.width - frame.margin - gap - 0.62 * font_size(frame) * static_cast<double>(high.size());
  const double top = base_line(frame) - 0.023 * frame.width;
  out.text("<g class=\"colours\">\n");
  for (std::size_t k = 0; k < kValueColours.size(); ++k)
    write_box(out, {right - bar + step * static_cast<double>(k), top}, {step, 0.024 * frame.width},
              kValueColours[k]);
  write_text(out, frame, right + gap, "start", high);
  write_text(out, frame, right - bar - gap, "end", (name.empty() ? "" : name + ":   ") + low);
  out.text("</g>\n");
}

}  // namespace anisofront
