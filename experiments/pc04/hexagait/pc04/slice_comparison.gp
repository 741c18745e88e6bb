# A row per gait: dots for its trials, which lie beside each other in the order of their numbers, and
# the mean with its interval. Given: `names` of the gaits; `most_speed`; `least_lead`, `most_lead`.
trials = stem."-trials.csv"; means = stem."-means.csv"
spread(trial) = 0.26*(2.0*((trial*0.618034) - floor(trial*0.618034)) - 1)
place = '(c("gait_number") + spread(c("trial"))):(gait_colour(c("gait_number")))'

# Values stand `lift` above their diamonds, and within the panel: half of one is some pixels wide.
values(l, r, low, high, pixels) = sprintf("low = %g; high = %g; set xrange [low:high]; ", low, high). \
    sprintf("half = %f/width/%g*(high - low)", pixels, r - l)
within(x) = x < low + half ? low + half : x > high - half ? high - half : x
speeds(l, r, b, t, text) = panel(l, r, b, t)."; ".heading("a", text)."; ".values(l, r, 0.0, ceil(most_speed + 0.2), 20).' \
  ; set yrange [|names|-0.4:-0.6]; set grid noytics; set xtics 1; unset key; \
  unset ytics; set ytics nomirror scale 0 textcolor rgb ink; set ytics ("" 0); \
  do for [k=1:|names|] { set ytics add (names[k] k-1) }; \
  plot trials using "speed":@place with points pt 7 ps 0.4 lc rgb variable, \
      means using "mean":"gait_number":"half_width_95" with xerrorbars pt 2 ps 0 lw 2 lc rgb ink, \
      means using "mean":"gait_number" with points pt 13 ps 1.3 lc rgb ink, \
      means using (within(c("mean"))):"gait_number":(sprintf("%.2f", c("mean"))) with labels \
          offset 0, lift font small textcolor rgb ink'
if_led(x) = c("gait_number") > 0 ? x : NaN
leads(l, r, b, t) = panel(l, r, b, t)."; ".heading("b", "Ahead of the tripod controller, in pairs")."; ". \
  values(l, r, floor(least_lead - 0.3), ceil(most_lead + 0.3), 55).' \
  ; unset ytics; set arrow 1 from 0, graph 0 to 0, graph 1 nohead lc rgb grey lw 1 dt 2; \
  plot trials using (if_led(c("ahead"))):@place with points pt 7 ps 0.4 lc rgb variable, \
      means using (if_led(c("ahead"))):"gait_number":"ahead_half_width_95" with xerrorbars pt 2 ps 0 lw 2 lc rgb ink, \
      means using (if_led(c("ahead"))):"gait_number" with points pt 13 ps 1.3 lc rgb ink, \
      means using (if_led(within(c("ahead")))):"gait_number": \
          (sprintf(lead_format, c("ahead"), c("ahead_half_width_95"))) with labels \
          offset 0, lift font small textcolor rgb ink; \
  unset arrow 1'
