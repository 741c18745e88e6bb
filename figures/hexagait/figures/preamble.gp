# What every figure begins with: the sheet, the palette, the titles, and how panels are placed.
# Given: `figure`, the file, whose ending chooses the terminal; `width` and `height` [px of a PNG];
# `headline` and `subtitle`. Without these two the sheet is as much less tall as they take.
titled = strlen(headline.subtitle) > 0
title_height = 65.0
page = titled ? height : height - title_height

suffix = figure[strlen(figure)-2:strlen(figure)]
font = "DejaVu Sans"
if (suffix eq "png") set terminal pngcairo size width, page font font.",10.5" enhanced rounded
if (suffix eq "svg") set terminal svg size width, page font font.",14" enhanced rounded \
    background "white"
if (suffix eq "pdf") set terminal pdfcairo size width/100.0*1.0in, page/100.0*1.0in \
    font font.",10.5" enhanced rounded
# SVG counts fonts in pixels, the others in points.
in_points(points) = suffix eq "svg" ? points/0.75 : points
sized(style, points) = sprintf("%s%s,%g", font, style, in_points(points))
mono(style, points) = sprintf("%s Mono%s,%g", font, style, in_points(points))
small = sized("", 9)
set output figure
set encoding utf8
set datafile separator comma
set datafile columnheaders
set datafile missing ""
set macros
# The value in the column of this name.
c(name) = column(name)

# Palette: one accent for what happened, grey for what was asked, two quiet colours for the sides.
ink = "#1d2b36"; grey = "#8c99a5"; pale = "#e3e8ec"; accent = "#c4472b"; asked = "#c3ccd4"
left_side = "#2f6f9f"; right_side = "#c99a2e"; earth = "#b9a88f"
# Controllers: the tripod controller (0), the free gait (1), any other one.
gait_colour(k) = k == 0 ? 0xc99a2e : k == 1 ? 0x2f6f9f : 0x8c99a5
# Shades of a gait state's type, A (1) … D (4).
type_shade(k) = k == 4 ? 0x5d7a8c : k == 3 ? 0x93a9b7 : k == 2 ? 0xbccad4 : k == 1 ? 0xdfe6eb : 0xffffff

# Titles, in smaller letters where the sheet is too narrow for them.
least(a, b) = a < b ? a : b
fitting(text, points) = least(points, (width - 80)/(0.80*(strlen(text) + 1)))
set multiplot
if (titled) {
  set label 1 headline at screen 40.0/width, 1 - 35.0/page left noenhanced \
      font sized("", fitting(headline, 15)) textcolor rgb ink
  set label 2 subtitle at screen 40.0/width, 1 - 71.0/page left noenhanced \
      font sized("", fitting(subtitle, 10.5)) textcolor rgb grey
  unset border; unset tics
  plot [0:1][0:1] NaN notitle
  unset label
}

# Where a panel stands, in shares of the sheet with titles: `eval panel(left, right, bottom, top)`.
y(share) = share*height/page
panel(l, r, b, t) = sprintf("set lmargin at screen %g; set rmargin at screen %g; ", l, r). \
    sprintf("set bmargin at screen %g; set tmargin at screen %g", y(b), y(t))
# What it shows, above its left corner: `eval heading("a", "Speed [m/s]")`.
heading(letter, text) = \
    sprintf("set label 3 \"{/:Bold %s}   %s\" at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink", letter, text)
# Above its right corner, the key in a row: `eval key_above(top)`.
key_above(top) = sprintf("set key at graph 1, screen %g right top horizontal samplen 1.5 width 0 font small", y(top) + 25.0/page)

# A gait diagram's legend of types, from the share x of the panel on, every `step`.
legend_of_types(x, step) = sprintf("legend_x = %g; legend_step = %g; ", x, step).' \
  do for [k=1:4] { \
    set label 10+k "■" at graph legend_x+legend_step*k, graph 1 offset 0, 0.9 left \
        textcolor rgb type_shade(k); \
    set label 20+k "ABCD"[k:k] at graph legend_x+legend_step*(k+0.4), graph 1 offset 0, 0.9 left \
        textcolor rgb ink font sized("", 9) }; \
  set label 10 "type of state" at graph legend_x+0.8*legend_step, graph 1 offset 0, 0.9 right \
      textcolor rgb ink font sized("", 9)'

set border 3 lc rgb grey lw 0.8
set xtics nomirror; set ytics nomirror
set tics nomirror scale 0.5 textcolor rgb ink
set grid lc rgb pale lw 0.8 lt 1
set title textcolor rgb ink
set xlabel textcolor rgb ink
set ylabel textcolor rgb ink
set key textcolor rgb ink
