# Wave gaits of every duty factor in one walk: the duty factor, the gait diagram, and the end of each.
steps = stem."-steps.csv"; gait = stem."-gait.csv"

# a: the duty factor, asked for and of every step
eval panel(0.05, 0.985, 0.72, 0.86)
eval heading("a", "Duty factor: the share of the time that a leg stands")
eval key_above(0.86)
set xrange [0:t_max]; set yrange [0.44:0.89]
set xtics holding
set format x ""
set ytics ("1/2" 0.5, "5/8" 0.625, "3/4" 0.75, "5/6" 0.8333)
plot stem."-segments.csv" using "from_s":"duty_factor":(c("to_s")-c("from_s")):(0) with vectors nohead lw 6 \
         lc rgb asked title "asked for", \
     stem."-duty.csv" using "time_s":"duty_factor" with points pt 7 ps 0.35 lc rgb accent title "of each step"
unset key

# b: the gait diagram of the whole walk; below it the type of the gait state
eval panel(0.05, 0.985, 0.45, 0.66)
eval heading("b", "Legs in the air")
eval legend_of_types(0.855, 0.03)
set yrange [legs+0.75:-0.65]
set ytics @row_names scale 0
set grid noytics
set format x "%g"
set xlabel "time [s]" offset 0, 0.6
set style fill solid 1 noborder
set style data boxxyerror
if_left(is_left) = (c("row") < legs/2) == is_left ? c("row") : NaN
bar = '(c("lift_s")-begin):(c("land_s")-begin):(c("row")-0.34):(c("row")+0.34)'
bars = 'plot steps using (c("lift_s")-begin):(if_left(1)):@bar lc rgb left_side, ' \
       .'steps using (c("lift_s")-begin):(if_left(0)):@bar lc rgb right_side, ' \
       .'gait using (c("from_s")-begin):(legs):(c("from_s")-begin):(c("to_s")-begin):' \
       .'(legs-0.3):(legs+0.4):(type_shade(c("type_index"))) lc rgb variable'
begin = 0
@bars
do for [k=10:24] { unset label k }

# c: the end of each duty factor on the way up, all on one scale of time
set xtics 0, 1
set xrange [0:window]
pitch = (0.935 + 0.014)/|begins|
eval heading("c", "Settled, on the way up; from a lift of the right rear leg on")
set label 3 offset 0, 2.9
do for [k=1:|begins|] {
  eval panel(0.05 + (k-1)*pitch, 0.05 + k*pitch - 0.014, 0.07, 0.325)
  begin = begins[k]
  set label 4 titles[k] at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink font sized(":Bold", 11)
  set label 5 notes[k] at graph 1, graph 1 offset 0, 0.9 right textcolor rgb grey font small
  @bars
  unset label 3
  set ytics ("" 0) scale 0
}
