# Terrains as shaded surfaces, each with its name. Given: names; columns and rows of the sheet;
# below_titles, the share of the sheet that is theirs.
unset key; unset tics; unset border; unset grid; unset colorbox
set pm3d depthorder lighting primary 0.55 specular 0.0 noborder
set palette defined (-1 "#5d5148", -0.99 "#6e6055", 0 "#e6dcc8", 1 "#a88f6a", 1.5 "#a88f6a", 2 "#9cc7dd", 2.5 "#9cc7dd", 3 "#a37a58")
set cbrange [-1:3]
set view 50, 28, 2.35, 1.0
set view equal xyz
set xrange [-0.9:4.6]; set yrange [-1.6:1.6]; set zrange [-0.8:0.8]; set xyplane at -0.8
set lmargin 0; set rmargin 0; set bmargin 0; set tmargin 0
wide = 1.0/columns; tall = below_titles/rows
do for [k=1:|names|] {
  across = (k-1) % columns; down = (k-1)/columns
  set size wide, tall
  set origin across*wide, below_titles - (down+1)*tall
  set label 3 names[k] at screen (across+0.5)*wide, screen below_titles - (down+0.93)*tall center noenhanced \
      textcolor rgb ink font sized(":Bold", 10)
  splot sprintf("%s-%d.csv", stem, k) using "x_m":"y_m":"z_m":"paint" with pm3d
}
