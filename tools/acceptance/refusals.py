"""Pairs that no pose may be accepted for: unrelated stands, mirrored copies, planted grids, each moved at random.

usage: STEMWISE=build/release/bin/stemwise python3 tools/acceptance/refusals.py ../shared/data [--pairs 30] [--seed 0] [--large 8000]
--large adds one pair of unrelated simulated forests of that many stems each.
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


def simulate(stems, seed, path):
    """One survey of a simulated forest, left at `path`."""
    with tempfile.TemporaryDirectory() as t:
        call = ["simulate", "-o", t, "--years", "2010", "--stems", str(stems), "--seed", str(seed), "--quiet"]
        subprocess.run([os.environ["STEMWISE"], *call], check=True)
        os.replace(f"{t}/2010.csv", path)


def refuse(folder):
    """Aligns a.csv and b.csv: exit code, seconds, whether a project was left, what it said."""
    start = time.time()
    call = ["align", f"{folder}/a.csv", f"{folder}/b.csv", "-o", f"{folder}/p.gpkg", "--quiet"]
    r = subprocess.run([os.environ["STEMWISE"], *call], capture_output=True, text=True)
    return r.returncode, time.time() - start, os.path.exists(f"{folder}/p.gpkg"), r.stderr


def main():
    p = argparse.ArgumentParser()
    p.add_argument("data")
    p.add_argument("--pairs", type=int, default=30)
    p.add_argument("--seed", type=int, default=0)
    p.add_argument("--large", type=int, default=0)
    a = p.parse_args()
    all_stands, accepted, slowest, other = stands(a.data), 0, 0.0, 0
    if not all_stands and a.pairs:
        print(f"SKIPPED: no mtrainier in {a.data}")
        sys.exit(77)
    for k in range(a.pairs + (a.large > 0)):
        rng = random.Random(f"{a.seed} {k}")
        kind = ("unrelated", "mirrored", "grid")[k % 3] if k < a.pairs else f"{a.large} stems each"
        with tempfile.TemporaryDirectory() as t:
            if k < a.pairs:
                first, second = make_pair(kind, all_stands, rng)
                write(f"{t}/a.csv", first, 2010)
                write(f"{t}/b.csv", second, 2016)
            else:
                simulate(a.large, 1, f"{t}/a.csv")
                simulate(a.large, 2, f"{t}/b.csv")
            code, seconds, left, said = refuse(t)
        slowest = max(slowest, seconds)
        if k >= a.pairs:
            print(f"  {kind}: exit {code} after {seconds:.1f} s")
        if code == 0 or left:
            accepted += 1
            print(f"  accepted: pair {k}, {kind}")
        elif code != 1:
            other += 1
            print(f"  pair {k}: exit {code}: {said[-200:]}")
    print(f"{a.pairs + (a.large > 0)} pairs (unrelated, mirrored, planted), {accepted} accepted, {other} failed otherwise, slowest refusal {slowest:.1f} s")
    sys.exit(bool(accepted or other))


main()
