"""Inputs of a function: which elements its kernel reads, what they are called, how they load.

Loading copies every element the kernel reads into a structure and checks every element that was
declared, so that a caller that lets an input and an output overlap by mistake cannot corrupt a
result. What is evaluated whatever the checks say, items and epochs side by side, gets a harmless
number in the place of one outside its range where the function needs that (``discarding``).

Where nothing is checked, what is read once per call stays with the caller: the structure holds
where it is, and the kernel reads every element where it is first needed. A compiler that meets
all the copies first keeps more of them than a processor has registers.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from symnav import ir
from symnav.emit.c import comments
from symnav.emit.c.discarding import selected
from symnav.emit.c.elements import Element, elements_of
from symnav.emit.c.judging import Group, Judgement
from symnav.emit.c.names import Names
from symnav.emit.c.pieces import Field, Routine, Struct, head
from symnav.emit.c.ranges import has_norm, judged_loads, limits_of, verdict
from symnav.emit.c.slots import Span
from symnav.emit.c.target import Target

INPUT_POINTER = "in"
ITEM_POINTER = "item"

_PROVEN = (
    "#ifdef __FRAMAC__ /* Eva does not carry it from one pass to the next: selected once more. */"
)


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
        checked: True when every element is checked.
        strided: True when elements of an epoch may be a distance apart.
        selected: flagged elements that harmless numbers replace when they are outside their range.
    """

    target: Target
    name: str
    table: Mapping[ir.Load, Element]
    copied: frozenset[ir.Load]
    pointed: frozenset[ir.Load]
    chosen: Mapping[ir.Load, Span]
    checked: bool
    strided: bool
    selected: frozenset[ir.Load]

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
        new = {load for load in loads if load in self.pointed} - seen
        seen |= new
        return [
            line
            for element in map(self.table.__getitem__, sorted(new, key=self._rank.__getitem__))
            for line in comments.code(
                f"const {self.target.real} {element.field} = {self._pointed_at(element)};",
                remark=_where(element.domain),
            )
        ]

    @cached_property
    def _rank(self) -> dict[ir.Load, int]:
        """Place of every element in the order of the interface."""
        return {load: rank for rank, load in enumerate(self.table)}

    def _pointed_at(self, element: Element) -> str:
        """C text of an element that the kernel reads from where the caller keeps it."""
        index = str(element.index)
        if self.strided and element.index:
            stride = f"{INPUT_POINTER}->{self._stride}"
            index = stride if element.index == 1 else f"{index} * {stride}"
        return f"{INPUT_POINTER}->{self._pointers[element.argument.name]}[{index}]"

    @property
    def points_far(self) -> bool:
        """True when the kernel reads elements that may be a distance apart."""
        return self.strided and any(load.index for load in self.pointed)

    @cached_property
    def _stride(self) -> str:
        """Field that holds the distance between elements the kernel reads."""
        names = Names(self.table[load].field for load in self.copied)
        for pointer in self._pointers.values():
            names.claim(pointer)
        return names.claim("stride")

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
        if self.points_far and not item:
            remark = "from one element to the next"
            fields |= dict.fromkeys([Field("int32_t", self._stride, remark=remark)])
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
        state = ", each checked against its range." if self.checked else ", unchecked."
        return Struct(f"{self.name}_{kind}_t", brief + state, tuple(fields))

    def loader(self, *, item: bool) -> Routine:
        """The function that checks and copies the inputs of one call, or of one item."""
        struct = self.struct(item=item)
        pointer = ITEM_POINTER if item else INPUT_POINTER
        arguments = [argument for argument in self.arguments if argument.item is item]
        declarations = [self.declaration(argument) for argument in arguments]
        declarations += ["int32_t stride"] if self.load_stride and not item else []
        if struct:
            declarations.append(f"{struct.name} *{pointer}")
        return Routine(
            brief=f"{self._deed} the inputs of {self._scope(item)}.",
            head=head(
                f"{self.target.macro}_INLINE flag_t", self.loader_name(item=item), declarations
            ),
            body=tuple(self._loading(arguments, item=item)),
        )

    def loader_name(self, *, item: bool) -> str:
        """Name of that function."""
        lane = self.checked and self.strided
        return f"{self.name}_load{'_item' if item else '_lane' if lane else ''}"

    @cached_property
    def lanes(self) -> Inputs:
        """The same for epochs that lie side by side and are loaded side by side."""
        return replace(self, strided=True)

    def _scope(self, item: bool) -> str:
        """Whose inputs loading looks at."""
        lane = self.checked and self.strided
        return "one item" if item else "one epoch beside others" if lane else "one call"

    @property
    def _deed(self) -> str:
        """What loading does."""
        if self.copied:
            return "Check and copy"
        return "Check" if self.checked else "Point at"

    def copier(self, *, item: bool) -> Routine:
        """The function that copies inputs that were checked before."""
        struct = self.struct(item=item)
        pointer = ITEM_POINTER if item else INPUT_POINTER
        strided = self.copy_stride and not item
        declarations = [self.declaration(argument) for argument in self.copied_arguments(item=item)]
        declarations += ["int32_t stride"] if strided else []
        declarations += [f"{struct.name} *{pointer}"]
        copies: list[str] = []
        proven: list[str] = []
        for element in self._copied(item=item):
            source, copy = self._source(element), self.place(element.load)
            plain = comments.code(f"{copy} = {source};")
            limits = limits_of(element, self.target).text
            again = comments.code(f"(void){self._helper(element)}({source}, {limits}, &{copy});")
            copies += plain
            proven += again if self._is_flagged(element.argument) else plain
        return Routine(
            brief=f"Copy the inputs of {self._scope(item)} that have passed their checks.",
            head=head(
                f"{self.target.macro}_INLINE void", self.copier_name(item=item), declarations
            ),
            body=tuple(
                copies if proven == copies else [_PROVEN, *proven, "#else", *copies, "#endif"]
            ),
        )

    def copier_name(self, *, item: bool) -> str:
        """Name of that function."""
        return f"{self.name}_copy{'_item' if item else ''}"

    def copied_arguments(self, *, item: bool) -> list[ir.Argument]:
        """Arguments of one call, or of one item, of which some element is copied."""
        copied = {element.argument.name for element in self._copied(item=item)}
        return [argument for argument in self.arguments if argument.name in copied]

    @property
    def load_stride(self) -> bool:
        """True when the loader of one call takes the distance between elements.

        One epoch's are neighbours; of epochs that lie side by side they are as many apart.
        """
        ends = [sum(run) for argument in self.arguments for run in self.runs(argument)]
        return self.strided and any(end > 1 for end in ends)

    @property
    def copy_stride(self) -> bool:
        """The same for the function that only copies."""
        return self.strided and any(element.index for element in self._copied(item=False))

    def can_fail(self, *, item: bool) -> bool:
        """True when the loader of one call, or of one item, checks something."""
        arguments = [argument for argument in self.arguments if argument.item is item]
        return bool(arguments) and (self.checked or any(a.integer for a in arguments))

    def runs(self, argument: ir.Argument) -> list[tuple[int, int]]:
        """First element and length of every run of elements that loading looks at."""
        found: list[tuple[int, int]] = []
        for domain in argument.domains:
            for index in range(domain.start, domain.start + domain.size):
                element = self.table[ir.Load(argument.name, index)]
                if not self._is_loaded(element):
                    continue
                if found and sum(found[-1]) == index:
                    found[-1] = (found[-1][0], found[-1][1] + 1)
                else:
                    found.append((index, 1))
        return found

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
        names = self._judgement(self.arguments).helpers()
        for argument in filter(self._is_flagged, self.arguments):
            for domain in argument.domains:
                names |= self._domain_helpers(argument, domain)
        return names

    def _domain_helpers(self, argument: ir.Argument, domain: ir.Domain) -> set[str]:
        elements = self._domain_elements(argument, domain)
        names = {self._helper(element) for element in elements}
        return names | ({f"is_skewed_{domain.kind.value}"} if self._is_normed(domain) else set())

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

    def _is_loaded(self, element: Element) -> bool:
        checked = self.checked or element.argument.integer
        read = checked and element.domain.kind is not ir.Kind.UNREAD
        return read or self._is_copied(element) or element.load in self.pointed

    def _source(self, element: Element) -> str:
        """C text of an element where the caller keeps it."""
        index = str(element.index)
        if self.strided and element.index:
            index = "stride" if element.index == 1 else f"{index} * stride"
        return f"{element.argument.name}[{index}]"

    def _copied(self, *, item: bool) -> Iterator[Element]:
        for element in self.elements:
            if element.argument.item is item and self._is_copied(element):
                yield element

    def _loading(self, arguments: list[ir.Argument], *, item: bool) -> Iterator[str]:
        flagged = any(self._is_flagged(argument) for argument in arguments)
        skewed = any(self._is_normed(d) for argument in arguments for d in argument.domains)
        if flagged:
            yield "    flag_t outside = 0U;"
        if skewed:
            yield "    flag_t skewed = 0U;"
        if self.points_far and arguments and not item:
            yield f"    {INPUT_POINTER}->{self._stride} = stride;"
        for argument in arguments:
            if argument.name in self._pointers:
                yield f"    {INPUT_POINTER}->{self._pointers[argument.name]} = {argument.name};"
            for domain in argument.domains:
                lines = self._loading_domain(argument, domain)
                yield from ["", _comment(domain), *lines] if lines else []
        judgement = self._judgement(arguments)
        for lines in judgement.lines():
            yield from ["", *lines] if lines else []
        yield ""
        text = verdict(self.target, flagged=flagged, judged=bool(judgement.groups), skewed=skewed)
        yield from comments.code(f"return {text};")

    def _is_flagged(self, argument: ir.Argument) -> bool:
        """True where every element is looked at when it is copied, and one by one.

        So it is where others, of items or of epochs, are loaded side by side.
        """
        return argument.integer or (self.checked and (argument.item or self.strided))

    def _is_normed(self, domain: ir.Domain) -> bool:
        return self.checked and has_norm(domain)

    def _domain_elements(self, argument: ir.Argument, domain: ir.Domain) -> list[Element]:
        """The elements of a domain that anything reads."""
        if domain.kind is ir.Kind.UNREAD:
            return []
        places = range(domain.start, domain.start + domain.size)
        return [self.table[ir.Load(argument.name, index)] for index in places]

    def _loading_domain(self, argument: ir.Argument, domain: ir.Domain) -> list[str]:
        """Copies, with flags where there are some."""
        lines: list[str] = []
        for element in self._domain_elements(argument, domain):
            lines += self._loading_element(element)
        if self._is_flagged(argument) and self._is_normed(domain):
            lines += self._group(argument, domain).skewed(self.target)
        return lines

    def _loading_element(self, element: Element) -> list[str]:
        source = self._source(element)
        copy = self.place(element.load) if self._is_copied(element) else ""
        if not self._is_flagged(element.argument):
            return comments.code(f"{copy} = {source};") if copy else []
        limits = limits_of(element, self.target).text
        given = f"{source}, {limits}, &{copy}" if copy else f"{source}, {limits}"
        return comments.code(f"outside |= {self._helper(element)}({given});")

    def _helper(self, element: Element) -> str:
        """Name of the check that flags an element, and copies it where there is a copy."""
        limits = limits_of(element, self.target)
        if not self._is_copied(element):
            return limits.test
        return limits.take(selects=element.load in self.selected)

    def _is_judged(self, argument: ir.Argument) -> bool:
        """True where elements are looked at run by run, after they were copied."""
        return self.checked and not self._is_flagged(argument)

    def _text(self, element: Element) -> str:
        """C text of an element: of its copy where it has one."""
        return self.place(element.load) if self._is_copied(element) else self._source(element)

    def _group(self, argument: ir.Argument, domain: ir.Domain) -> Group:
        """A domain as its checks read it."""
        elements = tuple(self._domain_elements(argument, domain))
        return Group(domain, elements, tuple(self._text(element) for element in elements))

    def _judgement(self, arguments: Iterable[ir.Argument]) -> Judgement:
        """The checks of what a call reads once."""
        groups = (
            self._group(argument, domain)
            for argument in filter(self._is_judged, arguments)
            for domain in argument.domains
        )
        return Judgement(self.target, tuple(group for group in groups if group.elements))


def inputs_of(function: ir.Function, target: Target, loads: Collection[ir.Load]) -> Inputs:
    """Name the inputs of a function.

    Args:
        function: whose arguments they are.
        target: the tree.
        loads: every load of its bodies and outputs.
    """
    table, chosen = elements_of(function, loads)
    copied = {load for load in loads if load in table} | judged_loads(function)
    copied |= {load for load, element in table.items() if element.span}
    whole = function.maximum is not None or not any(a.integer for a in function.arguments)
    open_ = whole and not function.checks_inputs
    pointed = {load for load in copied if open_ and _may_stay(table[load])}
    return Inputs(
        target, function.name, table, frozenset(copied - pointed), frozenset(pointed), chosen,
        function.checks_inputs, strided=function.maximum is None and not function.checks_inputs,
        selected=selected(function),
    )  # fmt: skip


def _may_stay(element: Element) -> bool:
    """True for an element that a kernel can read from where the caller keeps it."""
    return not (element.argument.item or element.argument.integer or element.span)


def _comment(domain: ir.Domain) -> str:
    where = _where(domain)
    return f"    {comments.aside(f'{domain.name} [{where}]' if where else domain.name)}"


def _where(domain: ir.Domain) -> str:
    """Unit and frame."""
    unit = "" if domain.unit == "1" else domain.unit
    frame = f"in {domain.frame}" if domain.frame and "->" not in domain.frame else domain.frame
    return ", ".join(part for part in (unit, frame) if part)
