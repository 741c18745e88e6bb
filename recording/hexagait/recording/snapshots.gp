# A walk from above, the robot itself at some instants.
table(name) = sprintf("%s-%s.csv", stem, name)
eval walk_panel
eval walk_range
eval key_above(walk_top)
set label 3 "From above [m]" at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
set style fill transparent solid 0.85 noborder
set palette defined (0 "#f7f4ef", 1 "#b3a184")
rough = level_max > 0
set cbrange [0:rough ? level_max : 1]
set cblabel "height of the ground [m]" textcolor rgb ink
set colorbox user origin graph 1.012, graph 0 size 0.012, graph 0.5 noborder

ground = rough ? "table('terrain') using 'x_m':'y_m':(column('x_m')-half_cell):(column('x_m')+half_cell): \
    (column('y_m')-half_cell):(column('y_m')+half_cell):'height_m' with boxxyerror fs solid 1 \
    border lc rgb '#ffffff' lc palette notitle, " : ""
plot @ground table("steps") using "x_m":"y_m" with points pt 7 ps 0.4 lc rgb "#80".ink[2:7] \
         title "footholds", \
     table("body") using "ideal_x_m":"ideal_y_m" with lines lw 7 lc rgb asked title "commanded", \
     table("legs") using "x_m":"y_m" with lines lw 1.6 lc rgb left_side notitle, \
     table("legs") using "x_m":(column("foot") == 1 ? column("y_m") : NaN) with points pt 7 ps 0.6 lc rgb left_side notitle, \
     table("outlines") using "x_m":"y_m" with filledcurves closed fs transparent solid 0.28 \
         lc rgb left_side notitle, \
     table("outlines") using "x_m":"y_m" with lines lw 1.6 lc rgb left_side title "the robot", \
     table("body") using "x_m":"y_m" with lines lw 1.8 lc rgb accent title "walked", \
     table("snapshots") using "x_m":"y_m":(0.3*cos(column("yaw_rad"))):(0.3*sin(column("yaw_rad"))) with vectors filled \
         size screen 0.007, 22 lw 1.6 lc rgb ink notitle, \
     table("snapshots") using (column("x_m")-0.18*cos(column("yaw_rad"))-0.08*sin(column("yaw_rad"))): \
         (column("y_m")-0.18*sin(column("yaw_rad"))+0.08*cos(column("yaw_rad"))):"snapshot" with labels \
         font sized(":Bold", 14) textcolor rgb ink notitle
