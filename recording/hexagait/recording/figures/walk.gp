# A walk: from the side, from above, the gait diagram, the body over time.
table(name) = sprintf("%s-%s.csv", stem, name)
body = table("body"); steps = table("steps"); gait = table("gait")
outlines = table("outlines"); lines = table("legs"); ground = table("ground")
is_left(leg) = int(leg) % 2 == 0
of_left(row) = row < legs/2

# a: from the side. Right legs and their ground lie behind the body, left ones before it.
eval side_panel
eval heading("a", "From the side, along the path [m]")
eval side_range
set grid noxtics noytics
eval key_above(side_top)
plot ground using "along_m":"right_m":(z_min) with filledcurves fs solid 1 lc rgb "#e9dfc6" notitle, \
     ground using "along_m":"right_m" with lines lw 1 lc rgb right_side notitle, \
     lines using "along_m":(is_left(column("leg")) ? NaN : column("z_m")) with lines lw 3 lc rgb right_side notitle, \
     lines using "along_m":(column("foot") == 1 && !is_left(column("leg")) ? column("z_m") : NaN) \
         with points pt 7 ps 0.8 lc rgb right_side notitle, \
     outlines using "along_m":"z_m" with filledcurves closed fs solid 1 lc rgb "#dfe5ea" notitle, \
     outlines using "along_m":"z_m" with lines lw 1.4 lc rgb ink notitle, \
     ground using "along_m":"left_m":(z_min) with filledcurves fs transparent solid 0.55 lc rgb "#c3d3df" notitle, \
     ground using "along_m":"left_m" with lines lw 1 lc rgb left_side notitle, \
     lines using "along_m":(is_left(column("leg")) ? column("z_m") : NaN) with lines lw 3 lc rgb left_side notitle, \
     lines using "along_m":(column("foot") == 1 && is_left(column("leg")) ? column("z_m") : NaN) \
         with points pt 7 ps 0.8 lc rgb left_side notitle, \
     body using "along_m":"z_m" with lines lw 1.6 lc rgb accent title "origin of the base", \
     steps using "along_m":(of_left(column("row")) ? column("z_m") : NaN) with points pt 6 ps 0.6 lw 1.4 \
         lc rgb left_side title "left footfalls", \
     steps using "along_m":(of_left(column("row")) ? NaN : column("z_m")) with points pt 6 ps 0.6 lw 1.4 \
         lc rgb right_side title "right footfalls"
set grid xtics ytics

# b: the path from above; arrows show where the body faces
eval path_panel
eval heading("b", "Path from above [m]")
eval path_range
eval key_above(path_top)
set style arrow 1 head filled size screen 0.007, 22 lw 1.3 lc rgb ink
arrows = 8.0
arrow = 0.04*(GPVAL_X_MAX - GPVAL_X_MIN)
plot steps using "x_m":(of_left(column("row")) ? column("y_m") : NaN) with points pt 7 ps 0.55 \
         lc rgb "#60".left_side[2:7] title "left feet", \
     steps using "x_m":(of_left(column("row")) ? NaN : column("y_m")) with points pt 7 ps 0.55 \
         lc rgb "#60".right_side[2:7] title "right feet", \
     body using "ideal_x_m":"ideal_y_m" with lines lw 6 lc rgb asked title "commanded", \
     body using "x_m":"y_m" with lines lw 1.8 lc rgb accent title "walked", \
     body using "x_m":"y_m":(0.1*cos(column("yaw_deg")*pi/180)):(0.1*sin(column("yaw_deg")*pi/180)) \
         every ceil(50*t_max/arrows) with vectors as 1 notitle

# c: the gait diagram; below it the type of the gait state, and where the CCN was adjusted
eval gait_panel
eval heading("c", "Legs in the air")
eval legend_of_types(0.50, 0.05)
set label 15 "|" at graph 0.78, graph 1 offset 0, 0.9 left textcolor rgb accent font sized(":Bold", 10.5)
set label 25 "CCN adjusted" at graph 0.795, graph 1 offset 0, 0.9 left textcolor rgb ink font small
set xrange [0:t_max]; set yrange [legs+0.75:-0.65]
set ytics @row_names scale 0
set grid noytics
set style fill solid 1 noborder
set xlabel "time [s]" offset 0, 0.5
unset key
row(k) = column("row") + k
plot steps using "lift_s":(of_left(column("row")) ? column("row") : NaN):"lift_s":"land_s":(row(-0.32)):(row(0.32)) \
         with boxxyerror lc rgb left_side, \
     steps using "lift_s":(of_left(column("row")) ? NaN : column("row")):"lift_s":"land_s":(row(-0.32)):(row(0.32)) \
         with boxxyerror lc rgb right_side, \
     gait using "from_s":(legs):"from_s":"to_s":(legs-0.32):(legs+0.16):(type_shade(column("type_index"))) \
         with boxxyerror lc rgb variable, \
     gait using "from_s":(column("ccn_before_adjustment") == legs/2 ? NaN : legs+0.28):(0):(0.3) \
         with vectors nohead lw 1.3 lc rgb accent
do for [k=10:15] { unset label k }
do for [k=20:25] { unset label k }

# d, e: the body
eval height_panel
eval heading("d", "Height [m]")
unset ytics; set ytics nomirror scale 0.5 textcolor rgb ink autofreq
set grid ytics
set yrange [0:*]; set offsets 0, 0, 0.04, 0
set format x ""; set xlabel ""
eval key_above(height_top)
plot body using "time_s":"ground_m" with filledcurves y1=0 fs solid 0.6 lc rgb earth title "ground below", \
     body using "time_s":"z_m" with lines lw 1.6 lc rgb ink title "base"

eval tilt_panel
eval heading("e", "Tilt of the body [°]")
eval key_above(tilt_top)
set yrange [*<-1:1<*]; set offsets 0, 0, 0.2, 0.2
set format x "%g"
set xlabel "time [s]" offset 0, 0.5
plot body using "time_s":(0) with lines lw 0.8 lc rgb grey notitle, \
     body using "time_s":"roll_deg" with lines lw 1.4 lc rgb left_side title "roll", \
     body using "time_s":"pitch_deg" with lines lw 1.4 lc rgb right_side title "pitch, nose down"
