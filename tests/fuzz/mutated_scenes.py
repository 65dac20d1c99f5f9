#!/usr/bin/env python3
"""Runs mutated scenes: those that come with actio, and one of every system, each with a few changes.

    tests/fuzz/mutated_scenes.py --actio build/bin/actio --count 10000 --seed 1

Whatever a scene says, the command ends by itself, or at an interrupt where it is honest work; its status is
one of those that it promises; what it complains of is one plain line without a number that is none; and what
it computes is finite. Scenes that fall short are kept in the folder that --keep names. Status: 0 where none
does, 1 where one does.
"""

import argparse
import collections
import concurrent.futures
import json
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile

NUMBERS = """0 1 -1 2 3 7 0.5 -0.5 1e-3 1e3 1e-9 1e9 -1e-9 1e-17 1e17 1e-100 1e100 1e-300 1e300 1e-320 -1e300
    nan inf -inf 64 1000 99999999999 0.1 0.3333333333 3.141592653589793 1.0000000001""".split()
PIECES = """+ - * / ^ ( ) , ; = . 0 1 2 x y z X Y Z t pi sin( sqrt( exp( 1/ -1*
    r11 w1 v1 "" ' # [ ] { } \\ é""".split()
NUMBER = re.compile(r"(?<![A-Za-z_\d.])-?\d+(?:\.\d+)?(?:e-?\d+)?(?![A-Za-z_\d.])")
SECONDS, GRACE = 10, 10


class Mutator:
    """Changes scenes, by the words and lines of all of them."""

    def __init__(self, scenes):
        self.scenes = scenes
        lines = [line for text in scenes for line in text.splitlines() if "=" in line]
        self.lines = sorted(set(lines))
        self.words = sorted(set(re.findall(r"[A-Za-z_]\w*", "\n".join(lines))))

    def scene(self, rng):
        """A changed scene, and arguments for the command."""
        lines = rng.choice(self.scenes).splitlines()
        changes = [self.number, *[self.scaled] * 8, self.number_of_list, self.word, self.piece, self.without,
                   self.other_value, self.other_value, self.more, self.twice, self.swapped]
        for _ in range(rng.choice([1, 1, 1, 1, 2, 2, 3, 5])):
            rng.choice(changes)(rng, lines)
        return "\n".join(lines) + "\n", self.arguments(rng, lines)

    def arguments(self, rng, lines):
        keys, section = [], ""
        for line in lines:
            if found := re.match(r"\[([\w.]+)\]", line):
                section = found[1]
            elif found := re.match(r"(\w+) *=", line):
                keys.append(f"{section}.{found[1]}")
        out = []
        while keys and rng.random() < 0.08:
            key = rng.choice(keys)
            value = rng.choice(NUMBERS + ["{}", "[]", '""', "true", rng.choice(self.words)])
            out += rng.choice([["--unset", key], ["--set", f"{key}={value}"], ["--set", f"{key}[0]={value}"]])
        return out

    def line(self, rng, lines, having):
        found = [i for i, line in enumerate(lines) if having.search(line)]
        return rng.choice(found) if found else None

    def replace(self, rng, lines, pattern, new):
        at = self.line(rng, lines, pattern)
        if at is None:
            return
        one = rng.choice(list(pattern.finditer(lines[at])))
        lines[at] = lines[at][: one.start()] + new(one[0]) + lines[at][one.end() :]

    def number(self, rng, lines):
        self.replace(rng, lines, NUMBER, lambda _: rng.choice(NUMBERS))

    def scaled(self, rng, lines):
        factor = rng.choice([-1, 0.1, 0.5, 2, 3, 10, 1e3, 1e-3, 1 + 1e-9])
        self.replace(rng, lines, NUMBER, lambda old: f"{float(old) * factor:.12g}")

    def number_of_list(self, rng, lines):
        more = rng.choice(NUMBERS)
        item = re.compile(r", *-?\d[\d.e-]*")
        self.replace(rng, lines, item, lambda old: rng.choice(["", f"{old}, {more}"]))

    def word(self, rng, lines):
        self.replace(rng, lines, re.compile(r"[A-Za-z_]\w*"), lambda _: rng.choice(self.words))

    def piece(self, rng, lines):
        at = self.line(rng, lines, re.compile("="))
        if at is not None:
            i = rng.randrange(len(lines[at]) + 1)
            lines[at] = lines[at][:i] + rng.choice(PIECES) + lines[at][i + rng.choice([0, 0, 1, 2]) :]

    def without(self, rng, lines):
        if lines:
            del lines[rng.randrange(len(lines))]

    def more(self, rng, lines):
        lines.insert(rng.randrange(len(lines) + 1), rng.choice(self.lines))

    def other_value(self, rng, lines):
        """Of the same key, as another scene has it."""
        at = self.line(rng, lines, re.compile(r"^\w+ *="))
        if at is not None:
            key = re.match(r"\w+", lines[at])[0]
            others = [line for line in self.lines if re.match(rf"{key} *=", line)]
            lines[at] = rng.choice(others or lines)

    def twice(self, rng, lines):
        if lines:
            lines.insert(rng.randrange(len(lines) + 1), rng.choice(lines))

    def swapped(self, rng, lines):
        i, j = (self.line(rng, lines, re.compile(r"^\w+ *=")) for _ in range(2))
        if i is not None and j is not None:
            (a, x), (b, y) = (lines[k].split("=", 1) for k in (i, j))
            lines[i], lines[j] = f"{a}={y}", f"{b}={x}"


def short(text):
    """The same scene with twenty rows, and with few cells: thousands of them are run."""
    every = re.search(r"^every *= *([\d.e-]+)", text, re.M)
    if every:
        until = re.search(r"^until *= *([\d.e-]+)", text, re.M)
        if until and float(until[1]) > 20 * float(every[1]):
            text = text.replace(until[0], f"until = {20 * float(every[1]):.12g}")
    text = re.sub(r"^(\s*N *= *)\d+", r"\g<1>12", text, flags=re.M)
    return re.sub(r"cells *= *\[([^\]]*)\]", lambda m: "cells = [" + ", ".join(
        str(min(int(n), 8)) for n in m[1].split(",")) + "]", text)


def command(arguments, folder):
    """Status, what was said, and whether it had to be interrupted."""
    child = subprocess.Popen(arguments, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                             stdin=subprocess.DEVNULL)
    late = False
    try:
        _, said = child.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        late = True
        child.send_signal(signal.SIGINT)
        try:
            _, said = child.communicate(timeout=GRACE)
        except subprocess.TimeoutExpired:
            child.kill()
            _, said = child.communicate()
            return None, said, late
    return child.returncode, said, late


def table_is_finite(path):
    lines = path.read_text().splitlines()
    return all(re.fullmatch(r"[-+0-9.e,]*", line) for line in lines[1:])


def fault(text, status, said, late, folder):
    """What is wrong with how a scene was met; empty where nothing is."""
    if status is None:
        return "it does not end at an interrupt"
    if status < 0:
        return f"signal {-status}"
    if status not in (0, 2, 3) and not (late and status == 130):
        return f"status {status}"
    try:
        words = said.decode()
    except UnicodeDecodeError:
        return "it says what is no UTF-8"
    if status in (2, 3) and (not words.strip() or len(words) > 4000):
        return "the complaint is empty, or very long"
    if any(ord(c) < 32 and c != "\n" for c in words):
        return "it says what commands a terminal"
    if "-nan" in words and "-nan" not in text:
        return "it says -nan"
    out = folder / "out"
    if (out / "series.csv").exists() and not table_is_finite(out / "series.csv"):
        return "the table has what is no number"
    if (out / "summary.json").exists():
        summary = json.loads((out / "summary.json").read_text(), parse_constant=lambda name: name)
        drifts = list(summary.get("drift", {}).values()) + list(summary.get("drift_units", {}).values())
        if any(not isinstance(x, (int, float)) for x in drifts):
            return "a drift is no number"
    return ""


def try_one(actio, text, arguments):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "scene.toml").write_text(text)
        run = [actio, "run", "scene.toml", "--out", "out", "--quiet", *arguments]
        status, said, late = command(run, folder)
        return status, late, fault(text + " ".join(arguments), status, said, late, folder), said


def base_scenes(actio, data):
    listed = subprocess.run([actio, "list", "systems"], capture_output=True, text=True, check=True).stdout
    texts = [path.read_text() for path in sorted(data.glob("*.toml"))]
    for line in listed.splitlines():
        made = subprocess.run([actio, "new", line.split()[0]], capture_output=True, text=True, check=True)
        texts.append(re.sub(r"^# *(?=\w+ *=)", "", made.stdout, flags=re.M))
        texts.append(made.stdout)
    return [short(re.sub(r"^\s*#.*\n|  #.*", "", text, flags=re.M)) for text in texts]


def main():
    here = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--actio", default=str(here / "build/bin/actio"))
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", default="", help="a folder for the scenes that fall short")
    given = parser.parse_args()
    actio = str(pathlib.Path(given.actio).resolve())
    mutator = Mutator(base_scenes(actio, here / "data/scenes"))
    scenes = [mutator.scene(random.Random(f"{given.seed} {k}")) for k in range(given.count)]
    statuses, late_ones, faults = collections.Counter(), 0, []
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        results = pool.map(lambda scene: try_one(actio, *scene), scenes)
        for k, (status, late, wrong, said) in enumerate(results):
            statuses[status] += 1
            late_ones += late
            if (k + 1) % 1000 == 0:
                print(f"{k + 1} of {given.count}: statuses {dict(sorted(statuses.items(), key=str))}", flush=True)
            if wrong:
                faults.append(k)
                print(f"{k}: {wrong}: {said.decode(errors='replace').strip()[:300]}", flush=True)
                if given.keep:
                    keep = pathlib.Path(given.keep)
                    keep.mkdir(parents=True, exist_ok=True)
                    (keep / f"{given.seed}_{k}.toml").write_text(scenes[k][0])
                    (keep / f"{given.seed}_{k}.arguments").write_text(" ".join(scenes[k][1]))
    print(f"{given.count} scenes, seed {given.seed}: statuses {dict(sorted(statuses.items(), key=str))}, "
          f"{late_ones} interrupted after {SECONDS} s, {len(faults)} fell short")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
