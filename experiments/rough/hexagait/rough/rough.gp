# Six measures against the height of boxes over the reach of a leg: a line and a band per controller.
# Given: `names` of the controllers.
points = stem."-points.csv"
array shown[4] = ["tripod that waits", "free gait", "tripod by the clock, feeling nothing", "wave gait, duty factor 0.6"]
array colours[4] = [0xc99a2e, 0x2f6f9f, 0xc4472b, 0x5d7a8c]
of(k, name) = strcol("controller") eq names[k] ? c(name) : NaN
set xrange [-0.02:0.82]; set xtics 0, 0.2
set style fill transparent solid 0.15 noborder
curve(name, factor) = sprintf("for [k=1:4] points using 'height_of_reach':(%g*of(k, '%s_lower')):(%g*of(k, '%s_upper')) with filledcurves lc rgb colours[k] notitle, for [k=1:4] points using 'height_of_reach':(%g*of(k, '%s')) with linespoints lw 1.8 pt 7 ps 0.6 lc rgb colours[k]", factor, name, factor, name, factor, name)

eval panel(0.05, 0.335, 0.56, 0.85)
eval heading("a", "Arrive [%]")
set yrange [0:105]
set key at screen 0.5, screen y(0.035) center center horizontal samplen 2 spacing 1.1 width 2
eval "plot ".curve("share", 100)." title shown[k]"
unset key

eval panel(0.38, 0.665, 0.56, 0.85)
eval heading("b", "Speed [% of that on flat ground]")
set yrange [0:*]
eval "plot ".curve("speed_of_flat", 100)

eval panel(0.71, 0.985, 0.56, 0.85)
eval heading("c", "Mean distance from the path [cm]")
eval "plot ".curve("off_path_m", 100)

eval panel(0.05, 0.335, 0.13, 0.44)
eval heading("d", "Slip of a stance, 95th percentile [cm]")
set xlabel "height of the boxes / reach of a leg" offset 0, 0.3
eval "plot ".curve("slip_p95_m", 100)

eval panel(0.38, 0.665, 0.13, 0.44)
eval heading("e", "Cost of transport")
eval "plot ".curve("cost_of_transport", 1)

eval panel(0.71, 0.985, 0.13, 0.44)
eval heading("f", "Least stability margin [cm]")
set yrange [*:*]
eval "plot ".curve("margin_min_m", 100)
