#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""handbook.py SOURCE_DIR PROGRAMS_DIR WORK_DIR PARTS_DIR: runs the commands of the handbook's pages, and keeps what they draw and say.

Each page has a folder, in which its blocks of commands (```sh) are run from above to below, as a reader would who has the
packages: the programs have their installed names. There are urn.glb, a model, lake.hdr, a sky, and each block of the page
whose first line is a comment that begins with a file's name and a colon. Fails where a command does. PARTS_DIR gets the
pictures that the page shows (`<!-- picture: urn.png Caption -->`) as PAGE-urn.png, and what the n-th block prints as
PAGE-n.txt (`<!-- part: PAGE-n.txt -->`).
"""
import concurrent.futures
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys

BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"^(?://|#) ([\w.-]+\.\w+):")
PICTURE = re.compile(r"<!-- picture: (\S+) ")
INSTALLED = ["frankenshader", "viewer", "bake", "kiosk"]


def link_programs(programs, folder):
    folder.mkdir(parents=True)
    for program in INSTALLED:
        if (programs / program).exists():
            name = program if program == "frankenshader" else "frankenshader-" + program
            (folder / name).symlink_to(programs / program)


def rgbe(color):
    """A texel as Radiance has it: three mantissas that share an exponent."""
    mantissa, exponent = math.frexp(max(color))
    scale = mantissa * 256 / max(color)
    return bytes([*(int(channel * scale) for channel in color), exponent + 128])


def write_sky(path):
    """An evening over a lake: 256 x 128 texels, so that it is filtered in a second."""
    width, height, sun = 256, 128, (0.55, 0.2, 0.81)
    texels = bytearray()
    for y in range(height):
        polar = math.pi * (y + 0.5) / height
        for x in range(width):
            azimuth = 2 * math.pi * ((x + 0.5) / width - 0.5)
            direction = (math.sin(polar) * math.sin(azimuth), math.cos(polar), -math.sin(polar) * math.cos(azimuth))
            up = abs(direction[1])
            share = math.sqrt(up)
            facing = sum(a * b for a, b in zip((direction[0], up, direction[2]), sun))
            glow = 1.5 * max(facing, 0) ** 16 + (2000 if facing > 0.9994 and direction[1] > 0 else 0)
            dim = 1 if direction[1] > 0 else 0.35  # The lake mirrors the sky.
            texels += rgbe([dim * (low + (high - low) * share + tint * glow) for low, high, tint in
                            ((0.9, 0.12, 1.0), (0.5, 0.28, 0.7), (0.3, 0.6, 0.35))])
    path.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width) + texels)


def run_page(page, given, folder, parts):
    """What went wrong, or nothing."""
    folder.mkdir(parents=True)
    for file in given.iterdir():
        shutil.copy(file, folder)
    text = page.read_text(encoding="utf-8")
    blocks = BLOCK.findall(text)
    for _, code in blocks:
        if name := NAMED.match(code):
            (folder / name[1]).write_text(code, encoding="utf-8")
    environment = os.environ | {"PATH": f"{folder.parent / 'bin'}:{os.environ['PATH']}", "HOME": str(folder),
                                "GALLIUM_DRIVER": "softpipe", "LIBGL_ALWAYS_SOFTWARE": "1",
                                "MESA_SHADER_CACHE_DISABLE": "true"}
    for number, code in enumerate((code for language, code in blocks if language == "sh"), 1):
        done = subprocess.run(["sh", "-euxc", code], cwd=folder, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            return f"{page}: the commands of block {number} end with {done.returncode}:\n{done.stderr}"
        (parts / f"{page.stem}-{number}.txt").write_text(f"```text\n{done.stdout.rstrip()}\n```\n", encoding="utf-8")
    for name in PICTURE.findall(text):
        if not (folder / name).exists():
            return f"{page}: no command draws {name}"
        shutil.copy(folder / name, parts / f"{page.stem}-{name}")
    return ""


def main(source, programs, work, parts):
    work, programs, parts = (pathlib.Path(path).resolve() for path in (work, programs, parts))
    shutil.rmtree(work, ignore_errors=True)
    link_programs(programs, work / "bin")
    given = work / "given"
    given.mkdir()
    subprocess.run([programs / "make_model", given / "urn.glb"], check=True)
    write_sky(given / "lake.hdr")
    pages = sorted((pathlib.Path(source) / "toolchains/docs/handbook").glob("*.md"))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        faults = list(threads.map(lambda page: run_page(page, given, work / page.stem, parts), pages))
    print("\n".join(filter(None, faults)), file=sys.stderr, end="")
    return 1 if any(faults) else 0


sys.exit(main(*sys.argv[1:]))
