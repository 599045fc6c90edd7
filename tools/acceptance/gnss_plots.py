"""dronelidar_t3: 27 plots placed by their field GNSS, checked against the LiDAR survey in the same CRS, through the command line.

usage: STEMWISE=build/release/bin/stemwise python3 tools/acceptance/gnss_plots.py ../shared/data [--operator a|b]
Per plot: the field crew's list (positions from one GNSS fix of the plot's centre, compass and tape) and the LiDAR list are aligned
with no first guess; where a plot is too small to prove itself, again with the CRS as the prior (both lists are in EPSG:32610, so the
pose is near the identity: 10 m, 20 degrees). The project is georeferenced by the LiDAR's CRS and by the field's GNSS; how far the
two put the plot's middle apart is the error of the plot's GNSS centre. A centre is called wrong beyond 2.5 m: five times the
0.5 m that plot GNSS has as a rule. Bound: all 27 plots placed, plots 9 and 13 found, and no other.
"""
import argparse, csv, json, math, os, subprocess, sys, tempfile

EPSG = "EPSG:32610"
WRONG_BEYOND_M = 2.5


def stemwise(*arguments):
    return subprocess.run([os.environ["STEMWISE"], *arguments, "--quiet"], capture_output=True, text=True)


def read(path, operator):
    plots = {}
    for r in csv.DictReader(open(path, newline="", encoding="utf-8-sig")):
        field, lidar = (r["field_e"], r["field_n"]), (r[f"lidar_{operator}_e"], r[f"lidar_{operator}_n"])
        plot = plots.setdefault(int(r["plot"]), {"field": [], "lidar": []})
        for name, (x, y) in (("field", field), ("lidar", lidar)):
            if x and y and x != "NA":
                plot[name].append((r["stem_id"], float(x), float(y), r["dbh_cm"]))
    return plots


def write(path, stems):
    with open(path, "w", newline="") as f:
        w = csv.writer(f)
        w.writerow(["id", "x_m", "y_m", "dbh_cm"])
        w.writerows([i, f"{x:.3f}", f"{y:.3f}", d] for i, x, y, d in stems)


def align(folder, *extra):
    r = stemwise("align", f"{folder}/lidar.csv", f"{folder}/field.csv", "--reference", "lidar", "-o", f"{folder}/p.gpkg", "--json", f"{folder}/r.json", *extra)
    if r.returncode not in (0, 1):
        sys.exit(f"align: exit {r.returncode}: {r.stderr}")
    return r.returncode == 0


def middle_of_trees(folder):
    """lon, lat of the project's trees by the georeference it has."""
    r = stemwise("export", f"{folder}/p.gpkg", "-o", f"{folder}/t.csv")
    if r.returncode:
        sys.exit(f"export: {r.stderr}")
    rows = list(csv.DictReader(open(f"{folder}/t.csv")))
    return [(float(t["x"]), float(t["y"])) for t in rows]


def place(folder, *by):
    r = stemwise("georeference", f"{folder}/p.gpkg", *by)
    if r.returncode:
        sys.exit(f"georeference {by}: {r.stderr}")
    return middle_of_trees(folder)


def main():
    p = argparse.ArgumentParser()
    p.add_argument("data")
    p.add_argument("--operator", default="a", choices=["a", "b"])
    a = p.parse_args()
    plots = read(f"{a.data}/dronelidar_t3/t3_three_stem_maps_tidy.csv", a.operator)
    wrong, refused, by_prior = [], [], 0
    for number in sorted(plots):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("field", "lidar"):
                write(f"{folder}/{name}.csv", plots[number][name])
            how = "by its stems"
            if not align(folder):
                how = "CRS as prior"
                by_prior += 1
                if not align(folder, "--crs", EPSG, "--accept-probable"):
                    refused.append(number)
                    print(f"plot {number:2}: refused, {len(plots[number]['field'])} stems")
                    continue
            by_lidar = place(folder, "--crs", EPSG)
            by_field = place(folder, "--crs", EPSG, "--inventory", "field")
        off = [math.dist(f, l) for f, l in zip(by_field, by_lidar)]
        mean = math.hypot(sum(f[0] - l[0] for f, l in zip(by_field, by_lidar)) / len(off), sum(f[1] - l[1] for f, l in zip(by_field, by_lidar)) / len(off))
        if mean > WRONG_BEYOND_M:
            wrong.append(number)
        print(f"plot {number:2}: {len(plots[number]['field']):2} stems, {how}, GNSS centre off by {mean:.2f} m{'  WRONG' if mean > WRONG_BEYOND_M else ''}")
    print(f"{len(plots)} plots, {by_prior} with the CRS as prior, {len(refused)} refused, wrong centres: {wrong}")
    sys.exit(wrong != [9, 13] or bool(refused) or len(plots) != 27)


main()
