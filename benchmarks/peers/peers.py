#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""MeshQuality beside today's best, in one run: a table a task, which --write puts into docs/measurements/peers.md.

    /usr/bin/python3 benchmarks/peers --task surface --judge PROGRAM [--most 4] [--runs 3] [--write]

Tasks: surface, public, boolean, offset, wrap, simplify, improve, fill, curving. The newest rivals are installed by pip into
a scratch environment, which is kept in the folder --cache; CGAL is compiled where Debian's headers are. What cannot be had
is named with the reason.

Parts are those of $MESHQUALITY_DATA (default: ../shared/data beside the repository) and a few that FreeCAD makes.
Everybody has the same ones in turn, each run in a process of its own with limits of CPU seconds, of --clock times those on
the clock, and of memory: what crashes or is not done is a row's result. CPU and wall seconds are of the call alone, with
conversions and without files, medians of --runs; what takes more than five seconds runs once. Everybody is pinned to the
first of --cores with one thread, and where there are several once more to all of them, with a thread each. What somebody
cannot do, or nobody measured, is "-".

The task public counts what comes of the files of the folder --parts, which are named by their digests
(benchmarks/corpus_runs/parts_sources.py brings them); a run goes on where the last one stopped, unless --afresh.

--program NAME=PATH lets another program take part in surfaces: PATH SHAPE.step MESH.off DISTANCE writes the mesh and prints
{"seconds": of the processor, "wall": ...} as JSON; without arguments, its version.

--judge is a program that reads MESH SHAPE --json and shares no code with anybody; without it OpenCASCADE tells distances
from a few points, and crossings are not looked for. Settings that were found are kept in --cache as well; --afresh looks
for them again.
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
import peer_page
from child import Limits, crash_cause, outcome_in_child

TASKS = ("surface", "public", "boolean", "offset", "wrap", "simplify", "improve", "fill", "curving")
PAGE = inside_freecad.ROOT / "docs" / "measurements" / "peers.md"
HERE = Path(__file__).resolve().parent
SLOW = 5.0  # seconds: what takes longer is not run again
TOO_SHORT = 0.005  # seconds, to tell their spread


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--task", choices=TASKS, action="append", required=True, help="may be given more than once")
    result.add_argument("-n", "--runs", type=int, default=3, help="of every mesher, in turn")
    result.add_argument("--most", type=int, default=0, help="parts a task; 0: all")
    result.add_argument("--only", action="append", metavar="MESHER", help="these rivals only")
    result.add_argument("--cores", default="0", help="numbers of cores, as 0,1")
    result.add_argument("--program", action="append", default=[], metavar="NAME=PATH", help="one more rival for surfaces")
    result.add_argument("--parts", help="folder of the task public")
    result.add_argument("--share", default="measure", choices=("measure", "develop", "both"), help="which of --parts")
    result.add_argument("--limit", type=float, default=120.0, help="CPU seconds of a run")
    result.add_argument("--clock", type=float, default=10.0, help="times --limit on the clock, after which a run hangs")
    result.add_argument("--gibibytes", type=float, default=12.0, help="memory of a run")
    result.add_argument("--judge", help="program that judges a mesh: MESH SHAPE --json")
    result.add_argument("--curved-judge", help="program that judges a curved mesh: MESH.msh SHAPE --json")
    result.add_argument("--data", default=str(inside_freecad.data_folder()), help="folder with cad/ and boolean/")
    result.add_argument("--cache", default=str(Path.home() / ".cache" / "meshquality" / "peers"), help="kept from run to run")
    result.add_argument("--python", default="/usr/bin/python3", help="that makes the scratch environment")
    result.add_argument("--afresh", action="store_true", help="look for settings again")
    result.add_argument("--write", action="store_true", help="put the table into the page")
    result.add_argument("--page", default=str(PAGE), help="that --write changes")
    result.add_argument("--front", default=str(inside_freecad.ROOT / "README.md"), help="page that has figures of the first surface")
    return result


class Runs:
    """Runs of all meshers of a task, each in a process of its own."""

    def __init__(self, name, arguments, environment, folder):
        import own_runs
        import peer_tasks

        self.name, self.arguments, self.environment, self.folder = name, arguments, environment, Path(folder)
        self.task, self.own = peer_tasks.TASKS[name], own_runs
        self.limits = Limits(arguments.limit, arguments.gibibytes, arguments.clock)
        self.outside = dict(text.split("=", 1) for text in arguments.program) if self.task.outside else {}
        self.meshers = (*self.task.meshers, *self.outside)

    def variants(self):
        """The keys of the results that one row has: operations, or one."""
        import peer_tasks

        return peer_tasks.OPERATIONS if self.name == "boolean" else ("",)

    def out(self, mesher, variant=""):
        return self.folder / f"{mesher}{variant}{self.task.suffix}".replace(" ", "_")

    def job(self, case, mesher, setting, variant=""):
        return {"input": None, **case, "task": self.name, "mesher": mesher, "setting": setting, "operation": variant,
                "out": str(self.out(mesher, variant))}

    def run(self, job, cores=1):
        """{"seconds", "wall"}, or {"failed"}; with a thread on each of the first cores."""
        os.sched_setaffinity(0, self.arguments.cores[:cores])
        os.environ["MESHQUALITY_THREADS"] = str(cores)
        Path(job["out"]).unlink(missing_ok=True)
        if job["mesher"] in self.own.RUNS[self.name]:
            said, cause = outcome_in_child(lambda: self.own.run(job), self.arguments.limit, self.arguments.gibibytes, self.arguments.clock)
            return said or {"failed": cause}
        environment = inside_freecad.system_environment() | {"OMP_NUM_THREADS": str(cores)}
        status, output = self.limits.run(self._command(job), environment)
        return outcome(status, output, Path(job["out"]).exists())

    def _command(self, job):
        if job["mesher"] in self.outside:
            return [self.outside[job["mesher"]], job["step"], job["out"], repr(job["setting"])]
        if job["mesher"] == "CGAL":
            stem, words = self.task.cgal
            return [str(self.environment.programs[stem]), *map(str, words(job))]
        return [str(self.environment.python), str(HERE / "peer_runs.py"), json.dumps(job)]

    def measured(self, measure, case, out):
        """The figures of a result; None where measuring fails."""
        return outcome_in_child(lambda: measure(case, out, self.arguments.judge), 600.0)[0]

    def setting(self, case, mesher, known):
        """What a mesher is asked for; None where nothing of its grid keeps the distance."""
        from setting_search import coarsest

        tried = (self.task.settings or {}).get("BRepMesh" if mesher in self.outside else mesher)
        if not tried:
            return case["target"]
        factor = case["target"] if mesher in (*self.task.relative, *self.outside) else 1.0

        def distance(setting):
            if "failed" in self.run(self.job(case, mesher, setting)):
                return None
            found = self.measured(self.task.searched, case, self.out(mesher))
            return found and found["distance"]

        key = f"{self.name}, {case['name']}, {mesher}, {case['target']:.6g} mm, {'judged' if self.arguments.judge else 'measured'}"
        return known.of(key, lambda: coarsest([factor * step for step in tried], distance, 1.0))


def outcome(status, output, made):
    """What a run of a program comes to."""
    if status is None:
        return {"failed": "time limit"}
    lines = [line for line in output.splitlines() if line.startswith("{")]
    if status == 0 and lines:
        said = json.loads(lines[-1])
        return said if "failed" in said or made else {"failed": "no result"}
    return {"failed": f"crash: {crash_cause(status, output)}" if status < 0 else f"error: {(output.strip().splitlines() or ['none said'])[-1]}"}


def short(text):
    """A message for a cell of a table."""
    from peer_environment import without_places

    return without_places(text.replace("|", "/"))[:80]


def rows_of(runs, case, meshers, known):
    """One row a mesher."""
    asked = {mesher: runs.setting(case, mesher, known) for mesher in meshers}
    said = {(mesher, variant): [] for mesher in meshers for variant in runs.variants()}
    everywhere = {key: [] for key in said}  # with a thread on each core, where there are several
    for _ in range(runs.arguments.runs):
        for (mesher, variant), before in said.items():
            lost = case["target"] is not None and asked[mesher] is None
            if lost or any("failed" in one or one["seconds"] > SLOW for one in before):
                continue
            job = runs.job(case, mesher, asked[mesher], variant)
            if len(runs.arguments.cores) > 1:
                everywhere[mesher, variant].append(runs.run(job, len(runs.arguments.cores)))
            before.append(runs.run(job))
    made = {mesher: {variant: figures(runs, case, mesher, variant, said[mesher, variant]) for variant in runs.variants()}
            for mesher in meshers}
    exact = {key: row["volume"] for key, row in made.get("CGAL", {}).items() if row and "volume" in row}
    reference = exact or case.get("volumes") or {}
    return [row_of(runs, case, mesher, made[mesher], said, reference) | times_everywhere(runs, mesher, everywhere) for mesher in meshers]


def times_everywhere(runs, mesher, everywhere):
    """The medians of runs with a thread on each core; nothing where some failed, or there is one core."""
    turns = list(zip(*(everywhere[mesher, variant] for variant in runs.variants())))
    if not turns or any("failed" in one for turn in turns for one in turn):
        return {}
    return {f"{key}_all": statistics.median(sum(one[key] for one in turn) for turn in turns) for key in ("seconds", "wall")}


def figures(runs, case, mesher, variant, said):
    """What is measured of a result; None where there is none."""
    if not said or any("failed" in one for one in said):
        return None
    return runs.measured(runs.task.figures, case, runs.out(mesher, variant))


def row_of(runs, case, mesher, made, said, reference):
    import peer_tasks

    row = {"case": case["name"], "mesher": mesher}
    own = {variant: said[mesher, variant] for variant in runs.variants()}
    failures = [f"{variant}: {one['failed']}".lstrip(": ") for variant, several in own.items() for one in several if "failed" in one]
    failures += ["no setting keeps the distance"] if not any(own.values()) else []
    done = [several for variant, several in own.items() if made[variant]]
    failures += ["not measured"] if len(done) < len(own) and not failures else []
    if failures:
        row["failed"] = short("; ".join(failures))
    if runs.name == "boolean":
        row |= peer_tasks.counted(case, made, reference)
    elif done:
        row |= made[""]
    if done and len(done) == len(own):
        seconds, wall = ([sum(one[key] for one in turn) for turn in zip(*done)] for key in ("seconds", "wall"))
        row |= {"runs": len(seconds), "seconds": statistics.median(seconds), "wall": statistics.median(wall),
                "spread": max(seconds) / min(seconds) - 1.0 if len(seconds) > 1 and min(seconds) > TOO_SHORT else None}
        count = row.get("tetrahedra", row.get("triangles"))
        row["rate"] = count / row["seconds"] if row["seconds"] > TOO_SHORT else None
    return row


def command_of(arguments, name):
    """The command that repeats a table."""
    words = [f"--task {name}"]
    if name == "public":
        words += ["--parts PARTS", f"--share {arguments.share}"]
    else:
        words += [f"--runs {arguments.runs}", f"--cores {','.join(map(str, arguments.cores))}"]
    words += [f"--limit {arguments.limit:g}"] + [f"--only '{mesher}'" for mesher in arguments.only or ()]
    words += [f"--most {arguments.most}"] * bool(arguments.most) + [f"--program {text.partition('=')[0]}=PROGRAM" for text in arguments.program]
    judges = " --judge PROGRAM" * bool(arguments.judge) + " --curved-judge PROGRAM" * (name == "curving" and bool(arguments.curved_judge))
    return f"benchmarks/peers/peers.py {' '.join(words)}{judges} --write"


def version_of(program):
    """What a program says without arguments."""
    done = subprocess.run([program], capture_output=True, text=True, timeout=60.0, check=False)
    return short((done.stdout.strip().splitlines() or ["of no said version"])[0])


def table_of(name, arguments, environment):
    """The rows of a task; its table is printed, and written where that is asked for."""
    import peer_environment

    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(name, arguments, environment, folder)
        chosen = [m for m in runs.meshers if not arguments.only or m in (peer_page.OURS, *arguments.only)]
        packages = {m: peer_environment.package_of(m) for m in chosen}
        meshers = [m for m in chosen if packages[m] not in environment.missing]
        rows = (public_rows if name == "public" else case_rows)(runs, meshers, folder)
        versions = {packages[m]: environment.versions[packages[m]] for m in meshers if packages[m]}
        missing = {m: environment.missing[packages[m]] for m in chosen if m not in meshers}
    versions |= {m: version_of(program) for m, program in runs.outside.items()}
    versions["OpenCASCADE"] = inside_freecad.machine()["opencascade"]
    text = peer_page.section(runs.task, rows, versions, missing, command_of(arguments, name), bool(arguments.judge))
    print(text, flush=True)
    if arguments.write:
        peer_page.put(arguments.page, name, text)
        if name == "surface" and rows:
            peer_page.put(arguments.front, "figures", peer_page.figures(runs.task.columns, rows))
    return rows


def case_rows(runs, meshers, folder):
    """Of each case one a mesher, printed as they come."""
    from peer_tasks import Settings

    known = Settings(Path(runs.arguments.cache) / f"settings_{runs.name}.json", runs.arguments.afresh)
    rows = []
    for case in runs.task.cases(runs.arguments, Path(folder)):
        rows += rows_of(runs, case, meshers, known)
        print("\n".join(peer_page.table(runs.task.columns, rows[-len(meshers):])[0 if len(rows) == len(meshers) else 2:]), flush=True)
    return rows


def public_rows(runs, meshers, _folder):
    import peer_sets

    if not runs.arguments.parts:
        raise SystemExit("the task public needs --parts: a folder of files that are named by their digests")
    kept = Path(runs.arguments.cache) / f"public_{runs.arguments.share}.jsonl"
    return peer_sets.rows(peer_sets.results(runs, meshers, kept), meshers)


def work(arguments):
    import peer_environment
    import peer_tasks

    arguments.cores = [int(core) for core in arguments.cores.split(",")]
    environment = peer_environment.Environment(arguments.cache, arguments.python)
    for task in map(peer_tasks.TASKS.get, arguments.task):
        if task.cgal:
            environment.compile(next(HERE.parent.glob(f"*/{task.cgal[0]}.cpp")), "-lgmp", "-lmpfr")
    tables = {name: table_of(name, arguments, environment) for name in arguments.task}
    return {"versions": environment.versions, "missing": environment.missing, "tables": tables}


if __name__ == "__main__" or inside_freecad.VARIABLE in os.environ:
    inside_freecad.start(__file__, parser(), work)
