# [FG16] Fig. 6: four trials up a step, the feet from the side, all from above, and their precision.
array colour[4] = ["#2f6f9f", "#c99a2e", "#2c7a57", "#c4472b"]
feet = stem."-feet.csv"; touchdowns = stem."-touchdowns.csv"
if_trial(k, x) = c("trial") == k ? x : NaN
step(bottom, top, shade) = sprintf('set object 1 rectangle from step_x, %s to 1.82, %s fs solid %g noborder fc rgb earth behind', \
    bottom, top, shade)
block(y0, y1) = sprintf('set object 2 rectangle from block_x, %g to block_x + block_length, %g fs solid 0.8 noborder fc rgb "#6b5a42" behind', y0, y1)

# a, b: the feet from the side. The ground up to the step and behind it
set xrange [-0.72:1.82]; set yrange [0:0.3]
set xtics 0.2; set ytics 0.1
if_side(k, x) = c("trial") == k && int(c("leg")) % 2 == side ? x : NaN
do for [side=0:1] {
  top = side == 0 ? 0.865 : 0.625
  eval panel(0.045, 0.985, top - 0.165, top)
  eval heading(side == 0 ? "a" : "b", (side == 0 ? "Left" : "Right")." feet from the side: height over way [m]")
  eval step("0", "step_height", 0.35)
  if (side == 0) {
    eval block(0, block_height)
    set label 4 "block, in D" at step_x + 0.007, 0.02 left textcolor rgb ink font small
    set key at graph 1, graph 1.03 right bottom horizontal samplen 1.6 width -2 font small
  } else {
    unset key; unset label 4; unset object 2
  }
  plot for [k=0:3] feet using (if_side(k, c("commanded_x_m"))):(c("commanded_z_m") - foot_radius) with lines lw 5 \
           lc rgb asked title (k == 0 ? "commanded" : ""), \
       for [k=0:3] feet using (if_side(k, c("x_m"))):(c("z_m") - foot_radius) with lines lw 1.3 \
           lc rgb colour[k+1] title "ABCD"[k+1:k+1]
}

# c: from above, a metre as long across as up: feet as dots where they came to stand, the base, the pushes
eval panel(0.045, 0.475, 0.055, 0.055 + 0.43*width*1.36/2.54/height)
eval heading("c", "From above: footholds, feet that stand on them, base and pushes [m]")
set yrange [-0.68:0.68]
set xtics 0.5; set ytics 0.5
eval step("-0.68", "0.68", 0.2)
eval block(block_y - 0.5*block_width, block_y + 0.5*block_width)
unset key
plot touchdowns using "foothold_x_m":"foothold_y_m" with points pt 6 ps 1.5 lw 2.5 lc rgb asked, \
     for [k=0:3] touchdowns using (if_trial(k, c("x_m"))):"y_m" with points pt 7 ps 0.45 lc rgb colour[k+1], \
     for [k=0:3] stem."-base.csv" using (if_trial(k, c("x_m"))):"y_m" with lines lw 1.4 lc rgb colour[k+1], \
     for [k=0:3] stem."-pushes.csv" using (if_trial(k, c("x_m"))):"y_m":(c("force_x_n")/1250):(c("force_y_n")/1250) \
         with vectors head filled size screen 0.006, 22 lw 1.6 lc rgb colour[k+1]
unset object 1; unset object 2

# d: how near the feet are to where they should be
eval panel(0.55, 0.985, 0.055, 0.055 + 0.43*width*1.36/2.54/height)
eval heading("d", "Distance of a swinging foot from its command: share of the time")
set logscale x; set xrange [0.1:100]; set yrange [0:1]
set xtics ("0.1" 0.1, "1" 1, "10" 10, "100" 100); set ytics 0.25
set xlabel "less than … [mm]" offset 0, 0.4
set key at graph 0.98, graph 0.06 right bottom Left reverse samplen 1.6 font small
plot for [k=0:3] stem."-shares.csv" using (if_trial(k, 1e3*c("error_m"))):"share" with lines lw 1.8 \
    lc rgb colour[k+1] title legends[k+1]
