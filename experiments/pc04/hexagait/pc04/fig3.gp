# [PC04] Fig. 3. A panel per wave gait: a row per leg in the air, below them the gait state.
unset key
set xrange [0:72]; set yrange [7.75:0.4]
set xtics 12
set grid noytics
set style fill solid 1 noborder
row(leg) = leg == 2 ? 1 : leg == 4 ? 2 : leg == 6 ? 3 : leg == 1 ? 4 : leg == 3 ? 5 : 6
set ytics ("2" 1, "4" 2, "6" 3, "1" 4, "3" 5, "5" 6, "state" 7.2) scale 0
if_of(is_odd) = c("panel") == p && int(c("leg")) % 2 == is_odd ? c("from") : NaN
bar = '(row(c("leg"))):"from":"to":(row(c("leg"))-0.34):(row(c("leg"))+0.34) with boxxyerror'
if_here(x) = c("panel") == p ? x : NaN
do for [p=0:3] {
  left = 0.05 + 0.49*(p % 2); top = 0.82 - 0.415*(p/2)
  eval panel(left, left + 0.435, top - 0.30, top)
  set label 3 titles[p+1] at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink font sized(":Bold", 11)
  set label 4 lifts[p+1] at graph 1, graph 1 offset 0, 0.9 right textcolor rgb grey font sized("", 9.5)
  if (p > 1) { set xlabel "time [slices]" offset 0, 0.4 }
  plot stem."-steps.csv" using (if_of(1)):@bar lc rgb left_side, \
       stem."-steps.csv" using (if_of(0)):@bar lc rgb right_side, \
       stem."-states.csv" using (if_here(c("from"))):(7):"from":"to":(6.85):(7.55):(type_shade(c("type_number"))) \
           with boxxyerror lc rgb variable, \
       stem."-states.csv" using (if_here(0.5*(c("from")+c("to")))):(7.2):(strcol("type")): \
           (c("type_number") == 4 ? 0xffffff : 0x1d2b36) with labels font sized(":Bold", 9) textcolor rgb variable
}
