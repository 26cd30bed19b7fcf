"""Prints results of Google Benchmark (JSON files) as one table, and the ratios that count."""
import json
import sys

fastest = {}
for path in sys.argv[1:]:
    with open(path) as file:
        for run in json.load(file)["benchmarks"]:
            if run.get("run_type") != "iteration" or run.get("error_occurred"):
                continue
            name = run["name"].removesuffix("/real_time")
            if "items_per_second" not in run:
                continue
            run["each"] = 1e6 / run["items_per_second"]  # microseconds
            if name not in fastest or run["each"] < fastest[name]["each"]:
                fastest[name] = run


def number(run, key, form):
    return format(run[key], form) if key in run else ""


width = max(len(name) for name in fastest)
print(f"{'':{width}}  {'us each':>10}  {'iterations':>10}  {'residual':>8}")
for name, run in sorted(fastest.items()):
    # Without a residual these are of the benchmark itself.
    iterations = number(run, "iterations", ".2f") if "residual" in run else ""
    print(f"{name:{width}}  {run['each']:10.3f}  {iterations:>10}  {number(run, 'residual', '.0e'):>8}")


def ratio(text, above, below, bar):
    if above in fastest and below in fastest:
        value = fastest[above]["each"] / fastest[below]["each"]
        print(f"{text:{width}}  {value:10.2f}  {bar}")


print("\nratios")
ball = "solve/5dof_20_balls"
ratio("scalar to batch", f"{ball}/scalar_cold", f"{ball}/batch_cold", "at least 4 with AVX-512")
ratio("scalar to batch, AVX2", f"{ball}/scalar_cold", f"{ball}/batch_cold_avx2", "at least 2.5")
ratio("scalar to batch, SSE2", f"{ball}/scalar_cold", f"{ball}/batch_cold_sse2", "")
ratio("batch to limit", f"{ball}/batch_cold", "limit/5dof_20_balls", "at most 2.5")
ratio("batch to limit, AVX2", f"{ball}/batch_cold_avx2", "limit/5dof_20_balls_avx2", "at most 2.5")
ratio("batch to limit, thrust", "solve/thrust/batch", "limit/thrust", "")
ratio("sweep: cold to neighbour", "sweep/100_speeds/scalar_cold", "sweep/100_speeds/scalar_neighbour", "")
ratio("sweep: cold to extrapolated", "sweep/100_speeds/scalar_cold", "sweep/100_speeds/scalar_predicted", "")
ratio("one thread to two, solves", f"{ball}/batch_cold", f"{ball}/batch_cold_2_threads", "at least 1.8 on two free cores")
ratio("one thread to two, table", "table/1e6", "table/1e6_2_threads", "at least 1.8 on two free cores")
ratio("one thread to two, calibration", "calibrate/10000_rows_moved", "calibrate/10000_rows_moved_2_threads", "")


def bar(text, name, times, limit):
    if name in fastest:
        print(f"{text:{width}}  {times * fastest[name]['each']:10.3f}  {limit}")


print("\ntimes")
bar("cold solve in a batch [us]", f"{ball}/batch_cold", 1, "at most 2")
bar("pure thrust in a batch [us]", "solve/thrust/batch", 1, "at most 0.15")
bar("table of a million points [s]", "table/1e6", 1, "at most 2")
bar("verdict on 120 rows, singles [ms]", "diagnose/120_rows_singles", 1e-3, "at most 20")
bar("verdict on 120 rows, pairs [ms]", "diagnose/120_rows_pairs", 1e-3, "at most 300")
