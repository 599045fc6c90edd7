"""Two maps of one simulated stand, one of them made with compass and tape: 1 to 1.7 m of noise.

usage: STEMWISE=build/release/bin/stemwise python3 tools/acceptance/tape.py [--seeds 6] [--stems 60,120,400] [--noise 0.5,1.0,1.35,1.7]
The noise is one axis' standard deviation of the difference of both maps; 10 % missed by each, 2 % false stems, no heights, DBH noise 1 cm, five years
apart. A pose is right when it brings the common stems to within 1 m + one noise of the best rigid fit by their true ids.
Prints per size and noise: right, refused, wrong; precision and recall of the matches. Bounds: no wrong pose; 80 % right (stem-lists.md).
"""
import argparse, csv, json, math, os, subprocess, sys, tempfile


def table(path):
    return list(csv.DictReader(open(path, newline="", encoding="utf-8-sig")))


def rigid_fit(pairs):
    """Plane pose of second onto first by least squares; pairs of ((x, y), (x, y))."""
    n = len(pairs)
    ax, ay, bx, by = (sum(p[i][k] for p in pairs) / n for i, k in ((0, 0), (0, 1), (1, 0), (1, 1)))
    dot = sum((q[0] - bx) * (p[0] - ax) + (q[1] - by) * (p[1] - ay) for p, q in pairs)
    cross = sum((q[0] - bx) * (p[1] - ay) - (q[1] - by) * (p[0] - ax) for p, q in pairs)
    yaw = math.atan2(cross, dot)
    c, s = math.cos(yaw), math.sin(yaw)
    return lambda q: (c * (q[0] - bx) - s * (q[1] - by) + ax, s * (q[0] - bx) + c * (q[1] - by) + ay)


def rewrite(path):
    """Leaves heights and axes out: a tape map has none."""
    rows = table(path)
    with open(path, "w", newline="") as f:
        w = csv.writer(f)
        w.writerow(["id", "x_m", "y_m", "dbh_cm", "date"])
        w.writerows([r["id"], r["x_m"], r["y_m"], r["dbh_cm"], r["date"]] for r in rows)
    return {r["id"]: (float(r["x_m"]), float(r["y_m"])) for r in rows}


def try_one(stems, noise, seed):
    stemwise = os.environ["STEMWISE"]
    with tempfile.TemporaryDirectory() as t:
        subprocess.run([stemwise, "simulate", "-o", t, "--years", "2015,2020", "--stems", str(stems), "--position-noise-m", str(noise / math.sqrt(2)), "--seed", str(seed), "--quiet"], check=True)
        first, second = rewrite(f"{t}/2015.csv"), rewrite(f"{t}/2020.csv")
        same = {(r["id_2015"], r["id_2020"]) for r in table(f"{t}/truth/trees.csv") if r["id_2015"] and r["id_2020"]}
        r = subprocess.run([stemwise, "align", f"{t}/2015.csv", f"{t}/2020.csv", "--reference", "2015", "-o", f"{t}/p.gpkg", "--json", f"{t}/r.json", "--quiet"], capture_output=True, text=True)
        if r.returncode:
            return "refused", 0, 0, len(same)
        pose = [v for v in json.load(open(f"{t}/r.json"))["inventories"] if v["name"] == "2020"][0]["T_reference_from_inventory"]
        subprocess.run([stemwise, "export", f"{t}/p.gpkg", "--layer", "matches", "-o", f"{t}/m.csv", "--quiet"], check=True)
        got = {(m["source_id_a"], m["source_id_b"]) for m in table(f"{t}/m.csv") if m["state"] != "rejected"}
    best = rigid_fit([(first[a], second[b]) for a, b in same])
    off = max(math.dist(best(second[b]), (pose[0][0] * second[b][0] + pose[0][1] * second[b][1] + pose[0][3], pose[1][0] * second[b][0] + pose[1][1] * second[b][1] + pose[1][3])) for _, b in same)
    return ("right" if off <= 1.0 + noise else "wrong"), len(got & same), len(got), len(same)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--seeds", type=int, default=6)
    p.add_argument("--stems", default="60,120,400")
    p.add_argument("--noise", default="0.5,1.0,1.35,1.7")
    a = p.parse_args()
    ok = True
    for stems in map(int, a.stems.split(",")):
        for noise in map(float, a.noise.split(",")):
            said, hit, got, want = {"right": 0, "refused": 0, "wrong": 0}, 0, 0, 0
            for seed in range(a.seeds):
                verdict, right, given, true = try_one(stems, noise, seed)
                said[verdict] += 1
                if verdict == "right":
                    hit, got, want = hit + right, got + given, want + true
            good = said["wrong"] == 0 and said["right"] >= 0.8 * a.seeds
            ok &= good
            print(f"{stems} stems, {noise} m: {said['right']} right, {said['refused']} refused, {said['wrong']} wrong; matches precision {hit / max(1, got):.2f}, "
                  f"recall {hit / max(1, want):.2f}{'' if good else '   MISSED'}", flush=True)
    sys.exit(0 if ok else 1)


main()
