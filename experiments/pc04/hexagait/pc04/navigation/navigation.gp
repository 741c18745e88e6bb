# [PC04] 5.2: where Genghis went among walls and cliffs, from above.
eval panel(0.07, 0.97, 0.06, 0.89)
eval ground_range
eval key_above(0.89)
set label 3 "From above [m]" at graph 0, graph 1 offset 0, 0.9 left textcolor rgb ink
unset grid
set palette defined (-1 "#5d7a8c", -0.5 "#5d7a8c", -0.05 "#f7f4ef", 0.05 "#f7f4ef", 0.4 "#dccfb8", 0.9 "#8a7553", 1.3 "#8a7553")
set cbrange [-1:1.3]
unset colorbox
meetings = stem."-meetings.csv"
is(what, x) = strcol("reason") eq what ? x : NaN
plot stem."-ground.csv" using "x_m":"y_m":"half_m":"half_m":"height_m" with boxxyerror fs solid 1 noborder \
         lc palette notitle, \
     stem."-trace.csv" using "x_m":"y_m" with lines lw 0.6 lc rgb ink title "walked", \
     meetings using (is("cliff", c("x_m"))):"y_m" with points pt 7 ps 0.45 lc rgb left_side title "a cliff ahead", \
     meetings using (is("touch", c("x_m"))):"y_m" with points pt 7 ps 0.45 lc rgb accent title "a whisker touches", \
     meetings using (is("wall", c("x_m"))):"y_m" with points pt 7 ps 0.45 lc rgb right_side title "a wall ahead", \
     meetings using (is("steep", c("x_m"))):"y_m" with points pt 5 ps 0.5 lc rgb "#3a8f5c" title "too steep"
