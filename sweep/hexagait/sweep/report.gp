# A measure by controller, over the roughness of the ground or by terrain.
# Given: csv; `curves`, one per controller (of each robot), whose rows have its number in the column
# "curve"; `shift` of each to the side, lest intervals hide each other; x_label, y_label;
# over_roughness, and else `terrains`, the names of x = 0, 1, …; y_from and y_to, equal for any.
array colours[6] = [ink, accent, left_side, right_side, earth, grey]
set lmargin at screen 0.09; set rmargin at screen 0.80
set bmargin at screen y(0.11); set tmargin at screen y(0.87)
set key at graph 1.03, graph 1 left top Left reverse samplen 1.5 noenhanced
set ylabel y_label noenhanced
set offsets graph 0.04, graph 0.04, graph 0.05, graph 0.05
set bars 0.6; set autoscale xfix
if (y_from < y_to) set yrange [y_from:y_to]
if (over_roughness) {
  set xlabel x_label noenhanced
} else {
  set xtics () noenhanced
  do for [k=1:|terrains|] { set xtics add (terrains[k] k-1) }
}
at(k) = column("curve") == k ? column("x") + shift[k] : NaN
if (over_roughness) {
  plot for [k=1:|curves|] csv using (at(k)):"mean":"ci95_lower":"ci95_upper" title curves[k] \
      with yerrorlines lc rgb colours[(k-1)%6+1] lw 1.8 pt 7 ps 0.6
} else {
  plot for [k=1:|curves|] csv using (at(k)):"mean":"ci95_lower":"ci95_upper" title curves[k] \
      with yerrorbars lc rgb colours[(k-1)%6+1] lw 1.8 pt 7 ps 0.6
}
