# [FG16] Fig. 7: one foot by localisation, by odometry and as executed, and where all feet come to stand.
foot = stem."-foot.csv"; touchdowns = stem."-touchdowns.csv"
localised = accent; by_odometry = right_side; combined = left_side

# a: the left front foot from above, its sideways motion drawn larger than its way
eval panel(0.05, 0.985, 0.57, 0.83)
eval heading("a", "The left front foot from above: sideways over the way [m], 4 times as large")
set xrange [-1.36:1.76]; set yrange [y_min:y_min + 3.12*0.26*height/(4*0.935*width)]
set xtics 0.5; set ytics 0.05
set key at graph 1, graph 1.03 right bottom horizontal samplen 1.6 width -2 font small
set object 1 rectangle from step_x, graph 0 to graph 1, graph 1 fs solid 0.25 noborder fc rgb earth behind
set label 4 "up the step" at step_x + 0.02, graph 0.06 left textcolor rgb ink font small
plot foot using "localised_x_m":"localised_y_m" with lines lw 1.2 lc rgb localised title "by localisation", \
     foot using "odometry_x_m":"odometry_y_m" with lines lw 1.6 lc rgb by_odometry title "by odometry", \
     touchdowns using (c("odometry_only") == 0 && c("leg") == 0 ? c("foothold_x_m") : NaN):"foothold_y_m" \
         with points pt 6 ps 1.6 lw 2 lc rgb ink title "footholds in the map", \
     foot using "x_m":"y_m" with lines lw 2 lc rgb combined title "combined, as executed"
unset label 4; unset object 1

# b: some seconds of it
eval panel(0.05, 0.475, 0.085, 0.455)
eval heading("b", "Five seconds: sideways [m] over time [s]")
set xrange [zoom:zoom+5]; set yrange [y_min+0.01:y_min+0.13]
set xtics 1; set ytics 0.02
set xlabel "time [s]" offset 0, 0.5
unset key
plot foot using "time_s":"localised_y_m" with lines lw 1.4 lc rgb localised, \
     foot using "time_s":"odometry_y_m" with lines lw 1.6 lc rgb by_odometry, \
     foot using "time_s":"y_m" with lines lw 2 lc rgb combined

# c: where feet come to stand, with the combined approach and by odometry alone
eval panel(0.55, 0.985, 0.085, 0.455)
eval heading("c", "From the foothold in the map at touchdown, all feet [cm]")
set xrange [0:3.1]; set yrange [0:*]
set xtics 0.5; set ytics 1
set xlabel "way [m]" offset 0, 0.5
set key at graph 0.03, graph 0.97 left top vertical maxrows 2 Left reverse samplen 0.6 font small
plot touchdowns using (c("odometry_only") == 1 ? c("way_m") : NaN):(100*c("error_m")) with points pt 7 ps 0.8 \
         lc rgb by_odometry title "another walk, by odometry alone", \
     touchdowns using (c("odometry_only") == 0 ? c("way_m") : NaN):(100*c("error_m")) with points pt 7 ps 0.8 \
         lc rgb combined title "combined"
