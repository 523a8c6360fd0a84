"""What the functions of a specification cost on this machine, and what has changed since."""

from __future__ import annotations

import json
import platform
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from symnav import ir
from symnav.bench.adapters import EPOCHS, Entries
from symnav.bench.candidate import Candidate
from symnav.bench.program import Array, Program, built, code_bytes, run, stack_bytes
from symnav.bench.quiet import Quiet, least_room
from symnav.lower.passes.counts import count_operations


@dataclass(frozen=True)
class Row:
    """One way to call one function.

    Attributes:
        function: its name.
        form: ``dense``, ``nonzeros`` or ``batch`` (per epoch).
        items: items of each call, or None.
        ns: median time of one evaluation.
        operations: arithmetic of one evaluation, guards not counted.
        code: bytes of machine code.
        stack: bytes of stack.
        change: time now over time at the last run with the same flags, or None.
        alone: True when the core did nothing else meanwhile, as far as that can be told.
    """

    function: str
    form: str
    items: int | None
    ns: float
    operations: int
    code: int
    stack: int
    change: float | None = None
    alone: bool = True


def measure(
    prefix: str,
    functions: Sequence[ir.Function],
    tree: Path,
    records: Mapping[str, Array],
    items: int,
    *,
    flags: str,
    folder: Path,
    repetitions: int,
    progress: Callable[[str], None],
) -> list[Row]:
    """Time every function of a generated tree.

    Args:
        prefix: of the tree's symbols.
        functions: to time; those without records are left out.
        tree: directory with ``include`` and ``src``.
        records: flat records of inputs by function.
        items: items of each call of a mapped function.
        flags: name of a flag set.
        folder: for what is compiled.
        repetitions: bursts of each form.
        progress: told each function.
    """
    rows: list[Row] = []
    quiet = Quiet(least_room(1.0, folder))
    for function in functions:
        if function.name not in records:
            continue
        progress(f"measure {function.name}")
        entries = Entries(prefix, function, tree, min(items, function.maximum or items))
        program = built(_forms(entries), flags, folder / function.name)
        filled = np.resize(records[function.name], (EPOCHS, entries.record))
        rows += _rows(function, entries, program, filled, repetitions, quiet)
    return rows


def compared(rows: Sequence[Row], file: Path, flags: str) -> list[Row]:
    """The rows with their change since the last run, which they replace.

    Args:
        rows: of this run.
        file: where the last run of the specification is kept.
        flags: runs of other flags or machines are not compared.
    """
    machine = f"{platform.machine()} {platform.processor()} {flags}"
    kept = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    before = {(r["function"], r["form"], r["items"]): r["ns"] for r in kept.get(machine, [])}
    found = []
    for row in rows:
        last = before.get((row.function, row.form, row.items))
        found.append(row if last is None else _changed(row, last))
    file.parent.mkdir(parents=True, exist_ok=True)
    kept[machine] = [asdict(row) for row in found]
    partial = file.with_name(f".{file.name}.partial")
    partial.write_text(json.dumps(kept, indent=2) + "\n", encoding="utf-8")
    partial.replace(file)
    return found


def _changed(row: Row, last: float) -> Row:
    return Row(**{**asdict(row), "change": round(row.ns / last, 3)})


def _forms(entries: Entries) -> list[Candidate]:
    jacobians = [o for o in entries.function.outputs if o.name.startswith("jacobian") and o.entries]
    forms = [entries.dense("dense")]
    forms += [entries.nonzeros("nonzeros")] if jacobians else []
    return [*forms, entries.batch("batch")]


def _rows(
    function: ir.Function,
    entries: Entries,
    program: Program,
    records: Array,
    repetitions: int,
    quiet: Quiet,
) -> list[Row]:
    taken = run(program, records, repetitions, quiet)
    mapped = function.maximum is not None
    return [
        Row(
            function.name,
            candidate.name,
            entries.count if mapped else None,
            taken.ns[candidate.name],
            count_operations(function).total(entries.count),
            code_bytes(candidate, item),
            stack_bytes(candidate, item),
            alone=taken.alone,
        )
        for candidate, item in zip(program.candidates, program.objects, strict=True)
    ]
