"""C route: a derivation through CasADi's graph, ``ca.cse`` and its instruction list to IR steps.

The shared and the item part become one ``casadi.Function`` each. Guarded values leave the graph
and come back as fresh symbols, so that everything downstream reads the checked value. Named terms
travel as extra outputs: they label the registers of the instruction list and are then dropped.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache

import casadi as ca
import sympy as sp

from symnav import ir
from symnav.derive import Derivation
from symnav.graph import Definition
from symnav.ir import Call, Expression, Load, Number, Operation, Ref
from symnav.lower import signature
from symnav.lower.casadi_bridge import to_casadi
from symnav.spec.records import Spec

_BINARY = {
    "OP_ADD": Operation.ADD, "OP_SUB": Operation.SUB, "OP_MUL": Operation.MUL,
    "OP_DIV": Operation.DIV, "OP_ATAN2": Operation.ATAN2, "OP_FMIN": Operation.MIN,
    "OP_FMAX": Operation.MAX, "OP_LT": Operation.LT, "OP_LE": Operation.LE, "OP_EQ": Operation.EQ,
    "OP_NE": Operation.NE, "OP_AND": Operation.AND, "OP_OR": Operation.OR,
}  # fmt: skip
_UNARY = {
    "OP_NEG": Operation.NEG, "OP_SQRT": Operation.SQRT, "OP_SIN": Operation.SIN,
    "OP_COS": Operation.COS, "OP_TAN": Operation.TAN, "OP_ASIN": Operation.ASIN,
    "OP_ACOS": Operation.ACOS, "OP_ATAN": Operation.ATAN, "OP_EXP": Operation.EXP,
    "OP_LOG": Operation.LOG, "OP_FABS": Operation.ABS, "OP_FLOOR": Operation.FLOOR,
    "OP_NOT": Operation.NOT,
}  # fmt: skip


@cache
def _operations() -> dict[int, str]:
    """Names of CasADi's instruction codes."""
    return {getattr(ca, name): name for name in dir(ca) if name.startswith("OP_")}


def lower(spec: Spec, derivation: Derivation) -> ir.Function:
    """Lower one derivation.

    Raises:
        AssertionError: when CasADi gives an instruction the representation does not know.
    """
    parts = _Parts(derivation)
    shared = parts.lower(item=False, joins={})
    item = parts.lower(item=True, joins=shared.results) if derivation.mapped else _NOTHING
    values = {
        output.name: {key: parts.value(e, shared, item) for key, e in output.entries.items()}
        for output in derivation.outputs
    }
    slots = {
        symbol.name: parts.load(symbol)
        for output in derivation.outputs
        for symbol in output.slots.values()
    }
    return signature.function(spec, derivation, shared.steps, item.steps, values, slots)


@dataclass(frozen=True)
class _Lowered:
    """Steps of one part, and the expression of each of its results."""

    steps: tuple[ir.Step, ...]
    results: Mapping[sp.Expr, Expression]


_NOTHING = _Lowered((), {})


@dataclass
class _Parts:
    """The two parts of a derivation and what passes between them."""

    derivation: Derivation
    _by_symbol: dict[sp.Symbol, Definition] = field(init=False)

    def __post_init__(self) -> None:
        self._by_symbol = {d.symbol: d for d in self.derivation.definitions}

    def load(self, symbol: sp.Symbol) -> Load:
        """The load of an argument symbol."""
        origin = self.derivation.origins[symbol]
        if origin.slot is None:
            return Load(origin.argument, origin.index)
        slot = self.load(origin.slot)
        return Load(origin.argument, ir.Offset(origin.index, slot))

    def value(self, expression: sp.Expr, shared: _Lowered, item: _Lowered) -> Expression:
        """An output element, from whichever part computed it."""
        for part in (item, shared):
            if expression in part.results:
                return part.results[expression]
        return self._atom(expression)

    def _atom(self, expression: sp.Expr) -> Expression:
        if expression.is_number:
            return Number(float(expression))
        if isinstance(expression, sp.Symbol) and expression in self.derivation.origins:
            return self.load(expression)
        raise AssertionError(f"output element {expression} was not lowered")

    def _is_item(self, expression: sp.Expr) -> bool:
        return any(
            self._by_symbol[s].item if s in self._by_symbol else self._item_argument(s)
            for s in expression.free_symbols
        )

    def _item_argument(self, symbol: sp.Basic) -> bool:
        return symbol in self.derivation.item_symbols

    def lower(self, *, item: bool, joins: Mapping[sp.Expr, Expression]) -> _Lowered:
        """Steps and results of the shared or of the item part, which reads ``joins``."""
        definitions = [d for d in self.derivation.definitions if d.item == item]
        results = self._results(item)
        if not item:
            results += self._joins(definitions)
        return _PartLowering(self, definitions, results, joins, "u" if item else "t").run()

    def _results(self, item: bool) -> list[sp.Expr]:
        """Output elements this part computes; arguments and numbers are left to ``_atom``."""
        found: dict[sp.Expr, None] = {}
        for output in self.derivation.outputs:
            for e in output.entries.values():
                plain = e.is_number or e in self.derivation.origins
                if not plain and self._is_item(e) == item:
                    found[e] = None
        return list(found)

    def _joins(self, shared: Sequence[Definition]) -> list[sp.Expr]:
        """Shared names that the item part reads."""
        own = {d.symbol for d in shared}
        used: set[sp.Basic] = set()
        for definition in self.derivation.definitions:
            if definition.item:
                used |= definition.expression.free_symbols
        for e in self._results(item=True):
            used |= e.free_symbols
        return [d.symbol for d in shared if d.symbol in used and d.symbol in own]


class _PartLowering:
    """One part: definitions to SX, SX to instructions, instructions to steps."""

    def __init__(
        self,
        parts: _Parts,
        definitions: Sequence[Definition],
        results: Sequence[sp.Expr],
        joins: Mapping[sp.Expr, Expression],
        stem: str,
    ) -> None:
        self._parts = parts
        self._definitions = definitions
        self._results = results
        self._joins = joins
        self._stem = stem
        self._inputs: dict[str, tuple[ca.SX, Expression]] = {}
        self._table: dict[sp.Symbol, ca.SX] = {}

    def run(self) -> _Lowered:
        labels: list[tuple[str, ca.SX]] = []
        guarded: list[tuple[Definition, ca.SX]] = []
        for definition in self._definitions:
            value = self._convert(definition.expression)
            if definition.guard is None:
                labels.append((definition.symbol.name, value))
                self._table[definition.symbol] = value
            else:
                guarded.append((definition, value))
                name = definition.symbol.name
                self._table[definition.symbol] = self._input(name, Ref(name))
        results = [self._convert(e) for e in self._results]
        checks = [value for _, value in guarded]
        everything = [*results, *checks, *(value for _, value in labels)]
        if not everything:
            return _Lowered((), {})
        program = _Program(everything, [sx for sx, _ in self._inputs.values()], self._stem)
        sources = [expression for _, expression in self._inputs.values()]
        program.name([name for name, _ in labels], offset=len(results) + len(checks))
        steps = program.steps(
            sources, len(results), {i + len(results): d for i, (d, _) in enumerate(guarded)}
        )
        values = {e: program.result(i, sources) for i, e in enumerate(self._results)}
        return _Lowered(tuple(steps), values)

    def _convert(self, expression: sp.Expr) -> ca.SX:
        for symbol in sorted(expression.free_symbols, key=lambda s: s.name):
            if symbol not in self._table:
                self._table[symbol] = self._outside(symbol)
        return to_casadi(expression, self._table)

    def _outside(self, symbol: sp.Symbol) -> ca.SX:
        """A symbol of another part (a join) or an argument."""
        if symbol in self._parts.derivation.origins:
            return self._input(symbol.name, self._parts.load(symbol))
        return self._input(symbol.name, self._joins[symbol])

    def _input(self, name: str, expression: Expression) -> ca.SX:
        if name not in self._inputs:
            self._inputs[name] = (ca.SX.sym(name), expression)
        return self._inputs[name][0]


@dataclass
class _Node:
    """One value of the instruction list: an operation on earlier values."""

    operation: str
    operands: tuple[int, ...]
    constant: float = 0.0


class _Program:
    """The instruction list of one SX function in single-assignment form.

    Values without a name are called ``stem`` and a number; the two parts have different stems.
    """

    def __init__(self, outputs: Sequence[ca.SX], inputs: Sequence[ca.SX], stem: str) -> None:
        stacked = ca.vertcat(*[ca.densify(e) for e in outputs])
        self._function = ca.Function("part", [ca.vertcat(*inputs)], [ca.cse(stacked)])
        self.nodes: list[_Node] = []
        self.outputs: dict[int, int] = {}
        self.names: dict[int, str] = {}
        self._places: dict[int, int] = {}
        self._stem = stem
        self._read()

    def _read(self) -> None:
        """Follow the work registers, which CasADi re-uses, to values assigned once."""
        f, codes = self._function, _operations()
        register: dict[int, int] = {}
        for k in range(f.n_instructions()):
            operation = codes[f.instruction_id(k)]
            inputs, outputs = f.instruction_input(k), f.instruction_output(k)
            if operation == "OP_OUTPUT":
                self.outputs[outputs[1]] = register[inputs[0]]
                continue
            if operation == "OP_INPUT":
                node = _Node(operation, (inputs[1],))
            elif operation == "OP_CONST":
                node = _Node(operation, (), f.instruction_constant(k))
            else:
                node = _Node(operation, tuple(register[i] for i in inputs))
            self.nodes.append(node)
            register[outputs[0]] = len(self.nodes) - 1

    def name(self, labels: Sequence[str], offset: int) -> None:
        """Give values the names of the terms they are; the first name wins."""
        for k, label in enumerate(labels):
            value = self.outputs[offset + k]
            self.names.setdefault(value, label)
            self._places.setdefault(value, k)

    def steps(
        self, sources: Sequence[Expression], results: int, checks: Mapping[int, Definition]
    ) -> list[ir.Step]:
        """Statements and checks that the first ``results`` outputs and every check need."""
        wanted = [self.outputs[i] for i in (*range(results), *checks)]
        refs = {e.name: i for i, e in enumerate(sources) if isinstance(e, Ref)}
        guard_of = {refs[d.symbol.name]: i for i, d in checks.items() if d.symbol.name in refs}
        live = self._live(wanted, guard_of)
        order = self._order(live, guard_of)
        by_output = {self.outputs[i]: [] for i in checks}  # type: dict[int, list[Definition]]
        for i, definition in checks.items():
            by_output[self.outputs[i]].append(definition)
        steps: list[ir.Step] = []
        for value in order:
            if self._stored(value):
                steps.append(ir.Statement(self._target(value), self._expand(value, sources)))
            for definition in by_output.get(value, ()):
                steps.append(_check(definition, self.reference(value, sources)))
        return steps

    def result(self, output: int, sources: Sequence[Expression]) -> Expression:
        """The expression of an output."""
        return self.reference(self.outputs[output], sources)

    def _live(self, wanted: Iterable[int], guard_of: Mapping[int, int]) -> set[int]:
        live: set[int] = set()
        waiting = list(wanted)
        while waiting:
            value = waiting.pop()
            if value not in live:
                live.add(value)
                waiting += self._needs(value, guard_of)
        return live

    def _needs(self, value: int, guard_of: Mapping[int, int]) -> list[int]:
        node = self.nodes[value]
        if node.operation != "OP_INPUT":
            return list(self._selection(value) or node.operands)
        check = guard_of.get(node.operands[0])
        return [] if check is None else [self.outputs[check]]

    def _order(self, live: set[int], guard_of: Mapping[int, int]) -> list[int]:
        """The order of the equation: its terms as they were named, other values before their use.

        Elements of a vector stand together, and the code reads like the equation it came from.
        A guarded value comes before the steps that read it.
        """
        needs = {v: set(self._needs(v, guard_of)) for v in live}
        users: dict[int, list[int]] = {}
        for value, operands in needs.items():
            for operand in operands:
                users.setdefault(operand, []).append(value)
        places = self._placed(live, users)
        ready = [(places[v], v) for v, operands in needs.items() if not operands]
        heapq.heapify(ready)
        order = []
        while ready:
            _, value = heapq.heappop(ready)
            order.append(value)
            for user in users.get(value, ()):
                needs[user].discard(value)
                if not needs[user]:
                    heapq.heappush(ready, (places[user], user))
        assert len(order) == len(live), "guards of one part depend on each other"
        return order

    def _placed(self, live: set[int], users: Mapping[int, Sequence[int]]) -> dict[int, int]:
        """Where every value belongs: named ones in the order of the names, others at first use."""
        places: dict[int, int] = {}

        def place(value: int) -> int:
            if value not in places:
                later = [place(user) for user in users.get(value, ()) if user > value]
                places[value] = self._places.get(value, min(later, default=len(self.nodes)))
            return places[value]

        for value in sorted(live, reverse=True):
            place(value)
        return places

    def _stored(self, value: int) -> bool:
        operation = self.nodes[value].operation
        return operation not in ("OP_INPUT", "OP_CONST") and not self._is_condition(value)

    def _is_condition(self, value: int) -> bool:
        operation = self.nodes[value].operation
        code = _BINARY.get(operation) or _UNARY.get(operation)
        return code in ir.CONDITIONS

    def _target(self, value: int) -> str:
        return self.names.get(value, f"{self._stem}{value}")

    def reference(self, value: int, sources: Sequence[Expression]) -> Expression:
        """A value as an operand: its local, its load, its literal or its condition."""
        node = self.nodes[value]
        if node.operation == "OP_CONST":
            return Number(node.constant)
        if node.operation == "OP_INPUT":
            return sources[node.operands[0]]
        if self._is_condition(value):
            return self._expand(value, sources)
        return Ref(self._target(value))

    def _expand(self, value: int, sources: Sequence[Expression]) -> Expression:
        node = self.nodes[value]
        chosen = self._selection(value)
        if chosen is not None:
            parts = tuple(self.reference(operand, sources) for operand in chosen)
            return Call(Operation.SELECT, parts)
        a = [self._operand(v, node.operation, sources) for v in node.operands]
        if node.operation == "OP_SQ":
            return Call(Operation.MUL, (a[0], a[0]))
        if node.operation == "OP_TWICE":
            return Call(Operation.MUL, (Number(2.0), a[0]))
        if node.operation == "OP_INV":
            return Call(Operation.DIV, (Number(1.0), a[0]))
        if node.operation == "OP_IF_ELSE_ZERO":
            return Call(Operation.SELECT, (a[0], a[1], Number(0.0)))
        code = _BINARY.get(node.operation) or _UNARY.get(node.operation)
        assert code is not None, f"CasADi instruction {node.operation} is not known"
        return Call(code, tuple(a))

    def _operand(self, value: int, user: str, sources: Sequence[Expression]) -> Expression:
        """A condition is an operand of logic as it is, and of arithmetic as one or zero."""
        expression = self.reference(value, sources)
        logical = user in ("OP_AND", "OP_OR", "OP_NOT", "OP_IF_ELSE_ZERO")
        if self._is_condition(value) and not logical:
            return Call(Operation.SELECT, (expression, Number(1.0), Number(0.0)))
        return expression

    def _selection(self, value: int) -> tuple[int, int, int] | None:
        """CasADi writes a choice as (c ? a : 0) + (!c ? b : 0): the values c, a and b of one."""
        node = self.nodes[value]
        if node.operation != "OP_ADD":
            return None
        left, right = (self.nodes[v] for v in node.operands)
        if left.operation != "OP_IF_ELSE_ZERO" or right.operation != "OP_IF_ELSE_ZERO":
            return None
        opposite = self.nodes[right.operands[0]]
        if opposite.operation != "OP_NOT" or opposite.operands[0] != left.operands[0]:
            return None
        return left.operands[0], left.operands[1], right.operands[1]


def _check(definition: Definition, value: Expression) -> ir.Check:
    guard = definition.guard
    assert guard is not None
    return ir.Check(
        definition.symbol.name, value, guard.lower, guard.upper, guard.substitute,
        ir.Status.DOMAIN, guard.reason,
    )  # fmt: skip
