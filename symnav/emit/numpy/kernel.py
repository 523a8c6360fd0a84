"""The kernel of a function: straight-line Python over the elements of its arguments."""

from __future__ import annotations

import keyword
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass

from symnav import ir
from symnav.emit.numpy.expressions import Scope, Text, number, text_of
from symnav.emit.python.shapes import argument_of, is_scalar, signature_name, slot_range
from symnav.emit.python.text import assignment, call, deletion, lay_out, tuple_of

_NAMES = ("xp", "guards")
_HANDFUL = 6


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
    """Lay out the kernel of a function.

    What is evaluated once comes first; the part of one item is a function inside it, so that it
    can run for all items at once or item by item.
    """
    writer = _Writer(function)
    mapped = function.maximum is not None
    name = f"_{function.name}_kernel"
    parameters = [_parameter(argument) for argument in function.arguments if not argument.item]
    head = call(name, "xp: Any", "guards: _arrays.Guards", *parameters)
    returned = "_arrays.Mapped" if mapped else "_arrays.Nonzeros"
    array_function = call("_arrays.ArrayFunction", signature_name(function), name)
    public = call("_calls.publish", array_function, "__name__")
    return Kernel(
        tuple(lay_out(head, before="def ", after=f" -> {returned}:")),
        tuple(writer.mapped() if mapped else writer.plain()),
        tuple(lay_out(public, before=f"{function.name} = ")),
    )


def _parameter(argument: ir.Argument) -> str:
    return f"{argument.name}: Any"


class _Writer:
    """Names the locals of one kernel and writes its lines in order."""

    def __init__(self, function: ir.Function) -> None:
        self._function = function
        self._taken = {*_NAMES, *(argument.name for argument in function.arguments)}
        self._elements: dict[ir.Load, str] = {}
        self._references: dict[str, Text] = {}
        self._scope = Scope(self._references, lambda load: self._elements[load])
        self._depth = 1

    def plain(self) -> Iterator[str]:
        """The body of a function that is not mapped over items."""
        yield from self._loads(items=False)
        steps = (*self._function.shared, *self._function.item)
        yield from self._steps(steps, "check", _read_by(self._function.outputs))
        yield from self._results(self._function.outputs)

    def mapped(self) -> Iterator[str]:
        """The shared part, the part of an item as a function, and both returned."""
        outputs = self._function.outputs
        item = self._claim("item")
        read = _read_by(outputs)
        in_items = {name for step in self._function.item for name in _names(step.value)}
        yield from self._loads(items=False)
        yield from self._steps(self._function.shared, "check", read | in_items)
        yield ""
        parameters = [
            _parameter(argument) for argument in self._function.arguments if argument.item
        ]
        head = call(item, *parameters)
        yield from lay_out(head, before="def ", after=" -> _arrays.Nonzeros:", depth=1)
        self._depth = 2
        yield from self._loads(items=True)
        yield from self._steps(self._function.item, "check_item", read)
        yield from self._results([output for output in outputs if output.item])
        self._depth = 1
        yield ""
        yield from self._results([output for output in outputs if not output.item], f", {item}")

    def _loads(self, *, items: bool) -> Iterator[str]:
        """One local for every element that is read, of the items' arguments or of the others."""
        used = dict.fromkeys(_loads(self._function))
        for argument in self._function.arguments:
            for domain in argument.domains:
                for place in range(domain.size):
                    load = ir.Load(argument.name, domain.start + place)
                    if argument.item == items and load in used:
                        yield from self._load(argument, domain, place, load)
        for load in used:
            if isinstance(load.index, ir.Offset) and self._of_item(load) == items:
                yield from self._pick(load, load.index)

    def _of_item(self, load: ir.Load) -> bool:
        """True where an item's argument is read, or chooses what is read."""
        chooser = isinstance(load.index, ir.Offset) and self._of_item(load.index.slot)
        return chooser or argument_of(self._function, load.argument).item

    def _steps(self, steps: Sequence[ir.Step], check: str, kept: Collection[str]) -> Iterator[str]:
        """Statements and guards; names that nothing reads any more are deleted by the handful.

        Args:
            steps: in order.
            check: the method that guards.
            kept: targets that are read after these steps.
        """
        last = {name: place for place, step in enumerate(steps) for name in _names(step.value)}
        dead: list[str] = []
        for place, step in enumerate(steps):
            yield from self._step(step, check)
            targets = (step.target for step in steps[:place])
            dead += [name for name in targets if last.get(name) == place and name not in kept]
            dead = [name for name in dead if self._references[name].number is None]
            if len(dead) >= _HANDFUL:
                names = [self._references[name].text for name in dead]
                yield from deletion(names, depth=self._depth)
                dead = []

    def _step(self, step: ir.Step, check: str) -> Iterator[str]:
        value = text_of(step.value, self._scope)
        if isinstance(step, ir.Check) and self._function.checks_domain:
            target = self._claim(step.target)
            yield from self._guard(step, target, value.text, check)
            self._references[step.target] = Text(target)
        elif value.number is not None:
            self._references[step.target] = value
        else:
            target = self._claim(step.target)
            yield from assignment(target, value.text, depth=self._depth, remark=step.comment)
            self._references[step.target] = Text(target)

    def _results(self, outputs: Iterable[ir.Output], after: str = "") -> Iterator[str]:
        """The structural non-zeros, one tuple for each output."""
        found = [
            tuple_of(text_of(entry.value, self._scope).text for entry in output.entries)
            for output in outputs
        ]
        yield from lay_out(tuple_of(found), before="return ", after=after, depth=self._depth)

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
        yield from assignment(name, f"{argument.name}[{load.index}]", depth=self._depth)

    def _pick(self, load: ir.Load, offset: ir.Offset) -> Iterator[str]:
        """An element that a run-time index chooses."""
        argument = argument_of(self._function, load.argument)
        domain = next(d for d in argument.domains if d.start <= offset.base < d.start + d.size)
        name = self._claim(f"{domain.name}_of_item")
        self._elements[load] = name
        slot = self._elements[offset.slot]
        ends = map(str, slot_range(self._function, offset, argument.size))
        parts = [load.argument, str(offset.base), slot, *ends]
        yield from lay_out(call("guards.pick", *parts), before=f"{name} = ", depth=self._depth)

    def _guard(self, check: ir.Check, target: str, value: str, method: str) -> Iterator[str]:
        bounds = [number(bound).text for bound in (check.lower, check.upper, check.substitute)]
        status = f"_runtime.Status.{check.status.name}"
        guard = call(f"guards.{method}", value, *bounds, status)
        indent = "    " * self._depth
        yield from (f"{indent}# {line}" for line in filter(None, [check.comment.strip()]))
        yield from lay_out(guard, before=f"{target} = ", depth=self._depth)

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


def _read_by(outputs: Iterable[ir.Output]) -> set[str]:
    """Targets of steps that outputs read."""
    entries = (entry for output in outputs for entry in output.entries)
    return {name for entry in entries for name in _names(entry.value)}


def _names(expression: ir.Expression) -> Iterator[str]:
    """Targets of steps that an expression reads."""
    return (node.name for node in _nodes([expression]) if isinstance(node, ir.Ref))


def _nodes(pending: list[ir.Expression]) -> Iterator[ir.Expression]:
    """Expressions and everything below them."""
    while pending:
        node = pending.pop()
        yield node
        if isinstance(node, ir.Call):
            pending.extend(node.operands)


def _loads(function: ir.Function) -> Iterator[ir.Load]:
    """Every element the arithmetic reads; slots are read where results are put together."""
    pending: list[ir.Expression] = [step.value for step in (*function.shared, *function.item)]
    pending += [entry.value for output in function.outputs for entry in output.entries]
    for node in _nodes(pending):
        if isinstance(node, ir.Load):
            yield node
            pending += [node.index.slot] if isinstance(node.index, ir.Offset) else []
