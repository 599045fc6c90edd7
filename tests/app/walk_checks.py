"""What the walk checks in project files, from outside of the program: a GeoPackage is an SQLite file.

  walk_checks.py same A.gpkg B.gpkg                           both hold the same
  walk_checks.py messy PROJECT.gpkg FIA.csv TLS.csv PARACOU.csv   every wanted row of the messy files became its stem
"""
import csv
import math
import sqlite3
import sys


def opened(path):
    return sqlite3.connect(f"file:{path}?mode=ro", uri=True)


def tables(path):
    """All rows of all tables, but for the times at which the file was written (its own, and that of its styles)."""
    file = opened(path)
    file.text_factory = bytes
    names = file.execute("select name from sqlite_master where type = 'table' and name not like 'rtree_%' and name not like 'sqlite_%'")
    held = {}
    for name in sorted(n.decode() for (n,) in names):
        columns = [row[1].decode() for row in file.execute(f'pragma table_info("{name}")')]
        kept = ", ".join(f'"{column}"' for column in columns if column not in ("last_change", "update_time"))
        held[name] = file.execute(f'select {kept} from "{name}" order by rowid').fetchall()
    return held


def same(path_a, path_b):
    a, b = tables(path_a), tables(path_b)
    differing = sorted(name for name in a.keys() | b.keys() if a.get(name) != b.get(name))
    assert not differing, "not the same in " + ", ".join(differing)
    assert a["stemwise_stems"] and a["stemwise_edit_log"], "nothing to compare"
    return f"{len(a)} tables with {sum(map(len, a.values()))} rows are the same"


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def messy(project, fia, tls, paracou):
    """Feet, inches and circumferences are metres and diameters now."""
    wanted = {}
    for row in rows(fia):
        if row["SUBP"] == "1":
            away_m, azimuth = 0.3048 * float(row["DIST"]), math.radians(float(row["AZIMUTH"]))
            wanted["fia", row["TREE"]] = away_m * math.sin(azimuth), away_m * math.cos(azimuth), 0.0254 * float(row["DIA"])
    for row in rows(tls):
        wanted["fortls", row["tree"]] = float(row["x"]), float(row["y"]), float(row["dbh"]) / 100
    for row in rows(paracou):
        wanted["paracou", row["idTree"]] = float(row["Xfield"]), float(row["Yfield"]), float(row["Circ"]) / math.pi / 100
    query = "select i.name, s.source_id, s.x_m, s.y_m, s.dbh_m from stemwise_stems s join stemwise_inventories i using (inventory_id)"
    found = {(name.split("_")[0], source_id): numbers for name, source_id, *numbers in opened(project).execute(query)}
    assert wanted.keys() == found.keys(), f"other stems than wanted: {wanted.keys() ^ found.keys()}"
    for key in wanted:
        assert math.dist(wanted[key], found[key]) < 1e-6, f"{key}: {found[key]}, wanted {wanted[key]}"
    return f"{len(found)} stems stand where their rows say and have their diameters"


print("      " + {"same": same, "messy": messy}[sys.argv[1]](*sys.argv[2:]))
