#include "drivers/report/figure_style.hpp"

namespace anisofront {
namespace {

const char* const kStyle =
    R"(# The looks of all figures of this folder: change them here, then run `gnuplot make-all.gp`.
# `anisofront report` keeps this file as it is; delete it to get the original back.

wanted = 'svg pdf png'   # formats; those that this gnuplot cannot make are left out
width = 8.6              # cm: one column of a journal
height = 6.2             # cm, without the legend below the plot
left = 1.5               # cm, room for the labels of the y axis
right = 0.55             # cm
font = 'Sans'
font_size = 8            # pt
png_dpi = 300
titles = 1               # 0: none

set encoding utf8
set border 3 linewidth 0.6 linecolor rgb '#444444'
set tics nomirror scale 0.5 textcolor rgb '#222222'
set grid linewidth 0.4 linecolor rgb '#dadada' dashtype solid
set ylabel offset 0.8, 0
set pointsize 0.6
set style fill solid 1 noborder

# Cycles run from light to dark, which stay apart in grey: cycle k of n, k = 1 .. n.
set palette defined (0 '#e3c866', 0.25 '#7cc39a', 0.5 '#3c8fa8', 0.75 '#34558b', 1 '#1b1040')
unset colorbox
shade(k, n) = n > 1 ? (k - 1) / (n - 1.0) : 1
set style line 50 linewidth 1.2 dashtype 2 linecolor rgb '#999999'  # the initial mesh
set style line 51 linewidth 0.8 linecolor rgb '#c0392b' pointtype 6  # a reference solution
set style line 52 linewidth 0.8 dashtype 3 linecolor rgb '#555555'  # slopes, the value 1
set style line 53 linewidth 1 dashtype 2 linecolor rgb '#555555'  # the legend of estimates
set style line 54 linewidth 1 linecolor rgb '#555555' pointtype 7 pointsize 0.25  # cycles on the way
band_colour = '#efefef'

# Anisotropic meshes: cold and dark; isotropic: warm and light; one of these for each variant.
set style line 1 linewidth 1.2 linecolor rgb '#0b3c6f'
set style line 2 linewidth 1.2 linecolor rgb '#3a83c4'
set style line 3 linewidth 1.2 linecolor rgb '#1b9e77'
set style line 4 linewidth 1.2 linecolor rgb '#88b8e0'
set style line 5 linewidth 1.2 linecolor rgb '#5e3c99'
set style line 6 linewidth 1.2 linecolor rgb '#222222'
set style line 11 linewidth 1.2 linecolor rgb '#e69f00'
set style line 12 linewidth 1.2 linecolor rgb '#b5461f'
set style line 13 linewidth 1.2 linecolor rgb '#f2cf6e'
set style line 14 linewidth 1.2 linecolor rgb '#d56fa4'
set style line 15 linewidth 1.2 linecolor rgb '#7a2e00'
set style line 16 linewidth 1.2 linecolor rgb '#a89f91'
# Variants of one mode only.
set style line 21 linewidth 1.2 linecolor rgb '#0b3c6f'
set style line 22 linewidth 1.2 linecolor rgb '#e69f00'
set style line 23 linewidth 1.2 linecolor rgb '#1b9e77'
set style line 24 linewidth 1.2 linecolor rgb '#b5461f'
set style line 25 linewidth 1.2 linecolor rgb '#88b8e0'
set style line 26 linewidth 1.2 linecolor rgb '#5e3c99'
# Stages: metric, front, enhance, quads, solve, estimate.
set style line 31 linecolor rgb '#88ccee'
set style line 32 linecolor rgb '#332288'
set style line 33 linecolor rgb '#ddcc77'
set style line 34 linecolor rgb '#aa4466'
set style line 35 linecolor rgb '#117733'
set style line 36 linecolor rgb '#cccccc'
)";

const char* const kFormats =
    R"(# How the scripts of this folder draw in several formats: `eval begin('pdf')` sets the terminal, the
# output NAME.pdf and the places of plot, title and legend from the sizes of style.gp, which is
# loaded after this file and may leave out what stands here.
# `anisofront report` writes this file anew.

width = 8.6; height = 6.2; left = 1.5; right = 0.55; font = 'Sans'; font_size = 8; png_dpi = 300
titles = 1; wanted = 'svg pdf png'; band_colour = '#efefef'; legend_rows = 0; legend_surplus = 0
shade(k, n) = n > 1 ? (k - 1) / (n - 1.0) : 1
has(format) = strstrt(GPVAL_TERMINALS, format eq 'svg' ? 'svg ' : format . 'cairo')
made(wanted, format) = strstrt(wanted, format) && has(format) ? format . ' ' : ''
formats(wanted) = made(wanted, 'svg') . made(wanted, 'pdf') . made(wanted, 'png')
total(rows) = height + 0.36 * rows
pixels(cm, format) = cm / 2.54 * (format eq 'svg' ? 96 : png_dpi)
pdf_terminal(rows) = sprintf("set terminal pdfcairo size %gcm,%gcm font '%s,%g' fontscale 0.75 linewidth 2 pointscale 1", width, total(rows), font, font_size)
svg_terminal(rows) = sprintf("set terminal svg size %d,%d dynamic font '%s,%g' linewidth 1.33", pixels(width, 'svg'), pixels(total(rows), 'svg'), font eq 'Sans' ? 'sans-serif' : font, font_size / 0.75)
png_terminal(rows) = sprintf("set terminal pngcairo size %d,%d font '%s,%g' fontscale %g linewidth %g pointscale %g dashlength 0.6", pixels(width, 'png'), pixels(total(rows), 'png'), font, font_size, png_dpi / 96., png_dpi / 72., png_dpi / 72.)
terminal(format, rows) = (format eq 'pdf' ? pdf_terminal(rows) : format eq 'svg' ? svg_terminal(rows) : png_terminal(rows)) . " background '#ffffff'"
margins(format, rows) = sprintf("set title offset screen %g, character -0.4; set xlabel offset 0, %g; set lmargin at screen %g; set rmargin at screen %g; set bmargin at screen %g; set tmargin at screen %g", (right - left) / 2 / width, format eq 'svg' ? 0.8 : 0.3, left / width, 1 - right / width, (1.15 + 0.36 * rows) / total(rows), 1 - (titles ? 0.65 : 0.25) / total(rows))
legend(format, rows) = rows == 0 ? "unset key" : sprintf("set key at screen 0.5, screen %g center bottom vertical maxrows %d Left reverse noenhanced samplen 1.7 spacing %g width %g", 0.1 / total(rows), rows, format eq 'svg' ? 0.75 : 1, format eq 'svg' ? -1.5 - 1.3 * legend_surplus : -legend_surplus)
begin(format) = terminal(format, legend_rows) . sprintf("; set output '%s.%s'; ", name, format) . margins(format, legend_rows) . "; " . legend(format, legend_rows) . (titles ? "" : "; unset title")
)";

const char* const kReadme = R"(Figures of the study beside this folder.

NAME.svg, NAME.pdf, NAME.png   the figure: for pages, for papers, for slides
NAME.dat                       its numbers; the first lines say what the columns are
NAME.gp                        its script: `gnuplot NAME.gp`, run in this folder, draws it again
style.gp                       colours, fonts and sizes of all of them
make-all.gp                    `gnuplot make-all.gp` draws every figure that has a script
...-mesh*, ...-solution*       pictures of meshes, drawn without gnuplot;
                               `rsvg-convert -f pdf -o X.pdf X.svg` makes a PDF
formats.gp                     how the scripts draw in several formats
made.txt                       what `anisofront report` has made here and replaces the next time

Change style.gp as you like: it is kept. Copy a script to another name before changing it. In a
study of more than 12 variants the figures of single variants are left as data and scripts, and
make-all.gp draws them.
)";

}  // namespace

std::string figure_style() { return kStyle; }

std::string figure_formats() { return kFormats; }

std::string figure_readme() { return kReadme; }

}  // namespace anisofront
