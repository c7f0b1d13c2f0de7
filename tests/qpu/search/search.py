#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""search.py --seconds S --seed N --out DIR --snippets A,B,... GPU:NAME=GOAL...

Looks for the order of statements and factors that the Pi's compilers make the best of. README.md tells how it was run.
"""
import argparse
import pathlib
import random
import shutil
import subprocess
import tempfile
import time

import forms

ROOT = pathlib.Path(__file__).resolve().parents[3]
LOST_THREAD = 40  # A second thread hides more than that many instructions.


class Compiler:
    """One qpu-stats that stays open: a line in, three rows out."""

    def __init__(self, program, gpu):
        self.process = subprocess.Popen([program, gpu], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def price(self, vertex, fragment):
        self.process.stdin.write(f"x\t{vertex}\t{fragment}\topaque\n")
        self.process.stdin.flush()
        row = self.process.stdout.readline().rstrip("\n").split("\t")
        if row[2] == "error":
            return 1e6
        self.process.stdout.readline()
        self.process.stdout.readline()
        return int(row[3]) + (LOST_THREAD if row[0] == "vc4" and row[4] == "1" else 0)


class Search:
    def __init__(self, arguments):
        self.random = random.Random(arguments.seed)
        self.work = pathlib.Path(tempfile.mkdtemp())
        self.composer = arguments.composer
        self.goals = [(gpu, name, float(goal)) for gpu, _, rest in (g.partition(":") for g in arguments.goals)
                      for name, _, goal in [rest.partition("=")]]
        shutil.copytree(ROOT / "generator/glsl", self.work / "glsl")
        self.compilers = {gpu: Compiler(arguments.qpu_stats, gpu) for gpu in {gpu for gpu, _, _ in self.goals}}
        self.known = {}

    def cost(self, files):
        """The sum of all goals' instructions, and ten times what each is above its goal."""
        for name, lines in files.items():
            (self.work / f"glsl/fragment/{name}.glsl").write_text("\n".join(lines))
        names = [name for _, name, _ in self.goals]
        subprocess.run([self.composer, self.work / "glsl", self.work, *names], check=True)
        prices = [self._price(i, gpu) for i, (gpu, _, _) in enumerate(self.goals)]
        return sum(p + 10 * max(0, p - goal) for p, (_, _, goal) in zip(prices, self.goals)), prices

    def _price(self, number, gpu):
        vertex, fragment = (self.work / f"{number}.{stage}" for stage in ("vert", "frag"))
        key = gpu, fragment.read_text()
        if key not in self.known:
            self.known[key] = self.compilers[gpu].price(vertex, fragment)
        return self.known[key]

    def run(self, files, seconds):
        """Climbs down, goes sideways freely and up by one now and then, and returns to the best from time to time."""
        best = here = files
        best_cost, prices = self.cost(files)
        here_cost, tried, end = best_cost, 0, time.monotonic() + seconds
        print("start", best_cost, prices, flush=True)
        while time.monotonic() < end:
            candidate = here
            for _ in range(self.random.choice((1, 1, 2, 3))):
                candidate = forms.neighbour(candidate, self.random)
            if candidate == here:
                continue
            cost, prices = self.cost(candidate)
            tried += 1
            if cost <= here_cost + (self.random.random() < 0.03):
                here, here_cost = candidate, cost
            if cost < best_cost:
                best, best_cost = candidate, cost
                print(tried, best_cost, prices, flush=True)
            if tried % 400 == 0:
                here, here_cost = best, best_cost
        print("end", tried, best_cost, flush=True)
        return best


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=600)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=pathlib.Path, required=True, help="where the best snippets are written")
    parser.add_argument("--snippets", required=True, help="below generator/glsl/fragment, without .glsl")
    parser.add_argument("--composer", required=True, help="the program compose_from")
    parser.add_argument("--qpu-stats", required=True, help="bin/qpu-stats below the folder that toolchain.sh prints")
    parser.add_argument("goals", nargs="+", metavar="GPU:NAME=GOAL")
    arguments = parser.parse_args()
    search = Search(arguments)
    names = arguments.snippets.split(",")
    files = {name: (ROOT / f"generator/glsl/fragment/{name}.glsl").read_text().split("\n") for name in names}
    best = search.run(files, arguments.seconds)
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name, lines in best.items():
        (arguments.out / f"{name}.glsl").write_text("\n".join(lines))
    shutil.rmtree(search.work)


if __name__ == "__main__":
    main()
