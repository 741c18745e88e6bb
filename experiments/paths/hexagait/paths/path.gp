# A figure of eight and a square with sharp corners, walked on flat ground and over boxes, from above.
paths = stem."-paths.csv"; traces = stem."-traces.csv"
of_path(shape) = strcol("path") eq shape ? c("x_m") : NaN
of_walk(shape, terrain, by) = strcol("path") eq shape && strcol("terrain") eq terrain && strcol("localised_by") eq by ? c("x_m") : NaN
shape_1 = 'figure of eight'; shape_2 = 'square'; terrain_1 = 'flat'; terrain_2 = 'boxes:0.15'
drawn(shape, terrain) = \
  "plot paths using (of_path(".shape.")):'y_m' with lines lw 5 lc rgb asked title 'path', ". \
  "traces using (of_walk(".shape.", ".terrain.", 'odometry')):'y_m' with dots lc rgb accent notitle, ". \
  "NaN with lines lw 2 lc rgb accent title 'by odometry', ". \
  "traces using (of_walk(".shape.", ".terrain.", 'truth')):'y_m' with dots lc rgb left_side notitle, ". \
  "NaN with lines lw 2 lc rgb left_side title 'place given'"
eval a_panel
eval heading("a", "Flat ground [m]")
eval a_range
eval key_above(a_top)
eval drawn("shape_1", "terrain_1")
eval b_panel
eval heading("b", "Flat ground [m]")
eval b_range
eval key_above(b_top)
eval drawn("shape_2", "terrain_1")
eval c_panel
eval heading("c", "Boxes of up to 15 cm [m]")
eval c_range
eval key_above(c_top)
eval drawn("shape_1", "terrain_2")
eval d_panel
eval heading("d", "Boxes of up to 15 cm [m]")
eval d_range
eval key_above(d_top)
eval drawn("shape_2", "terrain_2")
