# A robot in its nominal stance: from above, from the side, and the reach of one leg in its plane.
file(name) = stem."-".name.".csv"
legs = file("legs"); workspaces = file("workspaces")
is_left(leg) = int(leg) % 2 == 0
side_colour(leg) = is_left(leg) ? 0x2f6f9f : 0xc99a2e

# a: from above
eval above_panel
eval heading("a", "From above [m], its front to the right")
eval above_range
set xtics autofreq; set ytics autofreq
do for [k=1:|leg_names|] {
  set label 100+k leg_names[k] at leg_x[k], leg_y[k] center front textcolor rgb ink font small }
set arrow 1 from 0, 0 to 1.25*front, 0 front lw 2 lc rgb accent filled size screen 0.012, 18
set key at graph 0.5, graph 0.01 bottom center horizontal samplen 1.5 font small
set style fill transparent solid 0.18 noborder
plot file("support") using "x_m":"y_m" with lines lw 1 dt 2 lc rgb grey title "support polygon", \
     workspaces using "x_m":"y_m":(side_colour(column("leg"))) with filledcurves closed lc rgb variable notitle, \
     workspaces using "x_m":"y_m":(side_colour(column("leg"))) with lines lw 0.9 lc rgb variable notitle, \
     file("above") using "x_m":"y_m" with filledcurves closed fs solid 1 lc rgb pale notitle, \
     file("above") using "x_m":"y_m" with lines lw 1.2 lc rgb grey notitle, \
     legs using "x_m":"y_m":(side_colour(column("leg"))) with lines lw 3 lc rgb variable notitle, \
     legs using (column("foot") == 0 ? column("x_m") : NaN):"y_m" with points pt 7 ps 0.7 lc rgb ink title "joints", \
     legs using (column("foot") == 1 ? column("x_m") : NaN):"y_m" with points pt 7 ps 1.1 lc rgb accent title "feet", \
     "+" using (com[1]):(com[2]) every ::0::0 with points pt 2 ps 1.4 lw 2 lc rgb ink title "centre of mass"
do for [k=1:|leg_names|] { unset label 100+k }
unset arrow 1

# b: from the side
eval side_panel
eval heading("b", "From the side [m]: left legs blue, right legs yellow")
eval side_range
unset key
set arrow 2 from graph 0, first ground to graph 1, first ground nohead lw 1.5 lc rgb earth front
plot file("side") using "x_m":"z_m" with filledcurves closed fs solid 1 lc rgb pale, \
     file("side") using "x_m":"z_m" with lines lw 1.2 lc rgb grey, \
     legs using "x_m":(is_left(column("leg")) ? NaN : column("z_m")) with lines lw 3 lc rgb right_side, \
     legs using "x_m":(is_left(column("leg")) ? column("z_m") : NaN) with lines lw 3 lc rgb left_side, \
     legs using (column("foot") == 0 ? column("x_m") : NaN):"z_m" with points pt 7 ps 0.6 lc rgb ink, \
     legs using (column("foot") == 1 ? column("x_m") : NaN):"z_m" with points pt 7 ps 1 lc rgb accent, \
     workspaces using "x_m":"z_m":(side_colour(column("leg"))) with lines lw 1.6 lc rgb variable, \
     "+" using (com[1]):(com[3]) every ::0::0 with points pt 2 ps 1.2 lw 2 lc rgb ink

# c: the reach of one leg
eval reach_panel
eval heading("c", "Leg ".first_leg." in its plane [m], outwards from its hip: what its foot can reach, and its stance")
eval reach_range
plot file("reach") using "out_m":"z_m":(0.56*cell):(0.56*cell) with boxxyerror fs solid 1 noborder lc rgb "#d5e2ec", \
     file("leg") using "out_m":"z_m" with lines lw 3 lc rgb left_side, \
     file("leg") using "out_m":"z_m" with points pt 7 ps 0.8 lc rgb ink
