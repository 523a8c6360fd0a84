"""Inputs of a function: which elements its kernel reads, what they are called, how they load.

Loading copies every element the kernel reads into a structure and checks every element that was
declared. A copy is inside its range whatever the caller passed, so that nothing downstream sees
a NaN, and a caller that lets an input and an output overlap by mistake cannot corrupt a result.

Where nothing is checked, what is read once per call stays with the caller: the structure holds
where it is, and the kernel reads every element where it is first needed. A compiler that meets
all the copies first keeps more of them than a processor has registers.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.literals import integer_bounds
from symnav.emit.c.names import Names, identifier
from symnav.emit.c.pieces import Field, Routine, Struct, head
from symnav.emit.c.slots import Span, reach, spans_of
from symnav.emit.c.target import Target

INPUT_POINTER = "in"
ITEM_POINTER = "item"

# Locals and parameters of the storing functions, which also carry names of elements.
_LOCALS = ("stride", "dense", "nonzeros", "reference", "k")


@dataclass(frozen=True, slots=True)
class Element:
    """One element of an argument, with its domain and the field that holds its copy.

    Where a slot chooses among neighbours, the field is an array and ``span`` says of which.
    """

    argument: ir.Argument
    domain: ir.Domain
    index: int
    field: str
    span: Span | None = None

    @property
    def load(self) -> ir.Load:
        """What refers to it."""
        return ir.Load(self.argument.name, self.index)

    @property
    def lower(self) -> float:
        """Lower end of its range."""
        return self.domain.lower[self.index - self.domain.start]

    @property
    def upper(self) -> float:
        """Upper end of its range."""
        return self.domain.upper[self.index - self.domain.start]

    @property
    def label(self) -> str:
        """Its label inside the domain."""
        return self.domain.labels[self.index - self.domain.start]


@dataclass(frozen=True)
class Inputs:
    """Every element of every argument, and which of them are copied.

    Attributes:
        target: the tree.
        name: of the function.
        table: the elements, in the order of the interface.
        copied: those that loading copies.
        pointed: those a kernel reads from where the caller keeps them, into a local.
        chosen: for a load by a run-time slot, the array it chooses from.
        guarded: True when every element is checked.
    """

    target: Target
    name: str
    table: Mapping[ir.Load, Element]
    copied: frozenset[ir.Load]
    pointed: frozenset[ir.Load]
    chosen: Mapping[ir.Load, Span]
    guarded: bool

    @cached_property
    def elements(self) -> tuple[Element, ...]:
        """Every element, in the order of the interface."""
        return tuple(self.table.values())

    def place(self, load: ir.Load, *, pointers: bool = True) -> str:
        """C text of the copy of an element, through a pointer or in a local structure."""
        if isinstance(load.index, ir.Offset):
            return self._chosen(load, load.index, pointers=pointers)
        element = self.table[load]
        if load in self.pointed:
            return element.field
        base = ITEM_POINTER if element.argument.item else INPUT_POINTER
        place = f"[{element.index - element.span.start}]" if element.span else ""
        return f"{base}{'->' if pointers else '.'}{element.field}{place}"

    def readings(self, loads: Iterable[ir.Load], seen: set[ir.Load]) -> list[str]:
        """Statements that read, of some loads, those not read before; ``seen`` grows."""
        new = (self.pointed & set(loads)) - seen
        seen |= new
        return [
            line
            for load, element in self.table.items()
            if load in new
            for line in comments.code(
                f"const {self.target.real} {element.field} = "
                f"{INPUT_POINTER}->{self._pointers[element.argument.name]}[{element.index}];",
                remark=_where(element.domain),
            )
        ]

    def is_per_item(self, load: ir.Load) -> bool:
        """True for an element of an argument that has one row per item."""
        return self._argument_of[load.argument].item

    def is_integer(self, load: ir.Load) -> bool:
        """True for an element of an integer argument."""
        return self._argument_of[load.argument].integer

    def struct(self, *, item: bool) -> Struct:
        """The structure of the copies of one call, or of one item."""
        pointers = [] if item else self._pointers.values()
        fields = dict.fromkeys(Field(f"const {self.target.real}", f"*{p}") for p in pointers)
        fields |= dict.fromkeys(
            Field(
                type="int32_t" if element.argument.integer else self.target.real,
                name=element.field,
                length=str(element.span.stop - element.span.start) if element.span else "",
                remark=_where(element.domain),
            )
            for element in self._copied(item=item)
        )
        kind, scope = ("item", "one item of ") if item else ("input", "")
        brief = f"Inputs of {scope}{self.name} as its kernel reads them"
        state = ", each finite and inside its declared range." if self.guarded else ", unchecked."
        return Struct(f"{self.name}_{kind}_t", brief + state, tuple(fields))

    def loader(self, *, item: bool) -> Routine:
        """The function that checks and copies the inputs of one call, or of one item."""
        struct = self.struct(item=item)
        pointer = ITEM_POINTER if item else INPUT_POINTER
        arguments = [argument for argument in self.arguments if argument.item is item]
        declarations = [self.declaration(argument) for argument in arguments]
        if struct:
            declarations.append(f"{struct.name} *{pointer}")
        name = f"{self.name}_load{'_item' if item else ''}"
        deed = "Check and copy" if self.guarded or self.copied else "Point at"
        return Routine(
            brief=f"{deed} the inputs of {'one item' if item else 'one call'}.",
            head=head(f"{self.target.macro}_INLINE flag_t", name, declarations),
            body=tuple(self._loading(arguments)),
        )

    def declaration(self, argument: ir.Argument) -> str:
        """An argument as a parameter of unspecified length."""
        kind = "int32_t" if argument.integer else self.target.real
        return f"const {kind} {argument.name}[]"

    @cached_property
    def arguments(self) -> tuple[ir.Argument, ...]:
        """The arguments, in the order of the interface."""
        return tuple(self._argument_of.values())

    @cached_property
    def _argument_of(self) -> dict[str, ir.Argument]:
        """The arguments by name; a name is compared faster than a whole record."""
        return {element.argument.name: element.argument for element in self.elements}

    def helpers(self) -> set[str]:
        """Names of the check functions the loaders call."""
        names: set[str] = set()
        for element in self.elements:
            if not (self.guarded or element.argument.integer):
                continue
            take, test, _ = self._range_check(element)
            names.add(take if self._is_copied(element) else test)
            if self.guarded and element.domain.kind in (ir.Kind.QUATERNION, ir.Kind.MATRIX):
                names.add(f"is_skewed_{element.domain.kind.value}")
        return names

    @cached_property
    def _pointers(self) -> dict[str, str]:
        """Fields that hold where arguments are, by the names of the arguments."""
        names = Names(self.table[load].field for load in self.copied)
        given = {load.argument for load in self.pointed}
        return {name: names.claim(name) for name in self._argument_of if name in given}

    def _chosen(self, load: ir.Load, offset: ir.Offset, *, pointers: bool) -> str:
        """The copy that a slot chooses."""
        span = self.chosen[load]
        first = self.table[ir.Load(load.argument, span.start)]
        base = ITEM_POINTER if first.argument.item else INPUT_POINTER
        slot = self.place(offset.slot, pointers=pointers)
        distance = offset.base - span.start
        index = f"{slot} {'+' if distance > 0 else '-'} {abs(distance)}" if distance else slot
        return f"{base}{'->' if pointers else '.'}{first.field}[{index}]"

    def _is_copied(self, element: Element) -> bool:
        return element.load in self.copied

    def _copied(self, *, item: bool) -> Iterator[Element]:
        for element in self.elements:
            if element.argument.item is item and self._is_copied(element):
                yield element

    def _loading(self, arguments: list[ir.Argument]) -> Iterator[str]:
        ranged = self.guarded or any(argument.integer for argument in arguments)
        skewed = self.guarded and any(
            domain.kind in (ir.Kind.QUATERNION, ir.Kind.MATRIX)
            for argument in arguments
            for domain in argument.domains
        )
        if ranged and arguments:
            yield "    flag_t outside = 0U;"
        if skewed:
            yield "    flag_t skewed = 0U;"
        for argument in arguments:
            if argument.name in self._pointers:
                yield f"    {INPUT_POINTER}->{self._pointers[argument.name]} = {argument.name};"
            for domain in argument.domains:
                yield from self._loading_domain(argument, domain)
        yield ""
        yield from self._verdict(ranged=ranged and bool(arguments), skewed=skewed)

    def _loading_domain(self, argument: ir.Argument, domain: ir.Domain) -> Iterator[str]:
        if domain.kind is ir.Kind.UNREAD:
            return
        lines: list[str] = []
        for index in range(domain.start, domain.start + domain.size):
            lines += self._loading_element(self.table[ir.Load(argument.name, index)])
        if lines:
            yield ""
            yield _comment(domain)
            yield from lines
        if self.guarded and domain.kind in (ir.Kind.QUATERNION, ir.Kind.MATRIX):
            yield from self._checking_norm(argument, domain)

    def _loading_element(self, element: Element) -> list[str]:
        source = f"{element.argument.name}[{element.index}]"
        copy = self.place(element.load) if self._is_copied(element) else ""
        if not (self.guarded or element.argument.integer):
            return comments.code(f"{copy} = {source};") if copy else []
        take, test, limits = self._range_check(element)
        if copy:
            return comments.code(f"outside |= {take}({source}, {limits}, &{copy});")
        return comments.code(f"outside |= {test}({source}, {limits});")

    def _range_check(self, element: Element) -> tuple[str, str, str]:
        """Names of the functions that copy or only test an element, and its limits."""
        if element.argument.integer:
            limits = ", ".join(integer_bounds(element.lower, element.upper))
            return "take_index", "is_index_outside", limits
        low, high = self.target.bounds(element.lower, element.upper)
        if low == f"-{high}":
            return "take_centred", "is_beyond", high
        return "take_value", "is_outside", f"{low}, {high}"

    def _checking_norm(self, argument: ir.Argument, domain: ir.Domain) -> list[str]:
        copies = [
            self.place(ir.Load(argument.name, index))
            for index in range(domain.start, domain.start + domain.size)
        ]
        tolerance = self.target.literal(domain.tolerance)
        test = f"is_skewed_{domain.kind.value}"
        return comments.code(f"skewed |= {test}({', '.join([*copies, tolerance])});")

    def _verdict(self, *, ranged: bool, skewed: bool) -> list[str]:
        code = self.target.flag
        text = code(ir.Status.OK)
        if skewed:
            text = f"(skewed != 0U) ? {code(ir.Status.QNORM)} : {text}"
        if ranged:
            rest = f"({text})" if skewed else text
            text = f"(outside != 0U) ? {code(ir.Status.RANGE)} : {rest}"
        return comments.code(f"return {text};")


def inputs_of(function: ir.Function, target: Target, loads: Collection[ir.Load]) -> Inputs:
    """Name the inputs of a function.

    Args:
        function: whose arguments they are.
        target: the tree.
        loads: every load of its bodies and outputs.
    """
    spans = spans_of(function, loads)
    chosen = {load: _span_of(function, load, spans) for load in loads if _is_moving(load)}
    names = Names(_LOCALS)
    fields: dict[Span, str] = {}
    table: dict[ir.Load, Element] = {}
    for argument in function.arguments:
        for domain in argument.domains:
            for offset in range(domain.size):
                index = domain.start + offset
                span = _span_around(spans, argument, index)
                if span is None:
                    field = names.claim(_wish(argument, domain, offset))
                else:
                    field = fields.get(span) or names.claim(f"{_stem(argument, domain)}_by_slot")
                    fields[span] = field
                element = Element(argument, domain, index, field, span)
                table[element.load] = element
    copied = {load for load in loads if load in table} | _normed(function)
    copied |= {load for load, element in table.items() if element.span}
    pointed = {load for load in copied if not function.guarded and _may_stay(table[load])}
    kept = frozenset(copied - pointed)
    guarded = function.guarded
    return Inputs(target, function.name, table, kept, frozenset(pointed), chosen, guarded)


def _may_stay(element: Element) -> bool:
    """True for an element that a kernel can read from where the caller keeps it."""
    return not (element.argument.item or element.argument.integer or element.span)


def _is_moving(load: ir.Load) -> bool:
    return isinstance(load.index, ir.Offset)


def _span_of(function: ir.Function, load: ir.Load, spans: Iterable[Span]) -> Span:
    """The array a load chooses from."""
    assert isinstance(load.index, ir.Offset)
    first, _ = reach(function, load.index)
    return next(s for s in spans if s.argument == load.argument and s.start <= first < s.stop)


def _span_around(spans: Iterable[Span], argument: ir.Argument, index: int) -> Span | None:
    around = (s for s in spans if s.argument == argument.name and s.start <= index < s.stop)
    return next(around, None)


def _normed(function: ir.Function) -> set[ir.Load]:
    """Elements whose norm is checked; their copies are what the check reads."""
    return {
        ir.Load(argument.name, index)
        for argument in function.arguments
        for domain in argument.domains
        if function.guarded and domain.kind in (ir.Kind.QUATERNION, ir.Kind.MATRIX)
        for index in range(domain.start, domain.start + domain.size)
    }


def _wish(argument: ir.Argument, domain: ir.Domain, offset: int) -> str:
    stem = _stem(argument, domain)
    if domain.size == 1:
        return identifier(stem)
    label = domain.labels[offset]
    return identifier(f"{stem}_{label if label.strip() else offset}")


def _stem(argument: ir.Argument, domain: ir.Domain) -> str:
    return domain.name if argument.name == "x" or len(argument.domains) > 1 else argument.name


def _comment(domain: ir.Domain) -> str:
    where = _where(domain)
    return f"    {comments.aside(f'{domain.name} [{where}]' if where else domain.name)}"


def _where(domain: ir.Domain) -> str:
    """Unit and frame."""
    unit = "" if domain.unit == "1" else domain.unit
    frame = f"in {domain.frame}" if domain.frame and "->" not in domain.frame else domain.frame
    return ", ".join(part for part in (unit, frame) if part)
