# A walk as an animated GIF. Frame k has block k of a table, or as many blocks as there are legs or
# outlines. Colours are solid: a GIF has no transparency.
set terminal gif animate delay int(delay) loop 0 optimize size int(width), int(height) \
    enhanced font "DejaVu Sans,10"
set output figure
set encoding utf8
set datafile separator comma
set datafile columnheaders
set datafile missing ""
ink = "#1d2b36"; grey = "#8c99a5"; accent = "#c4472b"
left_side = "#2f6f9f"; right_side = "#c99a2e"
table(name) = sprintf("%s-%s.csv", stem, name)
side_view = table("side"); above = table("above"); lines = table("legs"); feet = table("feet")
support = table("support"); steps = table("steps"); profile = table("profile")
cells = table("cells"); body = table("body")
frames = int(frames); per_frame = int(per_frame); first = int(first)
legs = int(legs); outlines = int(outlines)
of_left(row) = row < legs/2
trace = int(1.0/(0.01*delay))*per_frame

set border 0
unset tics
unset key
unset colorbox
set palette defined (0 "#f7f4ef", 1 "#b3a184") maxcolors 12
set cbrange [0:highest > 0 ? highest : 1]
set style fill solid 1 noborder
set lmargin at screen left; set rmargin at screen right

do for [k=0:frames-1] {
  from = k*per_frame > trace ? k*per_frame - trace : 0
  to = k*per_frame
  now = first + to
  time = start + 0.01*delay*k
  b0 = k*legs; b1 = b0 + legs - 1; c0 = b0 + 1
  o0 = k*outlines; o1 = o0 + outlines - 1
  set multiplot

  set bmargin at screen side_bottom; set tmargin at screen side_top
  eval side_range
  set label 1 "From the side" at graph 0, graph 1 offset 0, 0.7 left textcolor rgb ink
  set label 2 sprintf("%.1f s", time) at graph 1, graph 1 offset 0, 0.7 right textcolor rgb ink
  plot profile using "along_m":"right_m":(z_min) with filledcurves lc rgb "#e9dfc6", \
       lines using "along_m":"z_m" every :2::c0::b1 with lines lw 3 lc rgb right_side, \
       side_view using "along_m":"z_m" every :::o0::o1 with filledcurves closed lc rgb "#dfe5ea", \
       side_view using "along_m":"z_m" every :::o0::o1 with lines lw 1.5 lc rgb ink, \
       profile using "along_m":"left_m":(z_min) with filledcurves lc rgb "#cfdbe4", \
       profile using "along_m":"left_m" with lines lw 1 lc rgb left_side, \
       for [i=0:legs-1:2] feet using "along_m":"z_m" every ::from:i:to:i with lines lw 1 lc rgb accent, \
       lines using "along_m":"z_m" every :2::b0::b1 with lines lw 4 lc rgb left_side, \
       lines using "along_m":(column("foot") == 1 ? column("z_m") : NaN) every :2::b0::b1 with points pt 7 ps 0.9 \
           lc rgb left_side
  unset label

  set bmargin at screen above_bottom; set tmargin at screen above_top
  eval above_range
  set label 1 "From above: support polygon, ways of the feet, footprints" at graph 0, graph 1 offset 0, 0.7 \
      left textcolor rgb ink
  plot cells using "x_m":"y_m":(column("x_m")-half_cell):(column("x_m")+half_cell):(column("y_m")-half_cell): \
           (column("y_m")+half_cell):"height_m" with boxxyerror lc palette, \
       steps using (column("land_s") < time ? column("x_m") : NaN):"y_m" with points pt 7 ps 0.5 lc rgb grey, \
       body using "ideal_x_m":"ideal_y_m" with lines lw 1 dt 2 lc rgb ink, \
       body using "x_m":"y_m" every ::0::now with lines lw 1.5 lc rgb accent, \
       above using "x_m":"y_m" every :::o0::o1 with filledcurves closed lc rgb "#dfe5ea", \
       above using "x_m":"y_m" every :::o0::o1 with lines lw 1.5 lc rgb ink, \
       support using "x_m":"y_m" every :::k::k with lines lw 2 lc rgb accent, \
       for [i=0:legs-1] feet using "x_m":"y_m" every ::from:i:to:i with lines lw 1 \
           lc rgb (i % 2 == 0 ? left_side : right_side), \
       lines using "x_m":"y_m" every :2::b0::b1 with lines lw 3 lc rgb left_side, \
       lines using "x_m":"y_m" every :2::c0::b1 with lines lw 3 lc rgb right_side, \
       lines using "x_m":(column("foot") == 1 ? column("y_m") : NaN) every :::b0::b1 with points pt 7 ps 0.8 lc rgb ink
  unset label
  unset multiplot
}
unset output
