"""Is the true growth of the stand inside the reported 95 % intervals?

usage: STEMWISE=build/release/bin/stemwise python3 tools/acceptance/calibration.py [--seeds 100] [--stems 300] [--drift 0.02]
The five surveys of drift.py (two walks that drift by 2 %, three bare lists, 1 cm DBH noise, 0.2 m position noise, 20 % missed). The truth of a
step is the mean (and the median) true DBH change of the trees alive in both years, counted from truth/trees.csv alone. Of the
seeds, 93 in 100 must have the true mean inside the reported interval of the mean, in every step. The median and the robust
figure are told beside it: errors of measurement draw the median of a skewed stand towards the mean.
Exit 1 where a bound is missed.
"""
import argparse, collections, json, statistics, sys, tempfile

from drift import YEARS, make_project, table


def true_changes(truth, a, b):
    """DBH change in cm of every tree alive in both years."""
    gone = {"dead", "removed", "not_yet"}
    alive = [r for r in truth if all(r[f"dbh_cm_{y}"] and r[f"fate_{y}"] not in gone for y in (a, b))]
    return [float(r[f"dbh_cm_{b}"]) - float(r[f"dbh_cm_{a}"]) for r in alive]


def inside(interval, value):
    return interval[0] <= value <= interval[1]


def run(seed, stems, drift, hits):
    with tempfile.TemporaryDirectory() as t:
        make_project(t, seed, stems, drift)
        truth, result = table(f"{t}/lists/truth/trees.csv"), json.load(open(f"{t}/p.json"))
    for row in result["growth"]:
        step, change = f"{row['from']}-{row['to']}", true_changes(truth, row["from"], row["to"])
        mean, median = statistics.mean(change), statistics.median(change)
        hits[step, "mean"] += inside(row["mean_dbh_change_cm"]["ci95"], mean)
        hits[step, "robust"] += inside(row["robust_dbh_change_cm"]["ci95"], mean)
        hits[step, "median"] += inside(row["ci95_cm"], median)
        hits[step, "off"] += row["mean_dbh_change_cm"]["value"] - mean
        hits[step, "n"] += row["n"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--stems", type=int, default=300)
    parser.add_argument("--drift", type=float, default=0.02)
    options = parser.parse_args()
    hits = collections.Counter()
    for k in range(options.seeds):
        run(options.first + k, options.stems, options.drift, hits)
        if (k + 1) % 10 == 0:
            print(f"after {k + 1} seeds: " + ", ".join(f"{a}-{b} {hits[f'{a}-{b}', 'mean']}" for a, b in zip(YEARS, YEARS[1:])), flush=True)
    ok = True
    for a, b in zip(YEARS, YEARS[1:]):
        step = f"{a}-{b}"
        good = hits[step, "mean"] >= 0.93 * options.seeds
        ok &= good
        print(f"{step}: true mean inside in {hits[step, 'mean']} of {options.seeds} seeds (robust {hits[step, 'robust']}; true median inside its interval {hits[step, 'median']}), "
              f"mean error {hits[step, 'off'] / options.seeds:+.4f} cm, {hits[step, 'n'] / options.seeds:.0f} stems a seed{'' if good else '   MISSED'}")
    sys.exit(0 if ok else 1)


if __name__ == "__main__":
    main()
