# [PC04] Fig. 7-B; after slice_comparison.gp. Above one of the descents, below all profiles.
lift = 1.6; lead_format = "%+.2f ± %.2f"
eval speeds(0.165, 0.56, 0.555, 0.85, terrain_title.": mean speed, per start [units per slice]")
eval leads(0.625, 0.98, 0.555, 0.85)

# x: roughness, on a scale that shows 0 and 40
profiles = stem."-profiles.csv"
squeezed(r) = r**0.5
dash(k) = k == 3 ? 3 : k == 2 ? 2 : 1
set xtics ("0" 0, "½" squeezed(0.5), "1" 1, "2" squeezed(2), "4" 2, "8" squeezed(8), "12" squeezed(12), "20" squeezed(20), "40" squeezed(40))
set xrange [0:squeezed(40)]
set xlabel "roughness [descent per slice]" offset 0, 0.4
set ytics nomirror scale 0.5 textcolor rgb ink autofreq; set grid ytics
if_gait(k, x) = c("gait_number") == k ? x : NaN
x = '(if_gait(k, squeezed(c("roughness"))))'
band = '(if_gait(k, c(value) - c(spread_of))):(if_gait(k, c(value) + c(spread_of))) ' \
       .'with filledcurves fs transparent solid 0.25 lc rgb gait_colour(k) notitle'
curve = 'with linespoints pt 7 ps 0.5 lw 1.8 dt dash(k) lc rgb gait_colour(k)'

eval panel(0.045, 0.33, 0.09, 0.42)
eval heading("c", "Ground profiles, feet raised by 5: speed")
set yrange [0:9]
set key at graph 0.98, graph 0.97 right top reverse Left samplen 1.5 font small
value = "mean"; spread_of = "half_width_95"
plot for [k=0:3] profiles using @x:@band, \
     for [k=0:3] profiles using @x:value @curve title names[k+1]

eval panel(0.385, 0.66, 0.09, 0.42)
eval heading("d", "Lead of the free gait over the tripod controller")
set yrange [*:*]
unset key
value = "ahead"; spread_of = "ahead_half_width_95"
k = 1
plot profiles using @x:@band, profiles using @x:value @curve, 0 with lines dt 2 lw 1 lc rgb grey

eval panel(0.71, 0.98, 0.09, 0.42)
eval heading("e", "Longest stroke that it needs [units]")
set yrange [0:100]; set ytics 25
value = "sweep"
plot for [k=0:3] profiles using @x:value @curve
