# Robots in their nominal stances, each from above and below that from the side.
is_left(leg) = int(leg) % 2 == 0
side_colour(leg) = is_left(leg) ? 0x2f6f9f : 0xc99a2e
unset key; unset tics; unset border; unset grid
do for [k=1:|names|] {
  file(what) = stem."-".names[k]."-".what.".csv"
  eval value(sprintf("above%d_panel", k))
  eval value(sprintf("above%d_range", k))
  set label 3 names[k] at graph 0.02, graph 1 offset 0, 0.4 left noenhanced textcolor rgb ink font sized(":Bold", 11)
  plot file("above") using "x_m":"y_m" with filledcurves closed fs solid 1 lc rgb pale, \
       file("above") using "x_m":"y_m" with lines lw 1 lc rgb grey, \
       file("legs") using "x_m":"y_m":(side_colour(column("leg"))) with lines lw 2.2 lc rgb variable, \
       file("legs") using (column("foot") == 1 ? column("x_m") : NaN):"y_m" with points pt 7 ps 0.7 lc rgb accent
  eval value(sprintf("side%d_panel", k))
  eval value(sprintf("side%d_range", k))
  set label 3 captions[k] at graph 0.02, graph 0 offset 0, -0.9 left noenhanced textcolor rgb ink font small
  set arrow 2 from graph 0, first grounds[k] to graph 1, first grounds[k] nohead lw 1.2 lc rgb earth front
  plot file("side") using "x_m":"z_m" with filledcurves closed fs solid 1 lc rgb pale, \
       file("side") using "x_m":"z_m" with lines lw 1 lc rgb grey, \
       file("legs") using "x_m":(is_left(column("leg")) ? NaN : column("z_m")) with lines lw 2.2 lc rgb right_side, \
       file("legs") using "x_m":(is_left(column("leg")) ? column("z_m") : NaN) with lines lw 2.2 lc rgb left_side
  unset arrow 2
}
