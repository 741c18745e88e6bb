# Shapes and text in pixels of the sheet, y downwards; the script of a Drawing ends with the plot.
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 0; set tmargin at screen 1
unset border; unset tics; unset grid; unset key
set xrange [0:width]; set yrange [height:height-page]
