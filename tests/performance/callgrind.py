"""Instructions of one call, counted by valgrind's callgrind."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from symnav.bench.candidate import Candidate

FLAGS = ("-O2", "-std=gnu99", "-fno-math-errno")
CALLS = 8

_DRIVER = """
void {symbol}(const double *, double *);

static double in[{length}];
static double out[{size}];

int main(void)
{{
    for (int k = 0; k < {length}; ++k) {{
        in[k] = {first};
    }}
    {values}
    for (int k = 0; k < {calls}; ++k) {{
        {symbol}(in, out);
    }}
    return (out[0] == out[0]) ? 0 : 1;
}}
"""


def instructions(candidate: Candidate, record: list[float], folder: Path) -> float:
    """Instructions of one call, of what it calls as well, with the adapter around it."""
    folder.mkdir(parents=True, exist_ok=True)
    source, driver = folder / candidate.file, folder / "driver.c"
    source.write_text(candidate.source, encoding="utf-8")
    values = " ".join(f"in[{k}] = {value!r};" for k, value in enumerate(record))
    driver.write_text(
        _DRIVER.format(
            symbol=candidate.symbol, length=len(record), size=candidate.size, first=0.0,
            values=values, calls=CALLS,
        ),
        encoding="utf-8",
    )  # fmt: skip
    program, report = folder / "program", folder / "callgrind.out"
    include = [f"-I{place}" for place in candidate.include]
    command = ["gcc", *FLAGS, *include, str(source), str(driver), "-lm", "-o", str(program)]
    subprocess.run(command, check=True, capture_output=True)
    watched = [
        "valgrind", "--tool=callgrind", f"--callgrind-out-file={report}",
        f"--toggle-collect={candidate.symbol}", str(program),
    ]  # fmt: skip
    subprocess.run(watched, check=True, capture_output=True)
    found = re.search(r"^(?:summary|totals): (\d+)", report.read_text(), flags=re.MULTILINE)
    assert found is not None
    return int(found.group(1)) / CALLS


def compiler() -> str:
    """Name and major version of the compiler the budgets hold for."""
    done = subprocess.run(["gcc", "-dumpversion"], capture_output=True, text=True, check=True)
    machine = subprocess.run(["gcc", "-dumpmachine"], capture_output=True, text=True, check=True)
    return f"gcc {done.stdout.strip().partition('.')[0]} {machine.stdout.partition('-')[0]}"
