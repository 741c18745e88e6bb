# A walk from above, the robot at some instants: [PC04] Fig. 9, 10 and 11.
eval ground_panel
eval ground_range
eval key_above(ground_top)
set label 3 "From above [m]" at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
set style fill transparent solid 0.85 noborder
set palette defined (0 "#f7f4ef", 1 "#b3a184")
set cbrange [0:level_max]
set cblabel "height of the ground [m]" textcolor rgb ink
set colorbox user origin graph 1.012, graph 0 size 0.012, graph 0.5 noborder

cells = rough ? 'stem."-terrain.csv" using (0.5*(c("x_min_m")+c("x_max_m"))):(0.5*(c("y_min_m")+c("y_max_m"))): \
    "x_min_m":"x_max_m":"y_min_m":"y_max_m":"height_m" with boxxyerror fs solid 1 border lc rgb "#ffffff" \
    lc palette notitle, ' : ""
circles = commanded ? 'stem."-commands.csv" using "x_m":"y_m" with points pt 6 ps 1.6 lw 1.8 lc rgb ink \
    title "a new command", ' : ""
body = stem."-body.csv"; legs = stem."-legs.csv"; outlines = stem."-outlines.csv"; snapshots = stem."-snapshots.csv"
plot @cells stem."-steps.csv" using "x_m":"y_m" with points pt 7 ps 0.4 lc rgb "#80".ink[2:7] title "footholds", \
     body using "ideal_x_m":"ideal_y_m" with lines lw 7 lc rgb asked title "commanded", \
     legs using "x_m":"y_m" with lines lw 1.6 lc rgb left_side notitle, \
     legs using "x_m":"y_m" every 2::1 with points pt 7 ps 0.6 lc rgb left_side notitle, \
     outlines using "x_m":"y_m" with filledcurves closed fs transparent solid 0.28 lc rgb left_side notitle, \
     outlines using "x_m":"y_m" with lines lw 1.6 lc rgb left_side title "the robot", \
     body using "x_m":"y_m" with lines lw 1.8 lc rgb accent title "walked", @circles \
     snapshots using "x_m":"y_m":(0.3*cos(c("yaw_rad"))):(0.3*sin(c("yaw_rad"))) with vectors filled \
         size screen 0.007, 22 lw 1.6 lc rgb ink notitle, \
     snapshots using (c("x_m")-0.18*cos(c("yaw_rad"))-0.08*sin(c("yaw_rad"))): \
         (c("y_m")-0.18*sin(c("yaw_rad"))+0.08*cos(c("yaw_rad"))):(strcol("snapshot")) with labels \
         font sized(":Bold", 14) textcolor rgb ink notitle
