"""The kernel of a function: straight-line, single assignment, no branch, no memory of its own.

A guard never leaves the kernel early. It selects a harmless operand where the checked value is
outside its range and reports through the returned status, so that the arithmetic that follows is
defined for every input and the compiler may run several epochs or items side by side.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.expressions import HELPERS, SINUSOIDS, Level, Scope, Text, format_expression
from symnav.emit.c.inputs import INPUT_POINTER, ITEM_POINTER, Inputs, inputs_of
from symnav.emit.c.names import Names
from symnav.emit.c.pieces import Field, Routine, Struct, head
from symnav.emit.c.target import Target
from symnav.emit.c.walk import loads_of, operations_of, references_of

OUTPUT_POINTER = "out"
SHARED_POINTER = "shared"


@dataclass(frozen=True)
class Kernel:
    """Everything the entry points of one function need to know about its kernel.

    Attributes:
        target: the tree.
        function: what is emitted.
        symbol: C name of the function.
    """

    target: Target
    function: ir.Function
    symbol: str

    @property
    def local(self) -> str:
        """Leads the names of what is local to the function's own files.

        Without the prefix of the public symbols, such a name cannot be one of them.
        """
        return self.function.name

    @property
    def mapped(self) -> bool:
        """True when the function runs over items."""
        return self.function.maximum is not None

    @cached_property
    def inputs(self) -> Inputs:
        """Names and loaders of the inputs."""
        return inputs_of(self.function, self.target, _all_loads(self.function))

    @cached_property
    def results(self) -> tuple[ir.Output, ...]:
        """Outputs that have at least one structural non-zero, per item where mapped."""
        return tuple(
            output for output in self.function.outputs if output.entries and self._own(output)
        )

    @cached_property
    def common(self) -> tuple[ir.Output, ...]:
        """Outputs of a mapped function that do not depend on the item."""
        return tuple(
            output for output in self.function.outputs if output.entries and not self._own(output)
        )

    @cached_property
    def output_struct(self) -> Struct:
        """Structural non-zeros of the outputs."""
        scope = "one item of " if self.mapped else ""
        return Struct(
            f"{self.local}_output_t",
            f"Structural non-zeros of the results of {scope}{self.symbol}.",
            tuple(self._array(output) for output in self.results),
        )

    @cached_property
    def shared_struct(self) -> Struct:
        """What the items read of the part evaluated once per call."""
        fields = [Field(self.target.real, self._names[name]) for name in self._exported]
        fields += [Field(self.target.real, self.inputs.place(load)) for load in self._carried]
        fields += [self._array(output) for output in self.common]
        return Struct(
            f"{self.local}_shared_t",
            f"Results of {self.symbol} that all items share.",
            tuple(fields) if self.mapped else (),
        )

    @cached_property
    def structs(self) -> tuple[Struct, ...]:
        """Every structure the kernel file declares."""
        candidates = (
            self.inputs.struct(item=False),
            self.shared_struct,
            self.inputs.struct(item=True),
            self.output_struct,
        )
        return tuple(struct for struct in candidates if struct)

    @cached_property
    def main_reads_input(self) -> bool:
        """True when the part evaluated once per call reads any input."""
        entries = self._entries(self.common if self.mapped else self.results)
        return bool(self._carried or loads_of([*self.function.shared, *entries]))

    @cached_property
    def item_reads_input(self) -> bool:
        """True when the item part reads inputs that are not per item."""
        kept = self._item_loads - set(self._carried)
        return any(not self.inputs.is_per_item(load) for load in kept)

    @cached_property
    def item_reads_item(self) -> bool:
        """True when the item part reads inputs of its item."""
        return any(self.inputs.is_per_item(load) for load in self._item_loads)

    @cached_property
    def fallible(self) -> bool:
        """True when an evaluation can fail: something about it is checked."""
        function = self.function
        integers = any(argument.integer for argument in function.arguments)
        return function.checks_inputs or integers or self.shared_fails or self.item_fails

    @property
    def item_reads_shared(self) -> bool:
        """True when the item part reads results of the shared part."""
        return self.mapped and bool(self._exported or self._carried)

    @property
    def shared_fails(self) -> bool:
        """True when the part evaluated once per call checks something."""
        return self._can_fail(self.function.shared)

    @property
    def item_fails(self) -> bool:
        """True when the part evaluated once per item checks something."""
        return self._can_fail(self.function.item)

    @property
    def item_is_told(self) -> bool:
        """True when the item part is told whether an item has passed: there are two passes."""
        return self.mapped and self.function.items is ir.Items.REJECT and self.item_fails

    def _can_fail(self, steps: Iterable[ir.Step]) -> bool:
        """True when something in a body is checked."""
        checks = (step for step in steps if isinstance(step, ir.Check))
        return self.function.checks_domain and any(checks)

    @cached_property
    def slots(self) -> tuple[ir.Load, ...]:
        """Elements that place a non-zero at run time, of all outputs."""
        found: dict[ir.Load, None] = {}
        for output in self.function.outputs:
            found.update(dict.fromkeys(slots_of(output)))
        return tuple(found)

    def routines(self) -> list[Routine]:
        """Loaders and kernels, in the order they are called."""
        loaders = [self.inputs.loader(item=False)]
        if not self.mapped:
            return [*loaders, self._single()]
        return [*loaders, self._shared(), self.inputs.loader(item=True), self._item()]

    @property
    def is_trigonometric(self) -> bool:
        """True when the kernel file calls a sine or a cosine of the tree."""
        return not self._operations.isdisjoint(SINUSOIDS)

    def helpers(self) -> set[str]:
        """Names of the inline helpers of the check file the kernel file calls."""
        function = self.function
        steps = [*function.shared, *function.item]
        names = {HELPERS[operation] for operation in self._operations if operation in HELPERS}
        if self._can_fail(steps):
            names.add("is_within")
        if self.item_is_told:
            names.add("guarded")
        return names | self.inputs.helpers()

    def _own(self, output: ir.Output) -> bool:
        return output.item or not self.mapped

    def _array(self, output: ir.Output) -> Field:
        return Field(self.target.real, output.name, str(len(output.entries)))

    @cached_property
    def _operations(self) -> set[ir.Operation]:
        """Operations that occur anywhere in the function."""
        function = self.function
        steps = [*function.shared, *function.item]
        return operations_of([*steps, *self._entries(function.outputs)])

    @staticmethod
    def _entries(outputs: Iterable[ir.Output]) -> list[ir.Entry]:
        return [entry for output in outputs for entry in output.entries]

    @cached_property
    def _item_loads(self) -> set[ir.Load]:
        """Elements the item part reads."""
        holders = [*self.function.item, *self._entries(self.results)]
        return loads_of(holders) if self.mapped else set()

    @cached_property
    def _carried(self) -> tuple[ir.Load, ...]:
        """Inputs of the call, read where the caller keeps them, that the items read.

        A loop reads them from the shared part: a compiler does not turn a choice into arithmetic
        where it would read the caller's memory on one side only.
        """
        read = self._item_loads & self.inputs.pointed
        return tuple(load for load in self.inputs.table if load in read)

    @cached_property
    def _exported(self) -> tuple[str, ...]:
        """Targets of the shared part that the item part reads."""
        wanted = references_of([*self.function.item, *self._entries(self.results)])
        return tuple(step.target for step in self.function.shared if step.target in wanted)

    @cached_property
    def _names(self) -> dict[str, str]:
        """C identifiers of every step."""
        taken = [INPUT_POINTER, ITEM_POINTER, OUTPUT_POINTER, SHARED_POINTER]
        taken += [output.name for output in self.function.outputs]
        taken += [self.inputs.place(load) for load in self.inputs.pointed]
        names = Names(taken)
        steps = (*self.function.shared, *self.function.item)
        return {step.target: names.claim(step.target) for step in steps}

    @cached_property
    def _guard_names(self) -> dict[str, tuple[str, str]]:
        """For every check, the names of its candidate and of its verdict."""
        names = Names([*self._names.values(), INPUT_POINTER, OUTPUT_POINTER])
        checks = [
            step
            for step in (*self.function.shared, *self.function.item)
            if isinstance(step, ir.Check)
        ]
        return {
            check.target: (
                names.claim(f"{self._names[check.target]}_raw"),
                names.claim(f"{self._names[check.target]}_ok"),
            )
            for check in checks
        }

    def _scope(self, *, item: bool) -> Scope:
        exported = frozenset(self._exported) if item else frozenset()

        def reference(name: str) -> str:
            local = self._names[name]
            return f"{SHARED_POINTER}->{local}" if name in exported else local

        def load(element: ir.Load) -> Text:
            place = self.inputs.place(element)
            if item and element in self._carried:
                return Text(f"{SHARED_POINTER}->{place}")
            if self.inputs.is_integer(element):
                return Text(f"({self.target.real}){place}", Level.SIGN)
            return Text(place)

        return Scope(self.target, reference, load)

    def _single(self) -> Routine:
        given = self._input_declaration(self.main_reads_input)
        declarations = [*given, f"{self.output_struct.name} *{OUTPUT_POINTER}"]
        scope = self._scope(item=False)
        seen: set[ir.Load] = set()
        body = [
            *self._steps(self.function.shared, scope, seen),
            *self._assignments(self.results, OUTPUT_POINTER, scope, seen),
            *self._verdict(self.function.shared),
        ]
        return Routine(
            brief=f"{self.function.title}: values and structural non-zeros.",
            head=self._head("kernel", declarations),
            body=tuple(body),
        )

    def _shared(self) -> Routine:
        declarations = self._input_declaration(self.main_reads_input)
        if self.shared_struct:
            declarations.append(f"{self.shared_struct.name} *{SHARED_POINTER}")
        scope = self._scope(item=False)
        exported = [self._names[name] for name in self._exported]
        exported += [self.inputs.place(load) for load in self._carried]
        exports = [f"    {SHARED_POINTER}->{local} = {local};" for local in exported]
        seen: set[ir.Load] = set()
        body = [
            *self._steps(self.function.shared, scope, seen),
            *self.inputs.readings(self._carried, seen),
            *([""] if exports and self.function.shared else []),
            *exports,
            *self._assignments(self.common, SHARED_POINTER, scope, seen),
            *self._verdict(self.function.shared),
        ]
        return Routine(
            brief=f"{self.function.title}: the part that is the same for all items.",
            head=self._head("shared", declarations),
            body=tuple(body),
        )

    def _item(self) -> Routine:
        declarations = self._input_declaration(self.item_reads_input)
        if self.item_reads_shared:
            declarations.append(f"const {self.shared_struct.name} *{SHARED_POINTER}")
        if self.item_reads_item:
            declarations.append(f"const {self.inputs.struct(item=True).name} *{ITEM_POINTER}")
        declarations.append(f"{self.output_struct.name} *{OUTPUT_POINTER}")
        declarations += ["bool passed"] if self.item_is_told else []
        scope = self._scope(item=True)
        seen = set(self._carried)
        body = [
            *self._steps(self.function.item, scope, seen, told=self.item_is_told),
            *self._assignments(self.results, OUTPUT_POINTER, scope, seen),
            *self._verdict(self.function.item),
        ]
        return Routine(
            brief=f"{self.function.title}: one item.",
            head=self._head("item", declarations),
            body=tuple(body),
        )

    def _head(self, suffix: str, declarations: Sequence[str]) -> tuple[str, ...]:
        result = f"{self.target.macro}_INLINE flag_t"
        return head(result, f"{self.local}_{suffix}", declarations)

    def _input_declaration(self, wanted: bool) -> list[str]:
        struct = self.inputs.struct(item=False)
        return [f"const {struct.name} *{INPUT_POINTER}"] if wanted else []

    def _steps(
        self, steps: Sequence[ir.Step], scope: Scope, seen: set[ir.Load], *, told: bool = False
    ) -> Iterator[str]:
        for step in steps:
            yield from self.inputs.readings(loads_of([step]), seen)
            if isinstance(step, ir.Check):
                yield from self._guard(step, scope, told=told)
            else:
                text = format_expression(step.value, scope)
                yield from comments.code(
                    f"const {self.target.real} {self._names[step.target]} = {text};",
                    remark=step.comment,
                )

    def _guard(self, check: ir.Check, scope: Scope, *, told: bool) -> list[str]:
        """Select and flag, unless it is told that all has passed before."""
        real, target = self.target.real, self._names[check.target]
        value = format_expression(check.value, scope)
        if not self.function.checks_domain:
            return comments.code(f"const {real} {target} = {value};", remark=check.comment)
        raw, verdict = self._guard_names[check.target]
        low, high = self.target.bounds(check.lower, check.upper)
        described = check.comment.strip()
        lines = [f"    {line}" for line in comments.block(described, 96)] if described else []
        if not isinstance(check.value, ir.Ref):
            lines += comments.code(f"const {real} {raw} = {value};")
            value = raw
        within = f"is_within({value}, {low}, {high})"
        lines += comments.code(f"const bool {verdict} = {within};")
        substitute = self.target.literal(check.substitute)
        chosen = f"{verdict} ? {value} : {substitute}"
        if told:
            chosen = f"guarded({value}, {verdict}, passed, {substitute})"
        return [*lines, *comments.code(f"const {real} {target} = {chosen};")]

    def _assignments(
        self, outputs: Sequence[ir.Output], pointer: str, scope: Scope, seen: set[ir.Load]
    ) -> Iterator[str]:
        for output in outputs:
            yield ""
            for position, entry in enumerate(output.entries):
                yield from self.inputs.readings(loads_of([entry]), seen)
                text = format_expression(entry.value, scope)
                yield from comments.code(
                    f"{pointer}->{output.name}[{position}] = {text};",
                    remark=entry_label(output, entry),
                )

    def _verdict(self, steps: Sequence[ir.Step]) -> list[str]:
        """Return the status of the first check that failed."""
        checks = [step for step in steps if isinstance(step, ir.Check)]
        runs = [(status, list(run)) for status, run in groupby(checks, lambda check: check.status)]
        text = self.target.flag(ir.Status.OK)
        for status, run in reversed(runs if self.function.checks_domain else []):
            passed = " && ".join(self._guard_names[check.target][1] for check in run)
            passed = f"({passed})" if len(run) > 1 else passed
            success = f"({text})" if "?" in text else text
            text = f"{passed} ? {success} : {self.target.flag(status)}"
        return ["", *comments.code(f"return {text};")]


def slots_of(output: ir.Output) -> tuple[ir.Load, ...]:
    """Elements that place a non-zero of an output at run time."""
    found = {
        index.slot: None
        for entry in output.entries
        for index in entry.index
        if isinstance(index, ir.Offset)
    }
    return tuple(found)


def entry_label(output: ir.Output, entry: ir.Entry) -> str:
    """Where a non-zero stands, in words."""
    single = (output.columns or output.rows,)
    axes = (output.rows, output.columns) if len(entry.index) > 1 else single
    labels = [_axis_label(index, axis) for index, axis in zip(entry.index, axes, strict=False)]
    return ", ".join(labels)


def _axis_label(index: int | ir.Offset, sections: Sequence[ir.Section]) -> str:
    position = index.base if isinstance(index, ir.Offset) else index
    for section in sections:
        if section.start <= position < section.start + section.size:
            label = section.labels[position - section.start] if section.labels else ""
            name = f"{section.name} {label}".strip() if section.size > 1 else section.name
            break
    else:
        name = str(position)
    return f"{name} + {index.slot.argument}" if isinstance(index, ir.Offset) else name


def _all_loads(function: ir.Function) -> set[ir.Load]:
    entries = [entry for output in function.outputs for entry in output.entries]
    loads = loads_of([*function.shared, *function.item, *entries])
    for output in function.outputs:
        loads |= set(slots_of(output))
    return loads
