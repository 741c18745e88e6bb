# Six measures against the height of boxes over the reach of a leg: a line and a band per controller.
# Given: `names` of the controllers, whose rows take turns.
points = stem."-points.csv"
array shown[4] = ["tripod that waits", "free gait", "tripod by the clock, feels nothing", "wave gait, duty factor 0.6"]
array colours[4] = [0xc99a2e, 0x2f6f9f, 0xc4472b, 0x7a9a4c]
set xrange [-0.02:0.82]; set xtics 0, 0.2
set style fill transparent solid 0.15 noborder
unset key
more_than(low, x) = x > low ? x : x <= low ? low : NaN
# Each value times `factor`, and not below `low`.
band(name, factor, low) = sprintf("for [k=1:4] points every 4::k-1 using 'height_of_reach':".'(more_than(%g, %g*c("%s_lower"))):(more_than(%g, %g*c("%s_upper")))'." with filledcurves lc rgb colours[k], ", low, factor, name, low, factor, name)
line(name, factor, low) = sprintf("for [k=1:4] points every 4::k-1 using 'height_of_reach':".'(more_than(%g, %g*c("%s")))'." with linespoints lw 1.8 pt 7 ps 0.6 lc rgb colours[k]", low, factor, name)
curves(name, factor, low) = "plot ".band(name, factor, low).line(name, factor, low)

do for [k=1:4] {
  set label 10+k "●" at screen 0.05+0.235*(k-1), screen y(0.035) left textcolor rgb colours[k]
  set label 20+k shown[k] at screen 0.066+0.235*(k-1), screen y(0.035) left textcolor rgb ink
}
eval panel(0.05, 0.335, 0.56, 0.85)
eval heading("a", "Arrive [%]")
set yrange [0:105]
eval curves("share", 100, 0)
do for [k=11:24] { unset label k }

eval panel(0.38, 0.665, 0.56, 0.85)
eval heading("b", "Speed [% of that on flat ground]")
set yrange [0:120]
eval curves("speed_of_flat", 100, 0)

set logscale y
eval panel(0.71, 0.985, 0.56, 0.85)
eval heading("c", "Mean distance from the path [cm]")
set yrange [0.01:500]; set ytics ("≤ 0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10, "100" 100)
eval curves("off_path_m", 100, 0.01)

eval panel(0.05, 0.335, 0.13, 0.44)
eval heading("d", "Slip of a stance, 95th percentile [cm]")
set xlabel "height of the boxes / reach of a leg" offset 0, 0.3
set yrange [0.01:100]
eval curves("slip_p95_m", 100, 0.01)

eval panel(0.38, 0.665, 0.13, 0.44)
eval heading("e", "Cost of transport")
set yrange [0.2:50]; set ytics ("0.2" 0.2, "0.5" 0.5, "1" 1, "2" 2, "5" 5, "10" 10, "20" 20, "50" 50)
eval curves("cost_of_transport", 1, 0.2)
unset logscale y

eval panel(0.71, 0.985, 0.13, 0.44)
eval heading("f", "Least stability margin [cm]")
set yrange [*:*]; set ytics autofreq
eval curves("margin_min_m", 100, -200)
