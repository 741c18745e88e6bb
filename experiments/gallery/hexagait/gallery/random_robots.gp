# Robots drawn at random: size and mass; speed by ℓ/T; distance from the path.
points = stem."-points.csv"
# Walks, does not walk, fell, can't stand.
array group_colour[4] = [0x2f6f9f, 0xc99a2e, 0xc4472b, 0xc3ccd4]
array group_name[4] = ["walks straight on, an arc and a spin", "gets stuck or is too slow", "falls", "can't stand"]
of(k, value) = c("group") == k ? value : NaN

# a: size and mass
eval panel(0.05, 0.34, 0.12, 0.84)
eval heading("a", "Mass [kg] by size [m]")
set logscale xy
set xtics (0.1, 0.2, 0.5, 1, 2); set xrange [0.08:2.6]
set key at graph 0.02, graph 0.98 top left Left reverse samplen 0.5 font small
plot for [k=3:0:-1] points using (of(k, c("size_m"))):"mass_kg" with points pt 7 ps 0.7 lc rgb group_colour[k+1] title group_name[k+1]
unset key

# b: speed
eval panel(0.39, 0.67, 0.12, 0.84)
eval heading("b", "Speed straight on [m/s] by ℓ/T [m/s]")
set xtics autofreq; set xrange [*:*]
set key at graph 0.98, graph 0.04 bottom right samplen 1 font small
plot for [k=1:0:-1] points using (of(k, c("pace_m_s"))):"speed_m_s" with points pt 7 ps 0.7 lc rgb group_colour[k+1] notitle, \
     0.3*x lw 1 dt 2 lc rgb grey title "0.3 ℓ/T"
unset key

# c: off the path
eval panel(0.72, 0.985, 0.12, 0.84)
eval heading("c", "Mean distance from the path [% of the way] by size [m]")
set xtics (0.1, 0.2, 0.5, 1, 2); set xrange [0.08:2.6]
plot for [k=2:0:-1] points using (of(k, c("size_m"))):"off_path_percent" with points pt 7 ps 0.7 lc rgb group_colour[k+1], \
     2 lw 1 dt 2 lc rgb grey
