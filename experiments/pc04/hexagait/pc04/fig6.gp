# [PC04] Fig. 6. A panel per gait generator: the advance in every slice, dashed the mean.
unset key
set xrange [-0.7:71.7]; set yrange [-12:58]
set xtics 6; set ytics 25
set style fill solid 1 noborder
set boxwidth 0.7
array column_of[3] = ["tripod", "free", "unadjusted"]
do for [p=1:3] {
  top = 0.83 - 0.27*(p-1)
  eval panel(0.06, 0.985, top - 0.2, top)
  eval heading(titles[p][1:1], titles[p][2:*])
  set label 4 sprintf("mean %.2f", means[p]) at graph 0.998, first means[p] offset 0, 0.7 right \
      textcolor rgb accent font sized(":Bold", 9.5) front
  if (p == 3) { set xlabel "time [slices]" offset 0, 0.4 }
  plot stem.".csv" using "slice":column_of[p] with boxes lc rgb left_side, \
       means[p] with lines dt 2 lw 1.6 lc rgb accent
}
