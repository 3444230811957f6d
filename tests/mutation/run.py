#!/usr/bin/env python3
"""Mutants: deliberate mistakes in the code, each of which a test should see.  run.py FOLDER [--jobs N] [WORD...]

Copies the checkout to FOLDER/source and builds it in FOLDER/build, where no mutant is ever compiled. Puts each mutant
of mutants/*.toml into the copy, or only mutants whose file or text has one of the words. Compiles its source in
FOLDER/trial, links the library there, and runs the named tests with it, PROGRAM or PROGRAM:FILTER. They must pass
without the mutant first. A header has `units`, the sources that are compiled with it: of the library, or tests, which
then run alone. `unchanged` says why a mutant changes no result.

Verdicts are kept in FOLDER/verdicts.jsonl. A further call tries mutants that have none and those with an unexpected
one; remove the file to begin again. Exit code 1 if a mutant without `unchanged` survived, one with it was killed, or
one does not compile.
"""

import argparse
import collections
import filecmp
import functools
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
import tomllib

here = pathlib.Path(__file__).resolve().parent
checkout = here.parent.parent


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--list", action="store_true", help="check that every mutant fits, and run none")
    parser.add_argument("words", nargs="*")
    return parser.parse_intermixed_args()  # words may stand behind options


def all_mutants():
    lists = [tomllib.loads(path.read_text()) for path in sorted(here.glob("mutants/*.toml"))]
    return [{"file": file, "units": [file], **mutant}
            for of_file in lists for file, mutants in of_file.items() for mutant in mutants]


def key_of(mutant):
    fields = [mutant[name] for name in ("file", "before", "after", "tests", "units")]
    return hashlib.sha256(json.dumps(fields).encode()).hexdigest()[:12]


def text_of(mutant):
    return f"{mutant['file']}: {mutant['before']} => {mutant['after']}"


def kind_of(verdict):
    return verdict.split(" by ")[0]


def is_expected(mutant, verdict):
    return kind_of(verdict) == ("survived" if "unchanged" in mutant else "killed")


def program_of(test):
    return f"moat_{test.split(':')[0]}_tests"


class Trials:
    def __init__(self, folder, jobs):
        self.source, self.build, self.trial = (folder.resolve() / name for name in ("source", "build", "trial"))
        self.jobs = jobs

    def run(self, command, **options):
        return subprocess.run(command, cwd=self.build, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              errors="replace", **options)

    def copy_checkout(self):
        """Copies files that differ, also one that a killed call left with its mutant. Their new time lets ninja compile
        them, and only them."""
        names = subprocess.check_output(["git", "-C", checkout, "ls-files", "-z"], text=True).split("\0")
        files = {self.source / name: checkout / name for name in names if (checkout / name).is_file()}
        for old in self.source.rglob("*"):
            if old.is_file() and old not in files:
                old.unlink()
        for copy, file in files.items():
            if not copy.exists() or not filecmp.cmp(file, copy, shallow=False):
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, copy)

    def build_without_mutant(self, programs):
        subprocess.run(["cmake", "-S", self.source, "-B", self.build, "--preset", "mutation"], cwd=self.source,
                       stdout=subprocess.DEVNULL, check=True)
        built = self.run(["ninja", f"-j{self.jobs}", "moat", *programs])
        if built.returncode:
            sys.exit(f"The tests do not compile without a mutant:\n{built.stdout[-2000:]}")
        entries = json.loads((self.build / "compile_commands.json").read_text())
        self.commands = {os.path.relpath(entry["file"], self.source): entry["command"] for entry in entries}
        library = (self.build / "src/libmoat.so").resolve().relative_to(self.build)
        self.link = self.run(["ninja", "-t", "commands", "-s", library]).stdout
        self.link = self.link.replace(f"-o {library} ", f"-o {self.trial}/libmoat.so.0 ")

    def compile(self, units, file=None):
        """Compiles units, with a mutant in a file or none, and links the library or the program `tests` with them.
        Returns whether that works."""
        shutil.rmtree(self.trial, ignore_errors=True)
        self.trial.mkdir()
        link, objects = self.link, []
        for unit in units:
            words = shlex.split(self.commands[unit])
            if unit != file:  # The precompiled header may have the header without its mutant.
                words = [word for word in words if word not in ("-Winvalid-pch", "-fpch-preprocess")]
                at = words.index("-include")
                del words[at:at + 2]
            output = words.index("-o") + 1
            objects.append(f"{self.trial}/{unit.replace('/', '_')}.o")
            link = link.replace(f" {words[output]} ", f" {objects[-1]} ")
            words[output] = objects[-1]
            if self.run(words).returncode:
                return False
        if link == self.link:
            library = self.build / "src"
            link = shlex.join(["c++", *objects, "-o", f"{self.trial}/tests", f"-L{library}", f"-Wl,-rpath,{library}",
                               "-lmoat", "-lgtest_main", "-lgtest"])
        return self.run(link, shell=True).returncode == 0

    def test(self, test, limit=None):
        """Runs the program `tests` of the trial, or that of the build with the library of the trial if there is one."""
        folder, _, chosen = test.partition(":")
        program = self.trial / "tests"
        if not program.exists():
            program = self.build / "tests" / folder / program_of(test)
        return self.run([program, "--gtest_fail_fast", "--gtest_brief=1", f"--gtest_filter={chosen or '*'}"],
                        timeout=limit, env={**os.environ, "LD_LIBRARY_PATH": str(self.trial)})

    @functools.cache
    def limits_of(self, tests, units):
        """Runs tests without a mutant, those in `units` alone if there are any. Returns the longest time of each with
        one, s."""
        shutil.rmtree(self.trial, ignore_errors=True)
        if units and not self.compile(units):
            sys.exit(f"{', '.join(units)}: these tests do not compile without a mutant")
        limits = []
        for test in tests:
            begin = time.monotonic()
            result = self.test(test)
            if result.returncode or not re.search(r"\[=+\] [1-9]\d* tests? (from .* )?ran", result.stdout):
                sys.exit(f"{test} does not pass without a mutant:\n{result.stdout[-2000:]}")
            limits.append(20.0 + 10.0 * (time.monotonic() - begin))
        return limits

    def verdict(self, mutant):
        tests_alone = mutant["units"] if mutant["units"][0].startswith("tests/") else []
        limits = self.limits_of(tuple(mutant["tests"]), tuple(tests_alone))
        file = self.source / mutant["file"]
        original, times = file.read_bytes(), file.stat()
        try:
            file.write_text(original.decode().replace(mutant["before"], mutant["after"]))
            if not self.compile(mutant["units"], mutant["file"]):
                return "does not compile"
        finally:
            file.write_bytes(original)
            os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))  # The build is not older than it.
        for test, limit in zip(mutant["tests"], limits):
            try:
                result = self.test(test, limit)
            except subprocess.TimeoutExpired:
                return f"killed by the time of {test}"
            if result.returncode:
                failed = re.search(r"FAILED  \] (\S+)", result.stdout)
                return f"killed by {failed[1].rstrip(',') if failed else f'exit code {result.returncode} of {test}'}"
        return "survived"


def main():
    given = arguments()
    mutants = all_mutants()
    unfit = [mutant for mutant in mutants if (checkout / mutant["file"]).read_text().count(mutant["before"]) != 1]
    for mutant in unfit:
        print(f"{mutant['file']} does not have this once: {mutant['before']}")
    if unfit or given.list:
        in_headers = sum(mutant["file"].endswith(".hpp") for mutant in mutants)
        print(f"{len(mutants)} mutants, {in_headers} of them in headers")
        return bool(unfit)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # The mutant is taken back.
    log = given.folder / "verdicts.jsonl"
    verdicts = {}
    if log.exists():
        verdicts = {entry["key"]: entry["verdict"] for entry in map(json.loads, log.read_text().splitlines())}
    chosen = [mutant for mutant in mutants if not given.words or any(word in text_of(mutant) for word in given.words)]
    to_try = [mutant for mutant in chosen if not is_expected(mutant, verdicts.get(key_of(mutant), "none"))]
    trials = Trials(given.folder, given.jobs)
    if to_try:
        trials.copy_checkout()
        trials.build_without_mutant(sorted({program_of(test) for mutant in to_try for test in mutant["tests"]
                                            if not mutant["units"][0].startswith("tests/")}))
    for mutant in to_try:
        begin, key = time.monotonic(), key_of(mutant)
        verdicts[key] = trials.verdict(mutant)
        seconds = round(time.monotonic() - begin)
        with log.open("a") as out:
            out.write(json.dumps({"key": key, "verdict": verdicts[key], "mutant": text_of(mutant), "seconds": seconds})
                      + "\n")
        print(f"{verdicts[key]} ({seconds} s): {text_of(mutant)}", flush=True)
    count = collections.Counter(kind_of(verdicts[key_of(mutant)])
                                + (", no result changes" if "unchanged" in mutant else "") for mutant in chosen)
    for kind, number in sorted(count.items()):
        print(f"{number:4} {kind}")
    changed = count["killed"] + count["survived"]
    if changed:
        print(f"{count['killed']} of {changed} mutants that change a result were killed: "
              f"{100 * count['killed'] / changed:.0f} %")
    bad = [mutant for mutant in chosen if not is_expected(mutant, verdicts[key_of(mutant)])]
    for mutant in bad:
        print(f"UNEXPECTED: {text_of(mutant)}")
    return bool(bad)


sys.exit(main())
