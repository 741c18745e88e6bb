# An action: paths from above and from the side, the stability margin.
base = stem."-base.csv"; feet = stem."-feet.csv"; steps = stem."-steps.csv"

# a: from above. Lines are the ways of the feet in the air, points where they stood.
eval above_panel
eval heading("a", "From above [m]")
eval above_range
do for [k=1:|leg_names|] {
  set label 100+k leg_names[k] at leg_x[k], leg_y[k] center offset 0, (k % 2 == 1 ? 0.8 : -0.8) \
      textcolor rgb grey font small }
eval key_above(above_top)
is_left(leg) = int(leg) % 2 == 0
plot feet using "x_m":(is_left(column("leg")) ? column("y_m") : NaN) with lines lw 1.4 lc rgb left_side title "left feet", \
     feet using "x_m":(is_left(column("leg")) ? NaN : column("y_m")) with lines lw 1.4 lc rgb right_side title "right feet", \
     feet using "x_m":(column("support") == 1 ? column("y_m") : NaN) with points pt 7 ps 0.35 lc rgb grey title "on the ground", \
     base using "x_m":"y_m" with lines lw 2 lc rgb accent title "base", \
     base using "x_m":"y_m" every ::0::0 with points pt 6 ps 1 lw 1.6 lc rgb accent notitle
do for [k=1:|leg_names|] { unset label 100+k }

# b: from the side
eval side_panel
eval heading("b", "From the side [m]")
eval side_range
unset key
plot feet using "x_m":(is_left(column("leg")) ? NaN : column("z_m")) with lines lw 1.4 lc rgb right_side, \
     feet using "x_m":(is_left(column("leg")) ? column("z_m") : NaN) with lines lw 1.4 lc rgb left_side, \
     feet using "x_m":(column("support") == 1 ? column("z_m") : NaN) with points pt 7 ps 0.35 lc rgb grey, \
     base using "x_m":"z_m" with lines lw 2 lc rgb accent, \
     base using "x_m":"z_m" every ::0::0 with points pt 6 ps 1 lw 1.6 lc rgb accent

# c: the margin, in alternating shades the steps
eval margin_panel
eval heading("c", "Stability margin [m], and the steps")
set xrange [0:t_max]
set grid noxtics
set xlabel "time [s]" offset 0, 0.5
set yrange [bottom:top]
every_nth = ceil(num_steps/40.0)
set style fill solid 1 noborder
plot steps using "from_s":(top):"from_s":"to_s":(bottom):(top) with boxxyerror lc rgb "#ffffff" notitle, \
     steps using (int(column("step")) % 2 == 0 ? column("from_s") : NaN):(top):"from_s":"to_s":(bottom):(top) with boxxyerror \
         lc rgb "#eef1f4" notitle, \
     steps using (0.5*(column("from_s") + column("to_s"))):(0.93*top): \
         (int(column("step")) % every_nth == 0 ? sprintf("%d", int(column("step"))) : "") \
         with labels font small textcolor rgb grey notitle, \
     base using "time_s":(0) with lines lw 0.8 lc rgb grey notitle, \
     base using "time_s":"margin_m" with lines lw 1.6 lc rgb ink notitle
