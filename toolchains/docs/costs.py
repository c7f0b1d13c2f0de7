#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""costs.py SOURCE_DIR PARTS_DIR: the tables of the handbook's page of costs, from what tests/qpu has measured.

costs-programs.md: what programs cost on each GPU, by their names in goals.tsv; costs-peers.md: the same scene by other engines.
"""
import csv
import pathlib
import sys

GPUS = ["vc4", "v3d42", "v3d71"]
HEADS = "vc4: Pi 0–3 | v3d 4.2: Pi 4 | v3d 7.1: Pi 5 |\n"


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter="\t"))


def cell(cost):
    """"147, 2 threads", from what was measured on one GPU; empty where nothing was."""
    if not cost:
        return ""
    instructions, threads = cost
    return instructions if threads == "-" else f"{instructions}, {threads} thread{'' if threads == '1' else 's'}"


def table(head, costs):
    lines = [f"| {name} | " + " | ".join(cell(by_gpu.get(gpu)) for gpu in GPUS) + " |" for name, by_gpu in costs.items()]
    return f"| {head} | " + HEADS + "|---|---|---|---|\n" + "\n".join(lines) + "\n"


def programs(folder):
    costs = {}
    for row in rows_of(folder / "costs.tsv"):
        if row["outcome"] == "ok":
            costs.setdefault(f"`{row['name']}`", {})[row["gpu"]] = (row["fragment"], row["threads"])
    return table("fragment shader: instructions", costs)


def peers(folder):
    costs = {}
    for row in rows_of(folder / "peers/peers.tsv"):
        ok = row["outcome"] == "ok"
        name = f"{row['engine']} {row['version']}, {row['lights']} suns, extensions: {row['extensions']}".replace(" -,", ",")
        costs.setdefault(name.replace("1 suns", "1 sun"), {})[row["gpu"]] = (
            (row["fragment instructions"], row["fragment threads"]) if ok else (row["outcome"], "-"))
    return table("fragment shader: instructions", costs)


def main(source, parts):
    folder = pathlib.Path(source) / "tests/qpu"
    for name, make in [("costs-programs.md", programs), ("costs-peers.md", peers)]:
        (pathlib.Path(parts) / name).write_text(make(folder), encoding="utf-8")


main(*sys.argv[1:])
