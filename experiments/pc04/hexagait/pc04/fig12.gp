# [PC04] Fig. 12: slip of Lauron's feet, by the duration of a displacement of the body.
slips = stem."-slips.csv"
eval panel(0.09, 0.97, 0.13, 0.80)
set xlabel "duration of a displacement [ms]"
set ylabel "slip in a stance [mm]"
set xrange [-5:205]
set yrange [0:11]
set key at graph 0.02, graph 0.87 left top reverse Left samplen 1.5
set arrow 1 from first -5, 10 to first 205, 10 nohead dt 2 lw 1.2 lc rgb accent
set label 1 "1 cm, the bound of [PC04]" at first 200, 10 right offset 0, -0.7 textcolor rgb accent
set arrow 2 from first servo, 0 to first servo, 9 nohead lw 1 lc rgb grey
set label 2 "20 Hz" at first servo, 9 left offset 0.5, 0 textcolor rgb grey
course_colour(k) = word("#1b6ca8 #d1495b #3a8f5c #b07d12", k + 1)
of(k, x) = c("course") == k ? x : NaN
plot for [k=0:|courses|-1] slips using (of(k, c("period_ms"))):(c("slip_p95_mm")) with linespoints \
         pt 7 ps 0.6 lw 2 lc rgb course_colour(k) title courses[k+1], \
     for [k=0:|courses|-1] slips using (of(k, c("period_ms"))):(c("slip_most_mm")) with lines dt 2 \
         lw 1.2 lc rgb course_colour(k) notitle
