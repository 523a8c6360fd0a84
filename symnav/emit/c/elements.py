"""Elements of the arguments of a function: what each is, and the name of the field of its copy."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass

from symnav import ir
from symnav.emit.c.names import Names, identifier
from symnav.emit.c.slots import Span, reach, spans_of

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


def elements_of(
    function: ir.Function, loads: Collection[ir.Load]
) -> tuple[dict[ir.Load, Element], dict[ir.Load, Span]]:
    """Every element in the order of the interface, and what loads by a run-time slot choose from.

    Args:
        function: whose arguments they are of.
        loads: every load of its bodies and outputs.
    """
    spans = spans_of(function, loads)
    chosen = {load: _span_of(function, load, spans) for load in loads if _is_moving(load)}
    return _named(function, spans), chosen


def _named(function: ir.Function, spans: Collection[Span]) -> dict[ir.Load, Element]:
    """Every element with a name of its own, or that of the array it is chosen from."""
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
    return table


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


def _wish(argument: ir.Argument, domain: ir.Domain, offset: int) -> str:
    stem = _stem(argument, domain)
    if domain.size == 1:
        return identifier(stem)
    label = domain.labels[offset]
    return identifier(f"{stem}_{label if label.strip() else offset}")


def _stem(argument: ir.Argument, domain: ir.Domain) -> str:
    """Blocks by name; those of a second state or of an error behind the name of the argument."""
    if argument.name == "x":
        return domain.name
    return f"{argument.name}_{domain.name}" if len(argument.domains) > 1 else argument.name
