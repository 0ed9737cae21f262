# SPDX-License-Identifier: LGPL-2.1-or-later
"""bin/meshquality among odd locales, clocks, limits, signals, streams, environments and outputs.

Each attack starts the command as others do and looks at its status, what it said, and what it left behind.
"""

import contextlib
import os
import random
import resource
import shutil
import signal
import subprocess
import time

from attack import Attack, check
from place import ENDLESS, LIMIT, MIB, STATUSES, Place, good_mesh, stl_of_cube, wait_until_it_takes_signals


def attack_of(act):
    def attack():
        with Place() as place:
            act(place)

    return attack


# ---- environments and locales ----

def in_environment(changes, statuses=STATUSES, arguments=("triangulate", "box.brep", "-o", "out.stl")):
    def act(place):
        resolved = {name: value and value.replace("FOLDER", str(place.folder)) for name, value in changes.items()}
        status, _, err = place.run(*arguments, environment=resolved)
        check(status in statuses, f"status {status}: {err[-400:]}")
        if status == 0:
            good_mesh(place.work / "out.stl", 16)

    return act


ENVIRONMENTS = {
    **{f"LC_ALL={name}": ({"LC_ALL": name}, (0,))
       for name in ("C", "POSIX", "tr_TR.UTF-8", "de_DE.UTF-8", "de_DE@euro", "ja_JP.SJIS",
                                                                "no such", "x" * 3000, "../../etc", "C.utf8")},
    "LANGUAGE=de": ({"LANGUAGE": "de", "LANG": "de_DE.UTF-8"}, (0,)),
    "LC_NUMERIC alone": ({"LC_NUMERIC": "de_DE.UTF-8"}, (0,)),
    "HOME unset": ({"HOME": None}, (0, 1)), "HOME of none": ({"HOME": "/nonexistent"}, (0, 1)),
    "HOME is a file": ({"HOME": "/dev/null"}, (0, 1)),
    "HOME empty": ({"HOME": ""}, (0, 1)),
    "FREECAD_USER_HOME of none": ({"FREECAD_USER_HOME": "/nonexistent/x"}, (0, 1)),
    "FREECAD_USER_HOME relative": ({"FREECAD_USER_HOME": "../x"}, (0, 1)),
    "FREECAD_USER_DATA of none": ({"FREECAD_USER_DATA": "/nonexistent"}, (0, 1)),
    "XDG folders of none": ({"XDG_CONFIG_HOME": "/nonexistent", "XDG_DATA_HOME": "/nonexistent",
                             "XDG_CACHE_HOME": "/proc"}, (0, 1)),
    "PYTHONPATH of none": ({"PYTHONPATH": "/nonexistent:/dev/null:"}, (0,)),
    "PYTHONPATH huge": ({"PYTHONPATH": ":".join(f"/p{i}" for i in range(2000))}, (0,)),
    "PYTHONSTARTUP": ({"PYTHONSTARTUP": "/nonexistent"}, (0,)),
    "PYTHONOPTIMIZE": ({"PYTHONOPTIMIZE": "2"}, (0,)), "PYTHONWARNINGS=error": ({"PYTHONWARNINGS": "error"}, (0, 1)),
    "PYTHONUTF8=0": ({"PYTHONUTF8": "0", "LC_ALL": "C", "PYTHONCOERCECLOCALE": "0"}, (0,)),
    "PYTHONIOENCODING=ascii": ({"PYTHONIOENCODING": "ascii"}, (0,)),
    "PYTHONIOENCODING=utf-16": ({"PYTHONIOENCODING": "utf-16"}, None),
    "PYTHONHASHSEED": ({"PYTHONHASHSEED": "0"}, (0,)),
    "PYTHONDONTWRITEBYTECODE": ({"PYTHONDONTWRITEBYTECODE": "1"}, (0,)),
    "PYTHONUNBUFFERED": ({"PYTHONUNBUFFERED": "1"}, (0,)), "PYTHONDEVMODE": ({"PYTHONDEVMODE": "1"}, (0,)),
    "PYTHONMALLOC=debug": ({"PYTHONMALLOC": "debug"}, (0,)),
    "TMPDIR relative": ({"TMPDIR": "."}, (0, 1)), "TMPDIR empty": ({"TMPDIR": ""}, (0,)),
    "TMPDIR with odd letters": ({"TMPDIR": "FOLDER/temporary"}, (0,)),
    "TMPDIR is a file": ({"TMPDIR": "FOLDER/work/box.brep"}, (1,)),
    "TMPDIR=/proc": ({"TMPDIR": "/proc"}, (0, 1)),
    "FreeCAD is /bin/false": ({"MESHQUALITY_FREECADCMD": "/bin/false"}, (1,)),
    "FreeCAD is /bin/true": ({"MESHQUALITY_FREECADCMD": "/bin/true"}, (1,)),
    "FreeCAD is a folder": ({"MESHQUALITY_FREECADCMD": "/tmp"}, (1,)),
    "FreeCAD is a text": ({"MESHQUALITY_FREECADCMD": "/etc/passwd"}, (1,)),
    "FreeCAD is of none": ({"MESHQUALITY_FREECADCMD": "/nonexistent"}, (1,)),
    **{f"MESHQUALITY_THREADS={text}": ({"MESHQUALITY_THREADS": text}, (0,)) for text in ("0", "-5", "x", "", "1e9",
                                                                                         "64", "99999999999999999999")},
    "OMP_NUM_THREADS=0": ({"OMP_NUM_THREADS": "0"}, (0,)),
    "OMP_NUM_THREADS=1000": ({"OMP_NUM_THREADS": "1000", "TBB_NUM_THREADS": "1000"}, (0,)),
    "MALLOC_ARENA_MAX=1": ({"MALLOC_ARENA_MAX": "1"}, (0,)), "MALLOC_PERTURB_": ({"MALLOC_PERTURB_": "165"}, (0,)),
    "MESHQUALITY_JOB of none": ({"MESHQUALITY_JOB": "/nonexistent"}, (0,)),
    "MESHQUALITY_OWNER=999": ({"MESHQUALITY_OWNER": "999"}, (0,)),
    "MESHQUALITY_SERVE=x": ({"MESHQUALITY_SERVE": "x"}, (0,)),
    "MESHQUALITY_TERMINAL=1": ({"MESHQUALITY_TERMINAL": "1"}, (0,)),
    "DISPLAY of none": ({"DISPLAY": ":99999", "WAYLAND_DISPLAY": "x"}, (0,)),
    "QT_QPA_PLATFORM=xcb": ({"QT_QPA_PLATFORM": "xcb"}, (0,)), "TZ": ({"TZ": "Mars/Olympus"}, (0,)),
    "a variable of 100 KiB": ({"HUGE": "x" * 100_000}, (0,)), "TERM=dumb": ({"TERM": "dumb", "COLUMNS": "0"}, (0,)),
    "COLUMNS=-1": ({"COLUMNS": "-1"}, (0,)),
    "CASROOT of none": ({"CASROOT": "/nonexistent", "CSF_OCCTResourcePath": "/nonexistent"}, (0, 1)),
    "SOURCE_DATE_EPOCH": ({"SOURCE_DATE_EPOCH": "-1"}, (0,)),
}

# ---- limits of the system ----

LIMITS = {
    **{f"files of {size} bytes": (resource.RLIMIT_FSIZE, size) for size in (0, 1, 100, 4096)},
    **{f"{count} open files": (resource.RLIMIT_NOFILE, count) for count in (4, 8, 12, 24, 64)},
    **{f"{size} MiB of addresses": (resource.RLIMIT_AS, size * MIB) for size in (16, 48, 100, 200, 400, 700)},
    **{f"{size} MiB of data": (resource.RLIMIT_DATA, size * MIB) for size in (4, 16, 64, 128)},
    **{f"a stack of {size} KiB": (resource.RLIMIT_STACK, size * 1024) for size in (64, 256, 1024)},
    "1 s of processor": (resource.RLIMIT_CPU, 1), "no locked memory": (resource.RLIMIT_MEMLOCK, 0),
}


def within(which, value, arguments):
    def act(place):
        # Python itself may not come to life within them: then nobody can say a sentence.
        process = place.start(*arguments, preexec_fn=lambda: resource.setrlimit(which, (value, value)))
        out, err = process.communicate(timeout=LIMIT)
        text = err.decode(errors="replace")
        ours = "meshquality:" in text
        if process.returncode == 0:
            good_mesh(place.work / "out.stl")
        place.ended(process.returncode if ours else 1, "", text if ours else "")
        if (place.work / "out.stl").exists():
            good_mesh(place.work / "out.stl")

    return act


# ---- signals ----

def signalled(number, after, arguments, again=False):
    """So many seconds after the command takes signals itself; None: at its start, when they end any program."""
    def act(place):
        process = place.start(*arguments, start_new_session=True)
        if after is not None:
            wait_until_it_takes_signals(process)
        time.sleep(after or 0.01)
        process.send_signal(number)
        if again:
            time.sleep(0.02)
            process.send_signal(number)
        try:
            _, err = process.communicate(timeout=LIMIT)
        finally:
            process.kill()
            process.wait()
        place.ended(process.returncode, "", err.decode(errors="replace"), (-number,) if after is None else (0, 1))

    return act


QUICK = ("triangulate", "box.brep", "-o", "out.stl")
LONG = ("triangulate", "ball.brep", "-o", "out.stl", *ENDLESS)
BOOLEAN = ("boolean", "cube.stl", "ball.brep", "-o", "out.stl", "--resolution", "8192")
VOLUME = ("curve", "ball.brep", "--volume", "-o", "out.msh", "--chord-height", "0.02")
SIGNALS = {"SIGINT": signal.SIGINT, "SIGTERM": signal.SIGTERM, "SIGHUP": signal.SIGHUP}


# ---- streams ----

def piped(arguments, reads):
    """stdout is a pipe of which somebody reads a few bytes and goes."""
    def act(place):
        process = place.start(*arguments)
        process.stdout.read(reads)
        process.stdout.close()
        err = process.stderr.read()
        process.wait(LIMIT)
        place.ended(process.returncode, "", err.decode(errors="replace"))

    return act


def fed(data, form, status):
    def act(place):
        command = "quality" if form == "stl" else "triangulate"
        found, _, err = place.run(command, "-", "--input-format", form, "--time-limit", "20", stdin=subprocess.PIPE,
                                  given=data)
        check(found in status, f"status {found}: {err[-300:]}")

    return act


def without_streams(numbers, arguments):
    def act(place):
        def close():
            for number in numbers:
                os.close(number)

        process = place.start(*arguments, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL,
                              preexec_fn=close)
        check(process.wait(LIMIT) in STATUSES, f"status {process.returncode}")
        place.ended(process.returncode, "", "")

    return act


# ---- outputs ----

def _output_is_input(place):
    place.may_change = ("cube.stl",)
    status, _, _ = place.run("improve", "cube.stl", "-o", "cube.stl")
    check(status == 0, f"status {status}")
    good_mesh(place.work / "cube.stl")


def _output_is_an_operand(place):
    place.may_change = ("cube.stl",)
    place.run("boolean", "cube.stl", "box.brep", "-o", "cube.stl")
    good_mesh(place.work / "cube.stl")


def _output_is_input_by_link(place):
    place.may_change = ("cube.stl",)
    (place.work / "link.stl").symlink_to("cube.stl")
    place.run("improve", "cube.stl", "-o", "link.stl")
    check((place.work / "link.stl").is_symlink(), "the link was replaced")
    good_mesh(place.work / "cube.stl")


def _output_is_input_by_hard_link(place):
    place.may_change = ("cube.stl",)
    os.link(place.work / "cube.stl", place.work / "hard.stl")
    place.run("improve", "cube.stl", "-o", "hard.stl")
    check(os.path.samefile(place.work / "cube.stl", place.work / "hard.stl"), "the hard link was cut")
    good_mesh(place.work / "hard.stl")


def _link_loop(place):
    (place.work / "a.stl").symlink_to("b.stl")
    (place.work / "b.stl").symlink_to("a.stl")
    place.run("triangulate", "box.brep", "-o", "a.stl")


def _dangling(place):
    (place.work / "a.stl").symlink_to("nowhere/b.stl")
    place.run("triangulate", "box.brep", "-o", "a.stl")


def _link_chain(place):
    for i in range(45):
        (place.work / f"l{i}.stl").symlink_to(f"l{i + 1}.stl")
    place.run("triangulate", "box.brep", "-o", "l0.stl")


def _input_loop(place):
    (place.work / "a.brep").symlink_to("a.brep")
    status, _, _ = place.run("triangulate", "a.brep")
    check(status == 2, f"status {status}")


def _backslash(place):
    """FreeCAD takes it for a slash: another file must not be read in the place of this one."""
    (place.work / "a").mkdir()
    shutil.copy(place.work / "ball.brep", place.work / "a" / "b.brep")
    shutil.copy(place.work / "box.brep", place.work / "a\\b.brep")
    status, _, err = place.run("triangulate", "a\\b.brep", "-o", "c\\d.stl")
    check(status == 0, err[-300:])
    good_mesh(place.work / "c\\d.stl", 16)


def _meanwhile(place, act, arguments=LONG, after=0.9):
    """Something happens to the folders while a command runs, which is then told to end."""
    process = place.start(*arguments)
    wait_until_it_takes_signals(process)
    time.sleep(after)
    act()
    process.send_signal(signal.SIGINT)
    try:
        _, err = process.communicate(timeout=LIMIT)
    finally:
        process.kill()
        process.wait()
    place.ended(process.returncode, "", err.decode(errors="replace"))


def _folder_vanishes(place):
    (place.work / "results").mkdir()
    _meanwhile(place, lambda: shutil.rmtree(place.work / "results"),
               ("triangulate", "ball.brep", "-o", "results/out.stl", *ENDLESS))


def _folder_vanishes_before_writing(place):
    results = place.work / "results"
    results.mkdir()
    process = place.start("triangulate", "ball.brep", "-o", "results/out.stl", "--chord-height", "0.005")
    time.sleep(0.2)
    shutil.rmtree(results)
    _, err = process.communicate(timeout=LIMIT)
    place.ended(process.returncode, "", err.decode(errors="replace"))
    check(process.returncode in (1, 2) and not results.exists(), f"status {process.returncode}")


def _folder_becomes_a_file(place):
    results = place.work / "results"
    results.mkdir()

    def replace():
        results.rmdir()
        results.write_text("mine", encoding="ascii")

    process = place.start("triangulate", "ball.brep", "-o", "results/out.stl", "--chord-height", "0.005")
    time.sleep(0.2)
    replace()
    _, err = process.communicate(timeout=LIMIT)
    place.ended(process.returncode, "", err.decode(errors="replace"))
    check(results.read_text(encoding="ascii") == "mine", "a file was lost")


def _output_becomes_a_link(place):
    """Between the start and the end the output becomes a link to another file."""
    target = place.work / "thesis.doc"
    target.write_text("mine", encoding="ascii")
    process = place.start("triangulate", "ball.brep", "-o", "out.stl", "--chord-height", "0.005")
    time.sleep(0.2)
    (place.work / "out.stl").symlink_to("thesis.doc")
    _, err = process.communicate(timeout=LIMIT)
    place.ended(process.returncode, "", err.decode(errors="replace"))


def _temporary_folder_vanishes(place):
    def remove():
        for path in place.temporary.iterdir():
            if path.is_dir():
                shutil.rmtree(path, ignore_errors=True)

    _meanwhile(place, remove)


def _input_vanishes(place):
    place.may_change = ("ball.brep",)
    _meanwhile(place, (place.work / "ball.brep").unlink)


def _input_is_truncated(place):
    place.may_change = ("ball.brep",)
    # Readers of OpenCASCADE may look for the rest for ever.
    process = place.start("triangulate", "ball.brep", "-o", "out.stl", "--time-limit", "8")
    os.truncate(place.work / "ball.brep", 500)
    _, err = process.communicate(timeout=LIMIT)
    place.ended(process.returncode, "", err.decode(errors="replace"))


def _read_only_folder(place):
    """As somebody who is not root."""
    results = place.work / "results"
    results.mkdir(mode=0o555)
    options = {"user": 65534, "group": 65534} if os.geteuid() == 0 else {}
    os.chmod(place.folder, 0o755)
    os.chmod(place.temporary, 0o777)
    try:
        process = place.start("triangulate", "box.brep", "-o", "results/out.stl",
                              environment={"HOME": str(place.temporary)}, **options)
    except PermissionError:
        return  # where others may not even look into the folder of the tests
    _, err = process.communicate(timeout=LIMIT)
    shutil.rmtree(place.temporary)  # FreeCAD's settings
    place.temporary.mkdir()
    place.ended(process.returncode, "", err.decode(errors="replace"))
    check(process.returncode in (1, 2), f"status {process.returncode}")


def named(name, arguments=("triangulate",)):
    """An input and an output of that name."""
    def act(place):
        source = os.fsencode(place.work / "box.brep")
        folder = os.fsencode(place.work) + b"/"
        given = name if isinstance(name, bytes) else name.encode()
        with contextlib.suppress(OSError):
            shutil.copy(source, folder + given + b".brep")
        place.run(*arguments, b"./" + given + b".brep", "-o", b"./" + given + b".stl")

    return act


NAMES = {"a leading dash": "-o", "a newline": "two\nlines", "a tab": "a\tb", "quotes": "\"'`",
         "a semicolon": "a;rm -rf x", "a dollar": "$(x)$HOME",
         "emoji": "\U0001f600", "spaces": "  ", "a backslash": "a\\b", "a percent sign": "%s%n", "250 bytes": "x" * 245,
         "60 signs of 4 bytes": "\U0001f600" * 60,
         "not UTF-8": b"caf\xe9\xff", "combining": "e\u0301\u0301", "right to left": "\u202eabc", "a BOM": "\ufeffx",
         "a control sign": "\x01\x1b[31m", "a colon": "C:x",
         "braces": "{0}", "only dots": "...x", "a star": "*?[a]"}
TIMES = {"1970": 0, "2100": 4102444800, "before 1970": -10**9, "year 9999": 253370764800}


def at_time(seconds):
    def act(place):
        for name in ("box.brep", "box.step", "box.FCStd"):
            os.utime(place.work / name, (seconds, seconds))
            status, _, err = place.run("triangulate", name, "-o", "out.stl")
            check(status == 0, err[-300:])

    return act


def damaged(name, change):
    def act(place):
        place.may_change = (name,)
        path = place.work / name
        path.write_bytes(change(path.read_bytes()))
        place.run("quality" if name.endswith(".stl") else "triangulate", name, "--time-limit", "15")

    return act


def _noise(seed, share):
    def change(data):
        dice = random.Random(seed)
        data = bytearray(data)
        for _ in range(max(1, int(share * len(data)))):
            data[dice.randrange(len(data))] = dice.randrange(256)
        return bytes(data)

    return change


ARGUMENTS = {
    "nothing": (), "an empty text": ("",), "an empty input": ("triangulate", ""), "a folder": ("triangulate", "."),
    "dashes": ("--", "--"),
    "an option twice": ("triangulate", "box.brep", "--min-angle", "20", "--min-angle", "25"),
    "100,000 letters": ("triangulate", "x" * 100_000),
    "an empty value": ("triangulate", "box.brep", "--min-angle", ""),
    "a comma": ("triangulate", "box.brep", "--min-angle", "20,5"),
    "hexadecimal": ("triangulate", "box.brep", "--max-edge", "0x10"),
    "underscores": ("triangulate", "box.brep", "--max-edge", "1_0"),
    "Arabic digits": ("triangulate", "box.brep", "--max-edge", "\u0663"),
    "a fullwidth number": ("triangulate", "box.brep", "--max-edge", "\uff15"),
    "NaN": ("triangulate", "box.brep", "--max-edge", "nan"),
    "1e400": ("triangulate", "box.brep", "--max-edge", "1e400"),
    "a huge whole number": ("triangulate", "box.brep", "--max-triangles", "9" * 5000),
    "-0": ("triangulate", "box.brep", "--max-edge", "-0"),
    "1000 operands": ("boolean", *["cube.stl"] * 1000), "one operand": ("boolean", "cube.stl"),
    "a mesh as CAD": ("triangulate", "cube.stl"), "CAD as a mesh": ("improve", "box.brep"),
    "standard input twice": ("boolean", "-", "-"),
    "an output in no folder": ("triangulate", "box.brep", "-o", "a/b/c.stl"),
    "an output without extension": ("triangulate", "box.brep", "-o", "out"),
    "an empty output": ("triangulate", "box.brep", "-o", ""),
    "an output below a file": ("triangulate", "box.brep", "-o", "cube.stl/x.stl"),
    "an extension of capitals": ("triangulate", "box.brep", "-o", "OUT.STL"),
    "dots alone": ("triangulate", "box.brep", "-o", ".stl"),
    "no such object": ("triangulate", "box.FCStd", "--object", "\u202e\n"),
    "an object of STEP": ("triangulate", "box.step", "--object", "Box"),
    "local sizes of 10^5": ("triangulate", "box.brep", "--local-sizes", "Face1=1," * 15_000),
    "a time limit of 1e-9": ("triangulate", "box.brep", "--time-limit", "1e-9"),
    "a time limit of 1e300": ("triangulate", "box.brep", "--time-limit", "1e300"),
    "a memory limit of 1e-9": ("triangulate", "box.brep", "--memory-limit", "1e-9"),
    "a memory limit of 1e300": ("triangulate", "box.brep", "--memory-limit", "1e300"),
    "help of help": ("--help", "--help"), "a surrogate": ("triangulate", b"\xff\xfe"),
    "abbreviations": ("tri", "box.brep"), "a file of arguments": ("triangulate", "@box.brep"),
}


def rows():
    found = [Attack(f"environment: {name}", attack_of(in_environment(changes, statuses or STATUSES)))
             for name, (changes, statuses) in ENVIRONMENTS.items()]
    found += [Attack(f"limit: {name}", attack_of(within(which, value, QUICK))) for name,
              (which, value) in LIMITS.items()]
    dice = random.Random(4)
    for name, number in SIGNALS.items():
        for said, arguments in (("triangulate", LONG), ("boolean", BOOLEAN), ("volume", VOLUME)):
            for after in (0.0, dice.uniform(0.0, 0.1), dice.uniform(0.1, 0.5), dice.uniform(0.5, 1.2)):
                found.append(Attack(f"{name} after {after:.3f} s: {said}",
                                    attack_of(signalled(number, after, arguments))))
        found.append(Attack(f"{name} twice", attack_of(signalled(number, 0.3, LONG, again=True))))
        if number != signal.SIGINT:  # which Python's own start may swallow
            found.append(Attack(f"{name} at once", attack_of(signalled(number, None, LONG))))
    found += [Attack(f"stopped after {after} s, then {name}", attack_of(_stopped(after, number)))
              for after in (0.3, 0.9) for name, number in SIGNALS.items()]
    printing = (("a mesh", ("triangulate", "ball.brep", "-o", "-", "--format", "ply", "--chord-height", "0.01")),
                ("JSON", ("triangulate", "box.brep", "--json")), ("words", ("triangulate", "box.brep")))
    found += [Attack(f"stdout closed after {count} bytes: {name}", attack_of(piped(arguments, count)))
              for count in (0, 1, 100) for name, arguments in printing]
    found += [Attack(f"stdin: {name}", attack_of(fed(data, form, status))) for name, data, form, status in (
        ("nothing", b"", "stl", (1, 2)), ("nothing for CAD", b"", "brep", (1, 2)),
        ("64 MiB of zeros", bytes(64 * MIB), "stl", STATUSES),
        ("zeros for CAD", bytes(MIB), "step", (1, 2)), ("a cube", stl_of_cube(), "stl", (0,)),
        ("half a cube", stl_of_cube()[:300], "stl", STATUSES),
        ("text", b"solid x\n" * 10000, "stl", STATUSES))]
    found += [Attack(f"streams {numbers} closed: {name}", attack_of(without_streams(numbers, arguments)))
              for numbers in ((0,), (1,), (2,), (0, 1), (0, 1, 2)) for name,
              arguments in (("quick", QUICK), ("from stdin", ("quality", "-", "--input-format", "stl")))]
    found += [Attack(act.__name__.strip("_").replace("_", " "), attack_of(act)) for act in (
        _output_is_input, _output_is_an_operand, _output_is_input_by_link, _output_is_input_by_hard_link, _link_loop,
        _dangling, _link_chain,
        _input_loop, _folder_vanishes, _folder_vanishes_before_writing, _folder_becomes_a_file, _output_becomes_a_link,
        _backslash, _temporary_folder_vanishes, _input_vanishes, _input_is_truncated, _read_only_folder)]
    found += [Attack(f"a name of {said}", attack_of(named(name))) for said, name in NAMES.items()]
    found += [Attack(f"files of {said}", attack_of(at_time(seconds))) for said, seconds in TIMES.items()]
    found += [Attack(f"{name} with noise of {share:g}, seed {seed}", attack_of(damaged(name, _noise(seed, share))))
              for name in ("box.brep", "box.step", "box.FCStd", "cube.stl") for seed, share in ((1, 0.0), (2, 0.01))]
    found += [Attack(f"arguments: {said}", attack_of(lambda place, a=arguments: place.run(*a))) for said,
              arguments in ARGUMENTS.items()]
    return found


def _stopped(after, number):
    """Stopped for a while; while it is stopped a signal comes, and takes effect when it goes on."""
    def act(place):
        process = place.start(*LONG)
        wait_until_it_takes_signals(process)
        time.sleep(after)
        process.send_signal(signal.SIGSTOP)
        time.sleep(0.2)
        process.send_signal(number)
        process.send_signal(signal.SIGCONT)
        try:
            _, err = process.communicate(timeout=LIMIT)
        finally:
            process.kill()
            process.wait()
        place.ended(process.returncode, "", err.decode(errors="replace"))

    return act

