"""NumPy route: a derivation through SymPy's common subexpressions to IR steps.

It shares the derivation with the C route and nothing else: its own elimination of common
subexpressions, its own conversion of expressions, its own order.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import reduce

import sympy as sp
from sympy.core.relational import Relational

from symnav import ir
from symnav.derive import Derivation
from symnav.graph import Definition, Guard
from symnav.ir import Call, Expression, Load, Number, Operation, Ref
from symnav.lower import signature
from symnav.spec.records import Spec

Step = tuple[sp.Symbol, sp.Expr, Guard | None]


def lower(spec: Spec, derivation: Derivation) -> ir.Function:
    """Lower one derivation."""
    entries = [
        (output.name, key, e) for output in derivation.outputs for key, e in output.entries.items()
    ]
    steps, results = _eliminate_common(derivation.definitions, [e for _, _, e in entries])
    items = _item_symbols(derivation, steps)
    printer = _Printer(derivation)
    shared = [printer.step(step) for step in steps if step[0] not in items]
    item = [printer.step(step) for step in steps if step[0] in items]
    values: dict[str, dict[tuple[int, int], Expression]] = {
        output.name: {} for output in derivation.outputs
    }
    for (name, key, _), result in zip(entries, results, strict=True):
        values[name][key] = printer.expression(result)
    slots = {
        symbol.name: printer.load(symbol)
        for output in derivation.outputs
        for symbol in output.slots.values()
    }
    return signature.function(spec, derivation, shared, item, values, slots)


def _eliminate_common(
    definitions: Sequence[Definition], outputs: Sequence[sp.Expr]
) -> tuple[list[Step], list[sp.Expr]]:
    """Common subexpressions over every definition and output, in dependency order.

    A guarded name stays a symbol: what reads it must read the checked value.
    """
    expressions = [d.expression for d in definitions] + list(outputs)
    fresh = (sp.Symbol(f"s{k}") for k in range(10**9))
    taken = {d.symbol for d in definitions}
    symbols = (s for s in fresh if s not in taken)
    replacements, reduced = sp.cse(expressions, symbols=symbols, order="none", list=True)
    steps: list[Step] = [(symbol, e, None) for symbol, e in replacements]
    steps += [(d.symbol, e, d.guard) for d, e in zip(definitions, reduced, strict=False)]
    return _ordered(steps), list(reduced[len(definitions) :])


def _ordered(steps: Sequence[Step]) -> list[Step]:
    """Steps so that every name is defined before it is read; names keep their order."""
    by_symbol = {step[0]: step for step in steps}
    placed: dict[sp.Symbol, Step] = {}

    def place(step: Step) -> None:
        if step[0] in placed:
            return
        for symbol in sorted(step[1].free_symbols & by_symbol.keys(), key=lambda s: s.name):
            place(by_symbol[symbol])
        placed[step[0]] = step

    for step in sorted(steps, key=lambda s: s[0].name.startswith("s") and s[2] is None):
        place(step)
    return list(placed.values())


def _item_symbols(derivation: Derivation, steps: Sequence[Step]) -> set[sp.Symbol]:
    items: set[sp.Symbol] = set(derivation.item_symbols)
    for symbol, e, _ in steps:
        if not items.isdisjoint(e.free_symbols):
            items.add(symbol)
    return items


class _Printer:
    """SymPy expressions as IR expressions, node type by node type."""

    def __init__(self, derivation: Derivation) -> None:
        self._origins = derivation.origins

    def step(self, step: Step) -> ir.Step:
        """A statement, or a check where the name is guarded."""
        symbol, e, guard = step
        value = self.expression(e)
        if guard is None:
            return ir.Statement(symbol.name, value)
        return ir.Check(
            symbol.name, value, guard.lower, guard.upper, guard.substitute, ir.Status.DOMAIN,
            guard.reason,
        )  # fmt: skip

    def load(self, symbol: sp.Symbol) -> Load:
        """The load of an argument symbol."""
        origin = self._origins[symbol]
        if origin.slot is None:
            return Load(origin.argument, origin.index)
        return Load(origin.argument, ir.Offset(origin.index, self.load(origin.slot)))

    def expression(self, e: sp.Basic) -> Expression:
        """Convert an expression.

        Raises:
            TypeError: for a node type without a counterpart.
        """
        if isinstance(e, sp.Symbol):
            return self.load(e) if e in self._origins else Ref(e.name)
        if isinstance(e, (sp.Number, sp.NumberSymbol)):
            return Number(float(e))
        if isinstance(e, sp.Add):
            return self._sum(e)
        if isinstance(e, sp.Mul):
            return self._product(e)
        if isinstance(e, sp.Pow):
            return self._power(e)
        if isinstance(e, sp.Piecewise):
            return self._choice(e)
        if isinstance(e, Relational):
            return self._relation(e)
        code = _FUNCTIONS.get(type(e))
        if code is None:
            raise TypeError(f"no counterpart for {type(e).__name__}: {e}")
        return _fold(code, [self.expression(argument) for argument in e.args])

    def _sum(self, e: sp.Add) -> Expression:
        plus = [t for t in e.args if not t.could_extract_minus_sign()]
        minus = [-t for t in e.args if t.could_extract_minus_sign()]
        if plus:
            result = _fold(Operation.ADD, [self.expression(t) for t in plus])
        else:
            result = Call(Operation.NEG, (self.expression(minus.pop(0)),))
        for term in minus:
            result = Call(Operation.SUB, (result, self.expression(term)))
        return result

    def _product(self, e: sp.Mul) -> Expression:
        coefficient, rest = e.as_coeff_Mul()
        if coefficient == -1:
            return Call(Operation.NEG, (self.expression(rest),))
        over = [f for f in e.args if not _is_reciprocal(f)]
        under = [sp.Pow(f.base, -f.exp) for f in e.args if _is_reciprocal(f)]
        top = _fold(Operation.MUL, [self.expression(f) for f in over]) if over else Number(1.0)
        if not under:
            return top
        return Call(Operation.DIV, (top, _fold(Operation.MUL, [self.expression(f) for f in under])))

    def _power(self, e: sp.Pow) -> Expression:
        exponent = e.exp
        if exponent.is_Rational and exponent < 0:
            return Call(Operation.DIV, (Number(1.0), self.expression(sp.Pow(e.base, -exponent))))
        base = self.expression(e.base)
        if exponent.is_Integer:
            return _fold(Operation.MUL, [base] * int(exponent))
        if exponent.is_Rational and exponent.q == 2:
            root = Call(Operation.SQRT, (base,))
            return _fold(Operation.MUL, [*[base] * (int(exponent.p) // 2), root])
        raise TypeError(f"no counterpart for the power {e}")

    def _choice(self, e: sp.Piecewise) -> Expression:
        *branches, (last, _) = e.args
        result = self.expression(last)
        for value, condition in reversed(branches):
            chosen = (self.expression(condition), self.expression(value), result)
            result = Call(Operation.SELECT, chosen)
        return result

    def _relation(self, e: Relational) -> Expression:
        left, right = (self.expression(side) for side in e.args)
        code, swapped = _RELATIONS[type(e)]
        return Call(code, (right, left) if swapped else (left, right))


_RELATIONS: Mapping[type, tuple[Operation, bool]] = {
    sp.StrictLessThan: (Operation.LT, False),
    sp.LessThan: (Operation.LE, False),
    sp.StrictGreaterThan: (Operation.LT, True),
    sp.GreaterThan: (Operation.LE, True),
    sp.Equality: (Operation.EQ, False),
    sp.Unequality: (Operation.NE, False),
}
_FUNCTIONS: Mapping[type, Operation] = {
    sp.sin: Operation.SIN,
    sp.cos: Operation.COS,
    sp.tan: Operation.TAN,
    sp.asin: Operation.ASIN,
    sp.acos: Operation.ACOS,
    sp.atan: Operation.ATAN,
    sp.atan2: Operation.ATAN2,
    sp.exp: Operation.EXP,
    sp.log: Operation.LOG,
    sp.Abs: Operation.ABS,
    sp.floor: Operation.FLOOR,
    sp.Min: Operation.MIN,
    sp.Max: Operation.MAX,
    sp.And: Operation.AND,
    sp.Or: Operation.OR,
    sp.Not: Operation.NOT,
}


def _is_reciprocal(e: sp.Expr) -> bool:
    return bool(e.is_Pow and e.exp.is_Rational and e.exp < 0)


def _fold(code: Operation, operands: Iterable[Expression]) -> Expression:
    """A call of many operands as nested calls of two; unary calls as they are."""
    several = list(operands)
    if len(several) == 1 and code not in (
        Operation.ADD,
        Operation.MUL,
        Operation.AND,
        Operation.OR,
    ):
        return several[0] if code in (Operation.MIN, Operation.MAX) else Call(code, (several[0],))
    combine: Callable[[Expression, Expression], Expression] = lambda a, b: Call(code, (a, b))  # noqa: E731
    return reduce(combine, several)
