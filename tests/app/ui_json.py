"""What scripts ask of the file that `stemwise gui --ui-json` keeps: every widget of the last frame by its path.

  ui_json.py FILE get PATH FIELD                    value, enabled (yes or no), x and y (of its middle); nothing where it is not
  ui_json.py FILE paths PREFIX                      the visible ones that begin so, from the top to the bottom
  ui_json.py FILE wait SECONDS [PATH OP TEXT]...    until all hold at once; OP is = or != (text), >= (number),
                                                    or "is" with TEXT there, gone or enabled
"""
import json
import sys
import time


def read(path):
    try:
        with open(path) as file:
            return json.load(file)
    except (OSError, ValueError):  # not written yet
        return {}


def get(widgets, path, field):
    entry = widgets.get(path)
    if entry is None:
        return ""
    if field == "x":
        return str(int(entry["x"] + entry["width"] / 2))
    if field == "y":
        return str(int(entry["y"] + entry["height"] / 2))
    if field == "enabled":
        return "yes" if entry["enabled"] else "no"
    return entry["value"]


def holds(widgets, path, operator, text):
    value = get(widgets, path, "value")
    if operator == "is":
        entry = widgets.get(path)
        there = entry is not None and entry["visible"]
        return {"there": there, "gone": entry is None, "enabled": there and entry["enabled"]}[text]
    if operator == ">=":
        return value != "" and int(value) >= int(text)
    return (value == text) == (operator == "=")


def wait(file, seconds, conditions):
    """The conditions that did not come to hold; none when all do."""
    end = time.monotonic() + seconds
    while True:
        widgets = read(file)
        open_ones = [c for c in conditions if not holds(widgets, *c)]
        if not open_ones or time.monotonic() > end:
            return [f"{path} is \"{get(widgets, path, 'value')}\", wanted {operator} {text}" for path, operator, text in open_ones]
        time.sleep(0.02)


def main(file, verb, *words):
    if verb == "get":
        print(get(read(file), *words))
    elif verb == "paths":
        found = [(entry["y"], path) for path, entry in read(file).items() if path.startswith(words[0]) and entry["visible"]]
        print("\n".join(path for _, path in sorted(found)))
    elif verb == "wait":
        missed = wait(file, float(words[0]), [words[i : i + 3] for i in range(1, len(words), 3)])
        print("; ".join(missed))
        return 1 if missed else 0
    return 0


sys.exit(main(*sys.argv[1:]))
