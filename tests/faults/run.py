#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts the faults of list.txt into a copy of the sources, one at a time, and tells which tests notice them.

A fault is held by a number, or by a picture of others or of another program, where a test other than those of golden
files fails. One that a golden text or picture alone notices would be blessed by a careless update of the goldens.
Verdicts are kept in FOLDER/verdicts.tsv: what has one is not tried again. Exits with 1 where less than 95 % are
noticed, or less than 85 % by a number; with 2 where the list is wrong."""
import argparse
import dataclasses
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
NOTICED, BY_NUMBER = 0.95, 0.85  # The least shares of all faults.
MINUTES = 30  # The longest that a program may take: a fault may make it run on.
GOLDEN = {"Golden": "text", "PictureGolden": "picture"}  # By suite.
WITH_GOLDENS = ("golden_test", "picture_test")
WORDS = {"number": "noticed by a number or a picture of others", "text": "noticed by a golden text alone",
         "picture": "noticed by a golden picture alone", "missed": "not noticed", "unbuilt": "does not build"}


class ListError(Exception):
    pass


@dataclasses.dataclass
class Fault:
    line: int
    file: str
    old: str
    new: str
    seen: str = ""

    @property
    def id(self):
        return hashlib.sha1("\n".join((self.file, self.old, self.new)).encode()).hexdigest()[:10]


def read_list(path):
    """Blocks of "- the text as it is", "+ what takes its place", "= what a user sees", below "@ its file"."""
    faults, file = [], None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        mark, text = line[:1], line[2:]
        if mark == "@":
            file = text
        elif mark == "-":
            faults.append(Fault(number, file, text, None))
        elif mark == "+":
            faults[-1].new = text
        elif mark == "=":
            faults[-1].seen = text
        elif mark not in ("", "#"):
            raise ListError(f"{path.name}:{number}: a line begins with one of @ - + = #")
    return faults


def check(faults):
    """Each pattern must be in its file, once: else it is not known what the fault would be."""
    wrong, seen = [], set()
    for fault in faults:
        file = ROOT / fault.file
        count = file.read_text().count(fault.old) if file.is_file() else 0
        if count != 1:
            wrong.append(f"list.txt:{fault.line}: '{fault.old}' is {count} times in {fault.file}, not once")
        if fault.new is None or not fault.seen or fault.new == fault.old:
            wrong.append(f"list.txt:{fault.line}: '+ what takes its place' or '= what a user sees' is missing")
        if not programs_for(fault.file):
            wrong.append(f"list.txt:{fault.line}: programs.txt names no programs for {fault.file}")
        if fault.id in seen:
            wrong.append(f"list.txt:{fault.line}: the same fault stands there twice")
        seen.add(fault.id)
    if wrong:
        raise ListError("\n".join(wrong))


def programs_table():
    rows = (line.split() for line in (HERE / "programs.txt").read_text().splitlines())
    return [(row[0], row[1:]) for row in rows if row and not row[0].startswith("#")]


def programs_for(file):
    """Of the longest matching beginning; those of golden files last."""
    rows = [row for row in programs_table() if file.startswith(row[0])]
    programs = max(rows, key=lambda row: len(row[0]))[1] if rows else []
    return sorted(programs, key=lambda name: name in WITH_GOLDENS)


class Tree:
    """A copy of the sources with a build tree of its own; what lies beside the checkout lies beside it as well."""

    def __init__(self, folder, jobs):
        self.folder, self.jobs = folder, jobs
        self.source, self.build = folder / "source", folder / "build"
        self.expected = {}  # By program: the tests that fail without a fault.

    def prepare(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        shared, link = ROOT.parent / "shared", self.folder / "shared"
        if shared.is_dir() and not link.exists():
            link.symlink_to(shared)
        names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
        for name in names.splitlines():
            self.copy(name)
        self.run(["cmake", "-G", "Ninja", "-S", self.source, "-B", self.build, "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
                  "-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-O1 -g1"], "cmake.log")

    def copy(self, name):
        """Keeps the times of files that are the same, so that they are not built again."""
        source, target = ROOT / name, self.source / name
        if source.is_file() and not (target.is_file() and target.read_bytes() == source.read_bytes()):
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)

    def run(self, command, log):
        with open(self.folder / log, "w") as out:
            return subprocess.run(command, stdout=out, stderr=subprocess.STDOUT, cwd=self.folder).returncode == 0

    def make(self, programs):
        return self.run(["ninja", "-C", self.build, f"-j{self.jobs}", *programs], "build.log")

    def failures(self, program, only_first=False):
        """The tests of a program that fail, or the program's own name where it ends in a signal or goes on and on."""
        environment = dict(os.environ, MESA_SHADER_CACHE_DISABLE="true")
        command = [self.build / "bin" / program, f"--gtest_filter={self.filter(program)}", "--gtest_brief=1",
                   f"--gtest_fail_fast={int(only_first)}"]
        try:
            ran = subprocess.run(command, cwd=self.build, env=environment, capture_output=True, timeout=60 * MINUTES)
        except subprocess.TimeoutExpired:
            return {program}
        lines = ran.stdout.decode(errors="replace").splitlines()
        failed = {line.split("] ")[1].split(",")[0].split(" (")[0] for line in lines if line.startswith("[  FAILED  ] ")}
        failed = {test for test in failed if "." in test}
        return failed or ({program} if ran.returncode else set())

    def filter(self, program):
        """Both back ends draw with the same rasteriser: one of them will do, but where back ends are the subject."""
        skipped = set(self.expected.get(program, ()))
        if program not in ("platform_test", "multisample_test", "viewer_test"):
            skipped.add("*/egl")
        return "-" + ":".join(sorted(skipped))

    def learn(self, programs):
        """Which tests fail without a fault, as where something is not installed."""
        for program in programs:
            self.expected[program] = self.failures(program)
            if program in self.expected[program]:
                raise ListError(f"{program} does not run without a fault")
            for test in self.expected[program]:
                print(f"left out: {test} fails without a fault")

    def try_one(self, fault):
        """The verdict, and the first test that made it."""
        file = self.source / fault.file
        text = file.read_text()
        file.write_text(text.replace(fault.old, fault.new))
        try:
            return self.verdict(programs_for(fault.file))
        finally:
            file.write_text(text)

    def verdict(self, programs):
        golden = None
        for program in programs:
            if not self.make([program]):
                return "unbuilt", program
            failed = sorted(self.failures(program, only_first=program not in WITH_GOLDENS))
            kinds = {test: kind_of(test) for test in failed}
            for test, kind in kinds.items():
                if kind == "number":
                    return kind, test
            for test, kind in kinds.items():
                golden = golden or (kind, test)
        return golden or ("missed", "")


def kind_of(test):
    suite = test.split(".")[0].split("/")[-1]
    return GOLDEN.get(suite, "number")


def read_verdicts(path):
    rows = (line.split("\t") for line in path.read_text().splitlines()) if path.is_file() else ()
    return {row[0]: row[1:] for row in rows}


def share(part, whole):
    return f"{part} of {whole} ({100 * part / max(whole, 1):.0f} %)"


def report(faults, verdicts):
    known = [(fault, verdicts[fault.id]) for fault in faults if fault.id in verdicts]
    for fault, (kind, *_) in known:
        if kind != "number":
            print(f"{WORDS[kind]}: {fault.file}: {fault.seen}\n    - {fault.old}\n    + {fault.new}")
    tried = [verdict[0] for _, verdict in known if verdict[0] != "unbuilt"]
    print(f"{len(tried)} of {len(faults)} faults were tried")
    for kind in ("number", "text", "picture", "missed"):
        print(f"  {WORDS[kind]}: {share(tried.count(kind), len(tried))}")
    noticed, numbers = len(tried) - tried.count("missed"), tried.count("number")
    return noticed >= NOTICED * len(tried) and numbers >= BY_NUMBER * len(tried)


def attempt(faults, tree, path, again):
    verdicts = read_verdicts(path)
    wanted = [fault for fault in faults if verdicts.get(fault.id, [again])[0] == again or again == "all"]
    if not wanted:
        return
    tree.prepare()
    programs = sorted({program for fault in wanted for program in programs_for(fault.file)})
    if not tree.make(programs):
        raise ListError(f"the tests do not build: see {tree.folder / 'build.log'}")
    tree.learn(programs)
    for number, fault in enumerate(wanted, 1):
        begin = time.monotonic()
        kind, test = tree.try_one(fault)
        seconds = time.monotonic() - begin
        print(f"{number}/{len(wanted)} {kind}: {fault.file}: {fault.seen} [{test}, {seconds:.0f} s]", flush=True)
        with open(path, "a") as out:  # Of two lines for one fault, the later one counts.
            print(fault.id, kind, test, f"{seconds:.0f}", fault.file, fault.seen, sep="\t", file=out)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="only see whether the list fits the sources")
    parser.add_argument("--report", action="store_true", help="only print the shares of what was tried")
    parser.add_argument("--only", metavar="WORD", default="", help="faults whose file or words contain it")
    parser.add_argument("--again", metavar="VERDICT", help="try those again: missed, text, picture, number, or all")
    parser.add_argument("--folder", metavar="FOLDER", type=pathlib.Path, default=ROOT / "build/faults")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    try:
        everything = read_list(HERE / "list.txt")
        check(everything)
        if options.check:
            return 0
        faults = [fault for fault in everything if options.only in f"{fault.file} {fault.seen}"]
        folder = options.folder.resolve()
        if not options.report:
            attempt(faults, Tree(folder, options.jobs), folder / "verdicts.tsv", options.again)
        return 0 if report(faults, read_verdicts(folder / "verdicts.tsv")) else 1
    except ListError as error:
        print(error, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
