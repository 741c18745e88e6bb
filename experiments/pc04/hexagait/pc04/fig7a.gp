# [PC04] Fig. 7-A; after slice_comparison.gp.
lift = 1.75; lead_format = "%+.3f ± %.3f"
eval speeds(0.19, 0.60, 0.14, 0.76, sprintf("Mean speed over %d slices, per start [units per slice]", slices))
eval leads(0.655, 0.98, 0.14, 0.76)
