"""User equations: expressions or Python functions made into models like those of the library."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NoReturn

from symnav import naming, units
from symnav.blocks import (
    Block,
    GeodeticBlock,
    HeadingBlock,
    RotationBlock,
    Value,
    VectorBlock,
    frame_map,
)
from symnav.equations.bound import Bound, Results
from symnav.equations.model import Model, OptionValue, Role
from symnav.errors import EquationError
from symnav.graph import Definition, Graph
from symnav.naming import Use
from symnav.quantities import Quantity, let
from symnav.spec.declarations import Frames, check_unit
from symnav.spec.expressions import Evaluator, names, normal_form, parse
from symnav.spec.records import Binding, ToInput, ToState
from symnav.spec.schema import EntryTable
from symnav.spec.trial import Quantities, Scope, results

#: Receives a mistake: the key below the entry, and what is wrong.
OnError = Callable[[str, EquationError], None]


@dataclass(frozen=True)
class TextEquation:
    """An equation written as expressions; called like any equation of the library.

    Attributes:
        lets: named terms in order.
        components: expressions whose elements follow each other in the result.
        unit: unit the result must have, or empty.
        frame: frame the result must have, or empty.
    """

    lets: tuple[tuple[str, str], ...]
    components: tuple[str, ...]
    unit: str = ""
    frame: str = ""

    def __call__(self, q: Bound) -> Quantity:
        """The result over bound quantities."""
        result = self.run(q.graph, q.values, _raise)
        assert result is not None
        return result

    def run(self, graph: Graph, values: Mapping[str, Value], on_error: OnError) -> Quantity | None:
        """Evaluate every expression, hand every mistake over, and join what came out."""
        terms: dict[str, Quantity] = {}
        evaluator = Evaluator(graph, values, terms)
        broken: set[str] = set()

        def value(key: str, text: str) -> Quantity | None:
            """The quantity, or None for a mistake and for what reads a broken let."""
            tree = parse(text)
            if not broken.isdisjoint(names(tree)):
                return None
            try:
                return evaluator.quantity(tree)
            except EquationError as error:
                on_error(key, error)
                return None

        for name, text in self.lets:
            term = value(f"let.{name}", text)
            if term is None:
                broken.add(name)
            else:
                terms[name] = let(name, term)
        parts = [value(f"equation[{k}]", text) for k, text in enumerate(self.components)]
        known = [part for part in parts if part is not None]
        sound = not broken and len(known) == len(parts)
        return self._join(known, on_error) if sound else None

    def _join(self, parts: list[Quantity], on_error: OnError) -> Quantity | None:
        first = parts[0]
        for k, part in enumerate(parts):
            if part.unit != first.unit:
                error = EquationError(
                    f"{part.describe()} cannot follow {first.describe()}; all components have "
                    "one unit"
                )
                on_error(f"equation[{k}]", error)
                return None
        elements = tuple(element for part in parts for element in part.elements)
        shared = {part.frame for part in parts}
        frame = first.frame if len(shared) == 1 else None
        joined = Quantity(first.graph, elements, first.unit, frame)
        if self.unit and units.parse(self.unit) != joined.unit:
            on_error("unit", EquationError(f"the result is {joined.describe()}, not {self.unit}"))
            return None
        if not self.frame or self.frame == frame:
            return joined
        if frame is not None or joined.size % 3:
            on_error(
                "frame",
                EquationError(f"the result is {joined.describe()}, not in frame {self.frame!r}"),
            )
            return None
        return Quantity(joined.graph, joined.elements, joined.unit, self.frame)

    def describe(self) -> str:
        """The equation in plain text."""
        terms = [f"{name} = {text}" for name, text in self.lets]
        result = self.components[0]
        if len(self.components) > 1:
            result = f"[{', '.join(self.components)}]"
        return "\n".join([*terms, f"z = {result}"])


@dataclass(frozen=True)
class Made:
    """A user equation as a model.

    Attributes:
        model: its roles are the states and inputs it reads, under their own names.
        bindings: every role to the state or input of its name.
        frames: every frame to itself.
        outcome: what it gives.
        canonical: its definitions, whatever it was written in.
    """

    model: Model
    bindings: Mapping[str, Binding]
    frames: Mapping[str, str]
    outcome: Results
    canonical: tuple[str, ...]


def make(table: EntryTable, section: str, path: str, scope: Scope, frames: Frames) -> Made | None:
    """Evaluate a user equation on trial and wrap it; its mistakes are recorded."""
    values = Quantities(scope, Graph())
    written = _from_function if callable(table.equation) else _from_text
    evaluated = written(table, path, values, frames)
    if evaluated is None:
        return None
    if not values.read:
        frames.problems.add(f"{path}.equation", "reads neither a state block nor an input")
        return None
    model = _model(table, section, scope, tuple(values.read), evaluated)
    first = next(iter(evaluated.outcome.outputs.values()))
    if model.mapped and first.size != 1:
        frames.problems.add(
            f"{path}.equation",
            f"gives {first.describe()} per item; an equation over items gives one scalar",
        )
    bindings: dict[str, Binding] = {
        name: ToState(name) if name in scope.states else ToInput(name) for name in values.read
    }
    named = sorted({frame for role in model.roles for frame in _frames_of(role)})
    lines = tuple(evaluated.lines)
    return Made(model, bindings, {name: name for name in named}, evaluated.outcome, lines)


@dataclass(frozen=True)
class _Evaluated:
    """A user equation after its trial: how to call it, what it gives, and what it says."""

    call: Callable[[Any], Any]
    outcome: Results
    lines: Sequence[str]


def _from_text(
    table: EntryTable, path: str, values: Quantities, frames: Frames
) -> _Evaluated | None:
    assert isinstance(table.equation, tuple)
    text = _text_equation(table, table.equation, path, values.scope, frames)
    if text is None:
        return None

    def report(key: str, error: EquationError) -> None:
        frames.problems.add(f"{path}.{key}", str(error))

    result = text.run(values.graph, values, report)
    if result is None:
        return None
    return _Evaluated(text, Results({"value": result}), text.describe().split("\n"))


def _from_function(
    table: EntryTable, path: str, values: Quantities, frames: Frames
) -> _Evaluated | None:
    function, problems = table.equation, frames.problems
    assert callable(function)
    if table.let:
        problems.add(f"{path}.let", "goes with expressions; a Python function names its own terms")
    try:
        outcome = results(function(Bound(values.graph, {}, values, {}, {})))
    except EquationError as error:
        problems.add(f"{path}.equation", str(error))
        return None
    first = next(iter(outcome.outputs.values()))
    if table.unit is not None:
        unit = check_unit(table.unit, f"{path}.unit", problems)
        if units.parse(unit) != first.unit:
            problems.add(f"{path}.unit", f"the result is {first.describe()}, not {table.unit}")
    if table.frame is not None and table.frame != first.frame:
        problems.add(
            f"{path}.frame", f"the result is {first.describe()}, not in frame {table.frame!r}"
        )
    lines = [_line(definition) for definition in values.graph.definitions]
    for name, found in outcome.outputs.items():
        where = f" in {found.frame}" if found.frame else ""
        lines.append(f"{name} = {list(found.elements)} {found.unit}{where}")
    return _Evaluated(function, outcome, lines)


def _line(definition: Definition) -> str:
    """One definition, with the domain that its guard allows."""
    guard = definition.guard
    domain = f" within [{guard.lower!r}, {guard.upper!r}]" if guard is not None else ""
    return f"{definition.symbol} = {definition.expression}{domain}"


def _text_equation(
    table: EntryTable, components: tuple[str, ...], path: str, scope: Scope, frames: Frames
) -> TextEquation | None:
    """The equation with its expressions in normal form, or None when one cannot be read."""
    problems = frames.problems
    before = len(problems.found)
    taken = dict.fromkeys(scope.names(), "")
    for name in table.let:
        reason = naming.fault(name, Use.TERM)
        other = naming.clash(name, taken)
        if reason is not None:
            problems.add(f"{path}.let.{name}", reason)
        elif other is not None:
            problems.add(f"{path}.let.{name}", f"{name!r} is already the name of {other!r}")
        taken[name] = ""
    if table.unit is not None:
        check_unit(table.unit, f"{path}.unit", problems)
    if table.frame is not None:
        frames.use(table.frame, f"{path}.frame")
    keyed = [(f"let.{name}", text) for name, text in table.let.items()]
    keyed += [(f"equation[{k}]", text) for k, text in enumerate(components)]
    normal = {}
    for key, text in keyed:
        try:
            normal[key] = normal_form(text)
        except EquationError as error:
            problems.add(f"{path}.{key}", str(error))
    if len(problems.found) > before:
        return None
    return TextEquation(
        tuple((name, normal[f"let.{name}"]) for name in table.let),
        tuple(normal[f"equation[{k}]"] for k in range(len(components))),
        table.unit or "",
        table.frame or "",
    )


def _model(
    table: EntryTable,
    section: str,
    scope: Scope,
    read: tuple[str, ...],
    evaluated: _Evaluated,
) -> Model:
    return Model(
        name="equation",
        section=section,
        title=table.description or "Equation of the specification",
        equation="\n".join(evaluated.lines),
        source="the specification",
        roles=tuple(_role(scope.block(name), scope.is_item(name)) for name in read),
        options=(),
        mapped=any(scope.is_item(name) for name in read),
        always_double=False,
        function=evaluated.call,
        conventions=_no_conventions,
    )


def _role(block: Block, item: bool) -> Role:
    """The role that a state block or input plays under its own name."""
    kind, frame = "vector", block.frames[0]
    if isinstance(block, (RotationBlock, HeadingBlock)):
        kind = "rotation"
    elif isinstance(block, GeodeticBlock):
        kind = "point"
    elif isinstance(block, VectorBlock) and block.size == 1:
        kind = "scalar"
    unit = "m" if kind == "point" else block.units[0]
    lower, upper = min(block.lower), max(block.upper)
    return Role(
        block.name, kind, block.storage_size, unit, frame, False, item, lower, upper, False, False,
        block.description,
    )  # fmt: skip


def _frames_of(role: Role) -> tuple[str, ...]:
    if not role.frame:
        return ()
    return frame_map(role.frame) if role.kind == "rotation" else (role.frame,)


def _no_conventions(_options: Mapping[str, OptionValue]) -> tuple[str, ...]:
    return ()


def _raise(_key: str, error: EquationError) -> NoReturn:
    raise error


__all__ = ["Made", "TextEquation", "make"]
