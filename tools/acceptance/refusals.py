"""Pairs that no pose may be accepted for: unrelated stands, mirrored copies, planted grids, each moved at random.

usage: STEMWISE=build/release/bin/stemwise python3 tools/acceptance/refusals.py ../shared/data [--pairs 30] [--seed 0]
Prints every accepted pair (there must be none) and the slowest refusal; exit 1 where a pose was accepted.
"""
import argparse, csv, glob, math, os, random, subprocess, sys, tempfile, time


def stands(data):
    out = {}
    for path in sorted(glob.glob(f"{data}/mtrainier/*_*.csv")):
        if "centers" in path:
            continue
        rows = [(r["stem_id"], float(r["x_m"]), float(r["y_m"]), float(r["dbh_cm"])) for r in csv.DictReader(open(path, newline=""))]
        out[os.path.basename(path)[:-4]] = rows
    return out


def crop(rows, rng):
    """A part of the stand, so that sizes from a small plot to the whole stand are tried."""
    side = rng.uniform(30, 110)
    x0, y0 = rng.uniform(0, max(1, 100 - side)), rng.uniform(0, max(1, 100 - side))
    part = [r for r in rows if x0 <= r[1] <= x0 + side and y0 <= r[2] <= y0 + side]
    return part if len(part) >= 15 else rows


def moved(rows, rng, mirror=False, noise=0.2):
    yaw, tx, ty = rng.uniform(-math.pi, math.pi), rng.uniform(-300, 300), rng.uniform(-300, 300)
    c, s = math.cos(yaw), math.sin(yaw)
    out = []
    for i, x, y, d in rows:
        x, y = (-x if mirror else x) + rng.gauss(0, noise), y + rng.gauss(0, noise)
        out.append((i, c * x - s * y + tx, s * x + c * y + ty, max(1.0, d + rng.gauss(0, 0.7))))
    return out


def grid(rng):
    """A plantation: rows at one spacing, a little jitter, one narrow DBH distribution."""
    nx, ny, gap = rng.randint(8, 30), rng.randint(8, 30), rng.choice([2.0, 2.5, 3.0])
    return [(f"{i}-{j}", i * gap + rng.gauss(0, 0.15), j * gap + rng.gauss(0, 0.15), rng.gauss(22, 3)) for i in range(nx) for j in range(ny) if rng.random() > 0.1]


def make_pair(kind, all_stands, rng):
    if kind == "grid":
        return grid(rng), moved(grid(rng), rng)
    names = sorted(all_stands)
    first = rng.choice(names)
    if kind == "mirrored":
        part = crop(all_stands[first], rng)
        return part, moved(part, rng, mirror=True)
    second = rng.choice([n for n in names if n[:4] != first[:4]])
    return crop(all_stands[first], rng), moved(crop(all_stands[second], rng), rng)


def write(path, rows, year):
    with open(path, "w", newline="") as f:
        w = csv.writer(f)
        w.writerow(["id", "x_m", "y_m", "dbh_cm", "date"])
        w.writerows([i, f"{x:.3f}", f"{y:.3f}", f"{d:.1f}", f"{year}-07-01"] for i, x, y, d in rows)


def main():
    p = argparse.ArgumentParser()
    p.add_argument("data")
    p.add_argument("--pairs", type=int, default=30)
    p.add_argument("--seed", type=int, default=0)
    a = p.parse_args()
    all_stands, accepted, slowest, other = stands(a.data), 0, 0.0, 0
    for k in range(a.pairs):
        rng = random.Random(f"{a.seed} {k}")
        kind = ("unrelated", "mirrored", "grid")[k % 3]
        first, second = make_pair(kind, all_stands, rng)
        with tempfile.TemporaryDirectory() as t:
            write(f"{t}/a.csv", first, 2010)
            write(f"{t}/b.csv", second, 2016)
            start = time.time()
            r = subprocess.run([os.environ["STEMWISE"], "align", f"{t}/a.csv", f"{t}/b.csv", "-o", f"{t}/p.gpkg", "--quiet"], capture_output=True, text=True)
            slowest = max(slowest, time.time() - start)
            left = os.path.exists(f"{t}/p.gpkg")
        if r.returncode == 0 or left:
            accepted += 1
            print(f"  accepted: pair {k}, {kind}, {len(first)} and {len(second)} stems")
        elif r.returncode != 1:
            other += 1
            print(f"  pair {k}: exit {r.returncode}: {r.stderr[-200:]}")
    print(f"{a.pairs} pairs (unrelated, mirrored, planted), {accepted} accepted, {other} failed otherwise, slowest refusal {slowest:.1f} s")
    sys.exit(bool(accepted or other))


main()
