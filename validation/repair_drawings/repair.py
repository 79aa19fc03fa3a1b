"""Repairs drawings with the tool and checks what it promises; prints the page."""
import json
import os
import subprocess
import sys
import tempfile
import time

ENDINGS = (".svg", ".dxf", ".lines", ".geojson", ".wkt", ".csv", ".json")
LARGEST = 20_000_000  # bytes
KINDS = ["merge", "weld", "snap", "grow", "bridge", "joint", "trim", "sliver", "door", "simplify", "dissolve"]
SECONDS = 300


class Tool:
    def __init__(self, program):
        self.program = os.path.abspath(program)

    def __call__(self, *arguments):
        """Exit code and the --json summary."""
        run = subprocess.run([self.program, *arguments, "--json", "--lenient"], capture_output=True, text=True, timeout=SECONDS)
        try:
            return run.returncode, json.loads(run.stdout)
        except ValueError:
            return run.returncode, {"error": run.stderr[-200:]}


def files_of(arguments):
    for argument in arguments:
        if os.path.isfile(argument):
            yield os.path.dirname(argument), argument
        for folder, _, names in sorted(os.walk(argument)):
            for name in sorted(names):
                path = os.path.join(folder, name)
                if name.endswith(ENDINGS) and os.path.getsize(path) <= LARGEST:
                    yield argument, path


def options_of(log):
    """The tolerances of a log as options."""
    options = []
    for name, value in json.load(open(log))["tolerances"].items():
        if name in ("weld", "grow", "trim", "sliver"):
            options += ["--" + name, value if isinstance(value, str) else repr(value)]
    return options


def repaired(tool, path, options, folder):
    """One row: what was done, and which promises were broken."""
    out, log, back = (os.path.join(folder, name) for name in ("out.lines", "log.json", "back.lines"))
    start = time.monotonic()
    code, done = tool("repair", path, "-o", out, "--log", log, *options)
    row = {"seconds": time.monotonic() - start, "done": done, "broken": []}
    if code not in (0, 1):
        row["broken"].append(f"exit code {code}: {done.get('error', '')}")
        return row
    if os.path.getsize(out) == 0:
        return row
    code, again = tool("repair", out, *options_of(log))
    row["again"] = again.get("edits", -1)
    if row["again"] != 0 and done["refused"] == 0:
        row["broken"].append(f"a second run has {row['again']} edits")
    code, undone = tool("repair", out, "--undo", log, "-o", back)
    if code != 0:
        row["broken"].append(f"undo: {undone.get('error', code)}")
    else:
        signatures = [tool("arrange", file)[1].get("signature") for file in (path, back)]
        if signatures[0] != signatures[1]:
            row["broken"].append("undo gives another drawing")
    return row


def faces(tool, path):
    return tool("arrange", path)[1].get("faces", 1) - 1


def main():
    tool = Tool(sys.argv[1])
    rows, broken, unread = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        for root, path in files_of(sys.argv[2:]):
            name = os.path.relpath(path, root)
            code, drawing = tool("info", path)
            if code != 0 or not drawing.get("segments"):
                unread += 1
                continue
            size = max(h - l for l, h in zip(drawing["low"], drawing["high"]))
            for label, options in [("auto", []), ("1/1000", ["--tolerance", f"{size / 1000:.3g}"]), ("1/200", ["--tolerance", f"{size / 200:.3g}"])]:
                row = repaired(tool, path, options, folder)
                row.update(name=name, label=label, segments=drawing["segments"], before=drawing["faces"] - 1)
                row["after"] = faces(tool, os.path.join(folder, "out.lines")) if not row["broken"] else -1
                rows.append(row)
                broken += [f"{name}, {label}: {text}" for text in row["broken"]]
    print_page(rows, broken, unread)
    sys.exit(1 if broken else 0)


def print_page(rows, broken, unread):
    drawings = len({row["name"] for row in rows})
    print("# Repair of real drawings\n")
    print(f"`validation/repair_drawings/run DRAWINGS...` repairs {drawings} drawings ({unread} files have no segments or are of")
    print("formats that are not read) at three tolerances each: automatic, 1/1000 and 1/200 of the drawing's longer side for all")
    print("operations, which is far too much for most. A promise is broken where the tool fails, a second run at the same tolerances")
    print("has edits though the first refused nothing, or `--undo` does not give the input's signature back.\n")
    print(f"**{len(rows)} repairs, {len(broken)} broken promises.**\n")
    for text in broken:
        print(f"- {text}")
    print("\n| tolerance | repairs | with edits | refused something | given up as a whole | edits |\n| --- | --- | --- | --- | --- | --- |")
    for label in ("auto", "1/1000", "1/200"):
        some = [row["done"] for row in rows if row["label"] == label]
        counts = ", ".join(f"{kind} {sum(d.get(kind, 0) for d in some):,}" for kind in KINDS if any(d.get(kind, 0) for d in some))
        edited = sum(1 for d in some if d.get("edits", 0) > 0)
        refused = sum(1 for d in some if d.get("refused", 0) > 0)
        given_up = sum(1 for d in some if d.get("given_up", 0) > 0)
        print(f"| {label} | {len(some)} | {edited} | {refused} | {given_up} | {counts} |")
    print("\nEach repair that does more than merge; bounded faces before and after, seconds of the whole command.\n")
    print("| drawing | segments | tolerance | edits | refused | faces | s |\n| --- | --- | --- | --- | --- | --- | --- |")
    for row in rows:
        done = row["done"]
        if not any(done.get(kind, 0) for kind in KINDS if kind != "merge") and not done.get("refused"):
            continue
        edits = ", ".join(f"{kind} {done[kind]}" for kind in KINDS if done.get(kind, 0))
        print(f"| {row['name']} | {row['segments']:,} | {row['label']} | {edits} | {done.get('refused', 0)} | {row['before']} -> {row['after']} | {row['seconds']:.2f} |")


main()
