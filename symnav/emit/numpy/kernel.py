"""The kernel of a function: straight-line Python over the elements of its arguments."""

from __future__ import annotations

import keyword
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from symnav import ir
from symnav.emit.numpy.expressions import Scope, Text, number, text_of
from symnav.emit.python.shapes import argument_of, is_scalar, signature_name, slot_range
from symnav.emit.python.text import assignment, call, lay_out, tuple_of

_NAMES = ("xp", "guards")


@dataclass(frozen=True, slots=True)
class Kernel:
    """What the template of the back end says about one function.

    Attributes:
        head: lines of the head of the kernel.
        body: lines of its body.
        public: lines that define the public function.
    """

    head: tuple[str, ...]
    body: tuple[str, ...]
    public: tuple[str, ...]


def kernel_of(function: ir.Function) -> Kernel:
    """Lay out the kernel of a function."""
    writer = _Writer(function)
    body = [
        *writer.loads(),
        *writer.steps(function.shared, "check"),
        *writer.steps(function.item, "check_item"),
        *writer.results(),
    ]
    name = f"_{function.name}_kernel"
    parameters = [f"{argument.name}: Any" for argument in function.arguments]
    head = call(name, "xp: Any", "guards: _arrays.Guards", *parameters)
    array_function = call("_arrays.ArrayFunction", signature_name(function), name)
    public = call("_calls.publish", array_function, "__name__")
    return Kernel(
        tuple(lay_out(head, before="def ", after=" -> _arrays.Nonzeros:")),
        tuple(body),
        tuple(lay_out(public, before=f"{function.name} = ")),
    )


class _Writer:
    """Names the locals of one kernel and writes its lines in order."""

    def __init__(self, function: ir.Function) -> None:
        self._function = function
        self._taken = {*_NAMES, *(argument.name for argument in function.arguments)}
        self._elements: dict[ir.Load, str] = {}
        self._references: dict[str, Text] = {}
        self._scope = Scope(self._references, lambda load: self._elements[load])

    def loads(self) -> Iterator[str]:
        """One local for every element that is read."""
        used = dict.fromkeys(_loads(self._function))
        for argument in self._function.arguments:
            for domain in argument.domains:
                for place in range(domain.size):
                    load = ir.Load(argument.name, domain.start + place)
                    if load in used:
                        yield from self._load(argument, domain, place, load)
        for load in used:
            if isinstance(load.index, ir.Offset):
                yield from self._pick(load, load.index)

    def steps(self, steps: Iterable[ir.Step], check: str) -> Iterator[str]:
        """Statements and guards."""
        for step in steps:
            value = text_of(step.value, self._scope)
            if isinstance(step, ir.Check) and self._function.guarded:
                target = self._claim(step.target)
                yield from self._guard(step, target, value.text, check)
                self._references[step.target] = Text(target)
            elif value.number is not None:
                self._references[step.target] = value
            else:
                target = self._claim(step.target)
                yield from assignment(target, value.text, remark=step.comment)
                self._references[step.target] = Text(target)

    def results(self) -> Iterator[str]:
        """The structural non-zeros, one tuple for each output."""
        outputs = [
            tuple_of(text_of(entry.value, self._scope).text for entry in output.entries)
            for output in self._function.outputs
        ]
        yield from lay_out(tuple_of(outputs), before="return ", depth=1)

    def _load(
        self, argument: ir.Argument, domain: ir.Domain, place: int, load: ir.Load
    ) -> Iterator[str]:
        if is_scalar(self._function, argument):
            self._elements[load] = argument.name
            return
        words = [domain.name]
        if len(argument.domains) > 1 and argument.name != "x":
            words.insert(0, argument.name)
        if domain.size > 1:
            words.append(domain.labels[place].strip() or str(place))
        name = self._claim("_".join(words))
        self._elements[load] = name
        yield f"    {name} = {argument.name}[..., {load.index}]"

    def _pick(self, load: ir.Load, offset: ir.Offset) -> Iterator[str]:
        """An element that a run-time index chooses."""
        argument = argument_of(self._function, load.argument)
        domain = next(d for d in argument.domains if d.start <= offset.base < d.start + d.size)
        name = self._claim(f"{domain.name}_of_item")
        self._elements[load] = name
        slot = self._elements[offset.slot]
        ends = map(str, slot_range(self._function, offset, argument.size))
        parts = [load.argument, str(offset.base), slot, *ends]
        yield from lay_out(call("guards.pick", *parts), before=f"{name} = ", depth=1)

    def _guard(self, check: ir.Check, target: str, value: str, method: str) -> Iterator[str]:
        bounds = [number(bound).text for bound in (check.lower, check.upper, check.substitute)]
        status = f"_runtime.Status.{check.status.name}"
        guard = call(f"guards.{method}", value, *bounds, status)
        yield from (f"    # {line}" for line in filter(None, [check.comment.strip()]))
        yield from lay_out(guard, before=f"{target} = ", depth=1)

    def _claim(self, wish: str) -> str:
        """A local of the nearest free name."""
        stem = "".join(letter if letter.isalnum() else "_" for letter in wish)
        stem = stem if stem.isidentifier() and not keyword.iskeyword(stem) else f"{stem}_"
        stem = stem if stem.isidentifier() else f"v_{stem}"
        name, count = stem, 2
        while name in self._taken:
            name, count = f"{stem}_{count}", count + 1
        self._taken.add(name)
        return name


def _loads(function: ir.Function) -> Iterator[ir.Load]:
    """Every element the arithmetic reads; slots are read where results are put together."""
    pending: list[ir.Expression] = [step.value for step in (*function.shared, *function.item)]
    pending += [entry.value for output in function.outputs for entry in output.entries]
    while pending:
        node = pending.pop()
        if isinstance(node, ir.Load):
            yield node
            pending += [node.index.slot] if isinstance(node.index, ir.Offset) else []
        elif isinstance(node, ir.Call):
            pending.extend(node.operands)
