#!/usr/bin/env python3
"""Mutants: deliberate mistakes in the code, each of which a test should see.  run.py FOLDER [--jobs N] [WORD...]

Copies the checkout to FOLDER/source and builds it in FOLDER/build. Puts each mutant of mutants/*.toml into the copy, or
only mutants whose file or text has one of the words. Builds the changed parts, and runs the named tests, PROGRAM or
PROGRAM:FILTER. A mutant is built into the library; with `units`, which headers have, these test sources alone are
compiled with it. `unchanged` says why a mutant changes no result.

Verdicts are kept in FOLDER/verdicts.jsonl: a further call goes on behind them; remove the file to begin again. Exit
code 1 if a mutant without `unchanged` survived, one with it was killed, or one does not compile.
"""

import argparse
import collections
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import time
import tomllib

here = pathlib.Path(__file__).resolve().parent
checkout = here.parent.parent
longest_test = 600  # s


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--list", action="store_true", help="check that every mutant fits, and run none")
    parser.add_argument("words", nargs="*")
    given = parser.parse_args()
    given.source, given.build = given.folder.resolve() / "source", given.folder.resolve() / "build"
    return given


def copy_checkout(given):
    """Times of files are kept, so that a further call builds only changed files."""
    shutil.rmtree(given.source, ignore_errors=True)
    for name in subprocess.check_output(["git", "-C", checkout, "ls-files", "-z"], text=True).split("\0"):
        if (checkout / name).is_file():
            (given.source / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(checkout / name, given.source / name)
    subprocess.run(["cmake", "-S", given.source, "-B", given.build, "--preset", "mutation"], cwd=given.source,
                   stdout=subprocess.DEVNULL, check=True)


def all_mutants():
    lists = [tomllib.loads(path.read_text()) for path in sorted(here.glob("mutants/*.toml"))]
    return [{"file": file, **mutant} for of_file in lists for file, mutants in of_file.items() for mutant in mutants]


def key_of(mutant):
    fields = [mutant[name] for name in ("file", "before", "after", "tests")] + mutant.get("units", [])
    return hashlib.sha256(json.dumps(fields).encode()).hexdigest()[:12]


def text_of(mutant):
    return f"{mutant['file']}: {mutant['before']} => {mutant['after']}"


def run(command, given, **options):
    return subprocess.run(command, cwd=given.build, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          errors="replace", **options)


def program_of(test):
    folder = test.split(":")[0]
    return f"moat_{folder}_tests", f"tests/{folder}/moat_{folder}_tests"


def build(mutant, given):
    """Returns the programs to run, or None if it does not compile."""
    if "units" not in mutant:
        if run(["ninja", f"-j{given.jobs}", "moat"], given).returncode:
            return None
        return [given.build / program_of(test)[1] for test in mutant["tests"]]
    commands = {entry["file"]: entry["command"] for entry in
                json.loads((given.build / "compile_commands.json").read_text())}
    objects = []
    for unit in mutant["units"]:
        words = shlex.split(commands[str(given.source / unit)])
        for word in ("-Werror", "-Winvalid-pch", "-fpch-preprocess", "ccache"):  # the header is in the precompiled one
            words = [each for each in words if each != word]
        at = words.index("-include")
        words[at:at + 2] = []
        objects.append(f"{unit.replace('/', '_')}.o")
        words[words.index("-o") + 1] = objects[-1]
        if run([word if word != "-O3" else "-O1" for word in words], given).returncode:
            return None
    program = given.build / "mutant_tests"
    library = given.build / "src"
    linked = run(["c++", *objects, "-o", program, f"-L{library}", f"-Wl,-rpath,{library}", "-lmoat", "-lgtest_main",
                  "-lgtest"], given)
    for name in objects:
        (given.build / name).unlink()
    return None if linked.returncode else [program] * len(mutant["tests"])


def verdict_of(mutant, given):
    programs = build(mutant, given)
    if programs is None:
        return "does not compile"
    for program, test in zip(programs, mutant["tests"]):
        _, _, chosen = test.partition(":")
        words = [program, "--gtest_fail_fast", "--gtest_brief=1", f"--gtest_filter={chosen or '*'}"]
        try:
            result = run(words, given, timeout=longest_test)
        except subprocess.TimeoutExpired:
            return f"killed by the time of {test}"
        if result.returncode:
            failed = re.search(r"FAILED  \] (\S+)", result.stdout)
            return f"killed by {failed[1].rstrip(',') if failed else f'exit code {result.returncode} of {test}'}"
        if not re.search(r"\[=+\] [1-9]\d* tests? (from .* )?ran", result.stdout):
            return f"not tested: {test} names no test"
    return "survived"


def main():
    given = arguments()
    mutants = all_mutants()
    unfit = [mutant for mutant in mutants if (checkout / mutant["file"]).read_text().count(mutant["before"]) != 1]
    for mutant in unfit:
        print(f"{mutant['file']} does not have this once: {mutant['before']}")
    if unfit or given.list:
        print(f"{len(mutants)} mutants, {sum('units' in mutant for mutant in mutants)} of them in headers")
        return bool(unfit)
    copy_checkout(given)
    log = given.folder / "verdicts.jsonl"
    known = {}
    if log.exists():
        known = {entry["key"]: entry["verdict"] for entry in map(json.loads, log.read_text().splitlines())}
    chosen = [mutant for mutant in mutants if not given.words or any(word in text_of(mutant) for word in given.words)]
    programs = {program_of(test)[0] for mutant in chosen if "units" not in mutant for test in mutant["tests"]}
    built = run(["ninja", f"-j{given.jobs}", "moat", *sorted(programs)], given)
    if built.returncode:
        sys.exit(f"The tests do not compile without a mutant:\n{built.stdout[-2000:]}")
    count, bad = collections.Counter(), []
    for mutant in chosen:
        text = text_of(mutant)
        key = key_of(mutant)
        if key not in known:
            file, begin = given.source / mutant["file"], time.monotonic()
            original = file.read_text()
            try:
                file.write_text(original.replace(mutant["before"], mutant["after"]))
                known[key] = verdict_of(mutant, given)
            finally:
                file.write_text(original)
            with log.open("a") as out:
                out.write(json.dumps({"key": key, "verdict": known[key], "mutant": text,
                                      "seconds": round(time.monotonic() - begin)}) + "\n")
        verdict = known[key].split(" by ")[0].split(":")[0]
        changes = "unchanged" not in mutant
        count[verdict if changes else f"{verdict}, no result changes"] += 1
        if verdict != ("killed" if changes else "survived"):
            bad.append(text)
        print(f"{known[key]}: {text}", flush=True)
    for kind, number in sorted(count.items()):
        print(f"{number:4} {kind}")
    changed = count["killed"] + count["survived"]
    if changed:
        print(f"{count['killed']} of {changed} mutants that change a result were killed: "
              f"{100 * count['killed'] / changed:.0f} %")
    for text in bad:
        print(f"UNEXPECTED: {text}")
    return bool(bad)


sys.exit(main())
