"""Compares the time that a run tells to be left with that which it then takes.

    python3 test/benchmarks/progress_times.py COMMAND...

COMMAND makes a map; `OUT` in it becomes a fresh folder. It runs twice on a pseudo terminal: with an
empty cache, so that nothing is known of earlier runs, and with that which the first run has left.
Printed are told time / true time at 25, 50 and 75 % of the run, and the longest time without a
change on the terminal and without progress from the library. The machine should be idle.
"""

import json
import os
import re
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "python"))

from on_terminal import shown_by

TOLD = re.compile(r"(?:(\d+) min )?(\d+) s left")


def told_at(shown, seconds):
    """The time that was last told to be left, less what has passed since, or None."""
    told = None
    for at, text in shown:
        if at > seconds:
            break
        for minutes, rest in TOLD.findall(text):
            told = 60 * int(minutes or 0) + int(rest)
    return told


def longest_gap(shown, all_seconds):
    times = [0] + [at for at, _ in shown] + [all_seconds]
    return max(after - before for before, after in zip(times, times[1:]))


def row_of(command, environment, folder):
    run = [part.replace("OUT", folder) for part in command]
    code, seconds, shown = shown_by(run, environment)
    if code != 0:
        sys.exit(f"{' '.join(run)}: ended with {code}\n{''.join(text for _, text in shown)}")
    cells = []
    for share in (0.25, 0.5, 0.75):
        told = told_at(shown, share * seconds)
        cells.append("–" if told is None else f"{told / ((1 - share) * seconds):.2f}")
    with open(f"{folder}/report.json", encoding="utf-8") as file:
        silence = json.load(file)["seconds_without_progress"]
    return (f"{seconds:.1f} s | {' | '.join(cells)} | {longest_gap(shown, seconds):.1f} s | "
            f"{silence['seconds']:.1f} s, {silence['step']}")


def main(command):
    if not command:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, XDG_CACHE_HOME=f"{folder}/cache", TERM="xterm")
        print("| run | took | told / true at 25 % | 50 % | 75 % | longest still | without progress |")
        print("|---|---|---|---|---|---|---|")
        for run in ("first", "second"):
            print(f"| {run} | {row_of(command, environment, f'{folder}/{run}')} |", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
