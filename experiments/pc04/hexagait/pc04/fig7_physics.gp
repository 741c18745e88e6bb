# [PC04] Fig. 7 in Box2D: speeds over roughness, and differences in pairs.
trials = stem."-trials.csv"; means = stem."-means.csv"
array names[3] = ["tripod, waiting", "free gait", "without adjustment"]
set xlabel "roughness: cells of 10 cm, heights up to [cm]" offset 0, 0.3
set xrange [-0.7:8.7]; set xtics 2
beside(k, gap) = c("gait_number") == k ? c("roughness_cm") + gap : NaN
bars = 'with yerrorbars pt 13 ps 1 lw 1.6 lc rgb gait_colour(k) title names[k+1]'

eval panel(0.06, 0.49, 0.13, 0.76)
eval heading("a", "Speed [cm/s]")
set yrange [0:*]
set key at graph 0.02, graph 0.04 left bottom Left reverse samplen 1.5
plot for [k=0:2] trials using (beside(k, 0.24*(k-1) + 0.12*(rand(0)-0.5))):"speed_cm_s" with points pt 7 ps 0.3 \
         lc rgb gait_colour(k) notitle, \
     for [k=0:2] means using (beside(k, 0.24*(k-1))):"mean_cm_s":"half_width_95" @bars

eval panel(0.56, 0.98, 0.13, 0.76)
eval heading("b", "Ahead of the tripod controller, in pairs [cm/s]")
set yrange [*:*]
set key at graph 0.98, graph 0.04 right bottom
plot 0 with lines lw 1 lc rgb grey notitle, \
     for [k=1:2] means using (beside(k, 0.12*(2*k-3))):"ahead_cm_s":"ahead_half_width_95" @bars
