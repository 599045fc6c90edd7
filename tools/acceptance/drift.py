"""Five surveys of one forest, two of them frames whose trajectories drift by 2 %, three bare lists: ids and what is left of the drift.

usage: STEMWISE=build/release/bin/stemwise python3 tools/acceptance/drift.py [--seeds 3] [--stems 300] [--drift 0.02]
0.2 m position noise, 20 % missed, DBH noise 1 cm. The project's frame is laid onto the truth by the stems of the lists,
whose true ids are known; a stem of a frame survey belongs to the true tree within 0.6 m that is nearest. Of trees with two
or more sightings, the share whose sightings have ids that no other tree's have, and no more ids than it has stems, must be 0.97.
Stems at one spot (0.3 m) are one tree: the simulator plants second stems 0.25 m beside the first, of the same diameter, and which
of the two was which under 0.2 m of noise nobody can say. "stem by stem" is the same share with every stem a tree of its own; the stems of frame
surveys must lie within 0.15 m of their tree (root mean square of each 20 m square's mean, so that the noise of single
positions averages out). Exit 1 where a bound is missed.
"""
import argparse, collections, csv, math, os, subprocess, sys, tempfile

YEARS = ["2011", "2014", "2017", "2020", "2023"]
WALKED = {"2014", "2020"}


def table(path):
    return list(csv.DictReader(open(path, newline="", encoding="utf-8-sig")))


def rigid(pairs):
    """Plane turn and shift of least squares, twice, the second time without gross errors."""
    for _ in range(3):
        n = len(pairs)
        ax, ay, bx, by = (sum(p[k] for p in pairs) / n for k in range(4))
        dot = sum((p[0] - ax) * (p[2] - bx) + (p[1] - ay) * (p[3] - by) for p in pairs)
        cross = sum((p[0] - ax) * (p[3] - by) - (p[1] - ay) * (p[2] - bx) for p in pairs)
        t = math.atan2(cross, dot)
        c, s = math.cos(t), math.sin(t)
        move = lambda x, y: (c * (x - ax) - s * (y - ay) + bx, s * (x - ax) + c * (y - ay) + by)
        off = [math.dist(move(p[0], p[1]), p[2:]) for p in pairs]
        limit = 4 * sorted(off)[n // 2] + 0.01
        pairs = [p for p, o in zip(pairs, off) if o <= limit]
    return move


def make_project(t, seed, stems, drift):
    """Simulates the five surveys in folder `t` and aligns them: t/p.gpkg, t/p.json, t/lists/truth."""
    stemwise = os.environ["STEMWISE"]
    common = ["--years", ",".join(YEARS), "--stems", str(stems), "--position-noise-m", "0.2", "--drop", "0.2", "--dbh-noise-cm", "1", "--seed", str(seed), "--quiet"]
    subprocess.run([stemwise, "simulate", "-o", f"{t}/lists", *common], check=True)
    subprocess.run([stemwise, "simulate", "-o", f"{t}/walks", *common, "--frames", "--drift", str(drift)], check=True)
    inputs = [f"{t}/walks/{y}" if y in WALKED else f"{t}/lists/{y}.csv" for y in YEARS]
    subprocess.run([stemwise, "align", *inputs, "-o", f"{t}/p.gpkg", "--json", f"{t}/p.json", "--seed", str(seed), "--quiet"], check=True)


def run(seed, stems, drift):
    stemwise = os.environ["STEMWISE"]
    with tempfile.TemporaryDirectory() as t:
        make_project(t, seed, stems, drift)
        subprocess.run([stemwise, "export", f"{t}/p.gpkg", "--layer", "observations", "-o", f"{t}/o.csv", "--quiet"], check=True)
        return judge(table(f"{t}/lists/truth/trees.csv"), table(f"{t}/o.csv"))


def judge(truth, rows):
    place = {r["tree_id"]: next((float(r[f"x_m_{y}"]), float(r[f"y_m_{y}"])) for y in YEARS if r[f"x_m_{y}"]) for r in truth}
    known = {(y, r[f"id_{y}"]): r["tree_id"] for r in truth for y in YEARS if y not in WALKED and r[f"id_{y}"]}
    pairs = [(float(r["x"]), float(r["y"]), *place[known[r["inventory"], r["source_id"]]]) for r in rows if (r["inventory"], r["source_id"]) in known]
    move = rigid(pairs)
    cells = collections.defaultdict(list)
    for tree, (x, y) in place.items():
        cells[int(x // 2), int(y // 2)].append(tree)
    sightings, squares = collections.defaultdict(list), collections.defaultdict(list)
    for r in rows:
        year, at = r["inventory"], move(float(r["x"]), float(r["y"]))
        tree = known.get((year, r["source_id"]))
        if tree is None and year in WALKED:
            near = [(math.dist(at, place[k]), k) for u in (-1, 0, 1) for v in (-1, 0, 1) for k in cells[int(at[0] // 2) + u, int(at[1] // 2) + v]]
            if near and min(near)[0] < 0.6:
                tree = min(near)[1]
                squares[year, int(at[0] // 20), int(at[1] // 20)].append((at[0] - place[tree][0], at[1] - place[tree][1]))
        if tree is not None:
            sightings[tree].append((year, r["tree_id"]))
    tree_of = trees_of_stems(place)
    return (share_right(sightings, {k: k for k in place}), share_right(sightings, tree_of), left_of_drift(squares),
            len({tree_of[k] for k, v in sightings.items() if len({y for y, _ in v}) >= 2}))


def trees_of_stems(place):
    """Stems within 0.3 m of each other are one tree, named by its first stem."""
    names, tree_of = sorted(place), {}
    for k in names:
        tree_of[k] = next((tree_of[o] for o in names if o in tree_of and math.dist(place[k], place[o]) < 0.3), k)
    return tree_of


def share_right(stem_sightings, tree_of):
    sightings, stems, owner = collections.defaultdict(list), collections.Counter(tree_of.values()), collections.defaultdict(set)
    for stem, seen in stem_sightings.items():
        sightings[tree_of[stem]] += seen
    for tree, seen in sightings.items():
        for _, given in seen:
            owner[given].add(tree)
    several = {k: v for k, v in sightings.items() if len({y for y, _ in v}) >= 2}
    right = sum(len({g for _, g in v}) <= stems[k] and all(len(owner[g]) == 1 for _, g in v) for k, v in several.items())
    return right / max(1, len(several))


def left_of_drift(squares):
    off = [(sum(p[0] for p in v) / len(v)) ** 2 + (sum(p[1] for p in v) / len(v)) ** 2 for v in squares.values() if len(v) >= 5]
    return math.sqrt(sum(off) / max(1, len(off)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--stems", type=int, default=300)
    parser.add_argument("--drift", type=float, default=0.02)
    options = parser.parse_args()
    ok = True
    for seed in range(options.seeds):
        by_stem, right, residual, count = run(seed, options.stems, options.drift)
        good = right >= 0.97 and residual < 0.15
        print(f"seed {seed}: ids right for {right:.3f} of {count} trees with two or more sightings (stem by stem {by_stem:.3f}), drift left {residual:.3f} m{'' if good else '   MISSED'}")
        ok &= good
    sys.exit(0 if ok else 1)


if __name__ == "__main__":
    main()
