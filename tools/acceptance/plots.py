"""Independent maps of the same plots (huron, dronelidar_t3, prf025), each moved at random, aligned by the built program.

usage: STEMWISE=build/release/bin/stemwise python3 tools/acceptance/plots.py ../shared/data [--seeds 1]
A plot counts as right when its pose brings the common trees to within 1 m of where the rigid fit by their ids puts them.
Bounds: huron and dronelidar_t3 at least 80 % right and none wrong; prf025 at least 45 of its 49 derived pairs.
"""
import argparse, csv, json, math, os, random, subprocess, sys, tempfile


def rows(path):
    return list(csv.DictReader(open(path, newline="", encoding="utf-8-sig")))


def move(points, yaw, tx, ty):
    c, s = math.cos(yaw), math.sin(yaw)
    return [(i, c * x - s * y + tx, s * x + c * y + ty, d) for i, x, y, d in points]


def write(path, points, year):
    with open(path, "w", newline="") as f:
        w = csv.writer(f)
        w.writerow(["id", "x_m", "y_m", "dbh_cm", "date"])
        for i, x, y, d in points:
            w.writerow([i, f"{x:.3f}", f"{y:.3f}", f"{d:.1f}" if d else "", f"{year}-07-01"])


def fit_by_ids(a, b):
    """The rigid pose of b onto a by least squares over common ids, robust by one trimming."""
    place = {i: (x, y) for i, x, y, _ in a}
    pairs = [(place[i], (x, y)) for i, x, y, _ in b if i in place]
    for _ in range(4):
        n = len(pairs)
        ax, ay = sum(p[0][0] for p in pairs) / n, sum(p[0][1] for p in pairs) / n
        bx, by = sum(p[1][0] for p in pairs) / n, sum(p[1][1] for p in pairs) / n
        dot = sum((q[0] - bx) * (p[0] - ax) + (q[1] - by) * (p[1] - ay) for p, q in pairs)
        cross = sum((q[0] - bx) * (p[1] - ay) - (q[1] - by) * (p[0] - ax) for p, q in pairs)
        yaw = math.atan2(cross, dot)
        c, s = math.cos(yaw), math.sin(yaw)
        pose = lambda q: (c * (q[0] - bx) - s * (q[1] - by) + ax, s * (q[0] - bx) + c * (q[1] - by) + ay)
        errors = sorted(math.dist(p, pose(q)) for p, q in pairs)
        limit = max(0.5, 3 * errors[len(errors) // 2])
        kept = [(p, q) for p, q in pairs if math.dist(p, pose(q)) <= limit]
        if len(kept) == n or len(kept) < 3:
            break
        pairs = kept
    return pose, [q for _, q in pairs]


def align(a, b, folder):
    write(f"{folder}/first.csv", a, 2014)
    write(f"{folder}/second.csv", b, 2016)
    r = subprocess.run([os.environ["STEMWISE"], "align", f"{folder}/first.csv", f"{folder}/second.csv", "--reference", "first", "-o",
                        f"{folder}/p.gpkg", "--json", f"{folder}/r.json", "--quiet"], capture_output=True, text=True)
    if r.returncode not in (0, 1):
        print("  exit", r.returncode, r.stderr[-200:])
    if r.returncode:
        return None
    second = [v for v in json.load(open(f"{folder}/r.json"))["inventories"] if v["name"] == "second"][0]
    return second["T_reference_from_inventory"]


def try_plot(name, a, b, rng):
    moved = move(b, rng.uniform(-math.pi, math.pi), rng.uniform(-300, 300), rng.uniform(-300, 300))
    truth, common = fit_by_ids(a, moved)
    with tempfile.TemporaryDirectory() as folder:
        t = align(a, moved, folder)
    if t is None:
        return "refused"
    off = [math.dist(truth(q), (t[0][0] * q[0] + t[0][1] * q[1] + t[0][3], t[1][0] * q[0] + t[1][1] * q[1] + t[1][3])) for q in common]
    worst = max(off)
    if worst > 1.0:
        print(f"  {name}: wrong by {worst:.2f} m, {len(common)} common")
    return "right" if worst <= 1.0 else "wrong"


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


def huron(data):
    def read(path):
        plots = {}
        for r in rows(path):
            plots.setdefault(r["plot"], []).append((r["stem_id"], float(r["x_m"]), float(r["y_m"]), number(r["dbh_cm"])))
        return plots
    a, b = read(f"{data}/huron/hmc_tidy_2014.csv"), read(f"{data}/huron/hmc_remap2016_tidy.csv")
    return [(f"huron {p}", a[p], b[p]) for p in sorted(a) if p in b]


def dronelidar(data):
    plots = {}
    for r in rows(f"{data}/dronelidar_t3/t3_three_stem_maps_tidy.csv"):
        for kind in ("field", "lidar_a", "lidar_b"):
            x, y = number(r[kind + "_e"]), number(r[kind + "_n"])
            if x is not None and y is not None:
                plots.setdefault(r["plot"], {}).setdefault(kind, []).append((r["stem_id"], x, y, number(r["dbh_cm"])))
    out = []
    for p in sorted(plots, key=int):
        for kind in ("lidar_a", "lidar_b"):
            if min(len(plots[p].get("field", [])), len(plots[p].get(kind, []))) >= 15:
                out.append((f"dronelidar {p} {kind}", plots[p]["field"], plots[p][kind]))
    return out


def prf025(data):
    with tempfile.TemporaryDirectory() as t:
        r = subprocess.run([os.environ["STEMWISE"], "align", f"{data}/prf025/PRF025_Field_original.csv", f"{data}/prf025/PRF025_Lidar_original.csv",
                            "-o", f"{t}/p.gpkg", "--quiet"], capture_output=True, text=True)
        if r.returncode:
            print("prf025: refused", r.stderr[-300:])
            return False
        subprocess.run([os.environ["STEMWISE"], "export", f"{t}/p.gpkg", "--layer", "matches", "-o", f"{t}/m.csv", "--quiet"], check=True)
        got = {frozenset((m["source_id_a"] + m["inventory_a"][:8], m["source_id_b"] + m["inventory_b"][:8])) for m in rows(f"{t}/m.csv") if m["state"] != "rejected"}
        dbh = [(float(m["dbh_a_cm"]), float(m["dbh_b_cm"])) for m in rows(f"{t}/m.csv") if m["dbh_a_cm"] and m["dbh_b_cm"]]
    want = {frozenset((m["field_id"] + "PRF025_F", m["lidar_id"] + "PRF025_L")) for m in rows(f"{data}/prf025/prf025_derived_matches.csv")}
    off = sorted(abs(a - b) for a, b in dbh)
    print(f"prf025: {len(got & want)} of {len(want)} derived pairs, {len(got)} matches, median DBH difference {off[len(off) // 2]:.1f} cm")
    return len(got & want) >= 45 and off[len(off) // 2] < 3


def main():
    p = argparse.ArgumentParser()
    p.add_argument("data")
    p.add_argument("--seeds", type=int, default=1)
    a = p.parse_args()
    ok = prf025(a.data)
    for plots in (huron(a.data), dronelidar(a.data)):
        said = {"right": 0, "refused": 0, "wrong": 0}
        for seed in range(a.seeds):
            for name, first, second in plots:
                verdict = try_plot(name, first, second, random.Random(f"{name} {seed}"))
                said[verdict] += 1
                if verdict == "refused":
                    print(f"  {name}: refused ({len(first)} and {len(second)} stems)")
        total = sum(said.values())
        print(f"{plots[0][0].split()[0]}: {total} plots, {said['right']} right, {said['refused']} refused, {said['wrong']} wrong")
        ok = ok and said["wrong"] == 0 and said["right"] >= 0.8 * total
    sys.exit(not ok)


main()
