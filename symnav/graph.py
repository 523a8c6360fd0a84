"""Named vertices of an equation: their definitions and the local partials between them.

An equation is written over quantities. Naming a quantity (``let``, ``rotate``, ``norm`` ...)
appends a vertex that holds its symbols, its definition over earlier symbols and its partial
derivatives toward its direct parents. Nothing is differentiated beyond one vertex: the Jacobian
of the equation comes from eliminating vertices (``derive``).

A vertex lives in a tangent space. For a vector that space is the vector itself; for a rotation it
is the three-dimensional space of its error, so that derivatives never run through quaternion
elements unless the user asks for raw columns. Vertices without symbols are allowed: they stand
for a tangent only (the error of a state block, or the virtual body rotation of ``rotate``).
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

import sympy as sp

Row = tuple[sp.Expr, ...]
Matrix = tuple[Row, ...]

ZERO, ONE = sp.Integer(0), sp.Integer(1)


@dataclass(frozen=True)
class Guard:
    """The declared domain of a named scalar: outside it the function reports a domain error.

    Attributes:
        lower: least value allowed.
        upper: greatest value allowed.
        substitute: what later steps read when the check fails, so that they stay finite.
        reason: one phrase for comments and messages.
    """

    lower: float
    upper: float
    substitute: float
    reason: str


@dataclass(frozen=True)
class Definition:
    """``symbol = expression``, in dependency order.

    Attributes:
        symbol: the name given.
        expression: over argument symbols and earlier definitions.
        item: True when it depends on an item's inputs (evaluated once per item).
        guard: the domain check on the value, if any.
        frozen: True when the error of the state must not reach it: the convention holds the
            value at the nominal state (a local-level frame that does not turn with the error).
    """

    symbol: sp.Symbol
    expression: sp.Expr
    item: bool
    guard: Guard | None = None
    frozen: bool = False


@dataclass(frozen=True)
class Vertex:
    """A point of the graph where derivatives meet.

    Attributes:
        name: unique; used to name the derivatives.
        size: dimension of its tangent space.
        partials: toward each direct parent, as rows of expressions, ``size`` by the parent's.
        item: True when any of its partials or definitions depends on an item's inputs.
    """

    name: str
    size: int
    partials: dict[str, Matrix] = field(hash=False)
    item: bool


@dataclass
class Graph:
    """The definitions and vertices of one equation, in the order they were made.

    ``reserved`` names (arguments, outputs, words of the target languages) are never given to a
    definition.
    """

    definitions: list[Definition] = field(default_factory=list)
    vertices: dict[str, Vertex] = field(default_factory=dict)
    reserved: frozenset[str] = frozenset()
    _owner: dict[sp.Symbol, tuple[str, int]] = field(default_factory=dict)
    _item: set[sp.Symbol] = field(default_factory=set)
    _moving: set[sp.Symbol] = field(default_factory=set)
    _multiples: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    _names: set[str] = field(default_factory=set)

    # -- leaves ------------------------------------------------------------------------------

    def argument(self, names: Sequence[str], *, item: bool = False) -> tuple[sp.Symbol, ...]:
        """Symbols for the elements of a run-time argument, without any tangent."""
        symbols = tuple(sp.Symbol(self._unique(name)) for name in names)
        if item:
            self._item.update(symbols)
        return symbols

    def source(self, name: str, size: int) -> Vertex:
        """A vertex without parents: the error of a state block or of an input."""
        return self._append(Vertex(self._unique_vertex(name), size, {}, item=False))

    def attach(
        self,
        name: str,
        symbols: Sequence[sp.Symbol],
        size: int,
        partials: dict[str, Matrix],
        *,
        identity: bool = True,
    ) -> Vertex:
        """A vertex over existing symbols: changes of its tangent move them.

        ``identity`` says that tangent element i is the change of ``symbols[i]``; otherwise the
        symbols depend on the tangent through a rule, and no ``let`` may use them directly.
        """
        item = self._is_item(symbols) or self._partials_item(partials)
        vertex = self._append(Vertex(self._unique_vertex(name), size, partials, item))
        if identity:
            self._owner.update({s: (vertex.name, i) for i, s in enumerate(symbols)})
        self._moving.update(symbols)
        return vertex

    # -- definitions -------------------------------------------------------------------------

    def define(
        self,
        name: str,
        expressions: Sequence[sp.Expr],
        *,
        suffixes: Sequence[str] | None = None,
        guard: Guard | None = None,
        frozen: bool = False,
    ) -> tuple[sp.Symbol, ...]:
        """Name expressions without making a vertex; the caller supplies a rule where they move."""
        labels = element_names(name, len(expressions), suffixes)
        symbols = []
        for label, expression in zip(labels, expressions, strict=True):
            free = f"{label}_" if label in self.reserved else label
            symbol = sp.Symbol(self._unique(free))
            item = self._is_item(expression.free_symbols)
            self.definitions.append(Definition(symbol, expression, item, guard, frozen))
            if item:
                self._item.add(symbol)
            if not frozen and self.moves(expression):
                self._moving.add(symbol)
            elif guard is None and is_multiple(expression):
                self._multiples[symbol] = expression
            symbols.append(symbol)
        return tuple(symbols)

    def let(
        self,
        name: str,
        expressions: Sequence[sp.Expr],
        *,
        suffixes: Sequence[str] | None = None,
        guard: Guard | None = None,
    ) -> tuple[sp.Symbol, ...]:
        """Name expressions and, where they depend on an error, make them a vertex.

        The local partials come from SymPy; every symbol that moves must own a vertex.
        """
        symbols = self.define(name, expressions, suffixes=suffixes, guard=guard)
        partials = self.local_partials(expressions)
        if partials:
            self.attach(name, symbols, len(symbols), partials)
        return symbols

    def local_partials(self, expressions: Sequence[sp.Expr]) -> dict[str, Matrix]:
        """Derivatives of expressions toward the vertices that own their symbols.

        A named multiple (half the interval) is seen through, so that products of derivatives can
        cancel what it is a multiple of.
        """
        used: dict[str, dict[int, sp.Symbol]] = {}
        for symbol in _ordered_symbols(expressions):
            if symbol not in self._moving:
                continue
            if symbol not in self._owner:
                raise AssertionError(f"{symbol} moves by a rule; build the vertex by that rule")
            name, index = self._owner[symbol]
            used.setdefault(name, {})[index] = symbol
        return {
            name: tuple(
                tuple(
                    derivative(expression, columns[k]).xreplace(self._multiples)
                    if k in columns
                    else ZERO
                    for k in range(self.vertices[name].size)
                )
                for expression in expressions
            )
            for name, columns in used.items()
        }

    def vertex(
        self,
        name: str,
        symbols: Sequence[sp.Symbol],
        partials: dict[str, Matrix],
        *,
        size: int | None = None,
    ) -> Vertex:
        """A vertex by rule: ``symbols`` (none for a virtual one) with the partials given."""
        return self.attach(name, symbols, len(symbols) if size is None else size, partials)

    def free_name(self, name: str, taken: set[str]) -> str:
        """A name that neither the graph nor ``taken`` has; it is added to ``taken``."""
        wanted = f"{name}_" if name in self.reserved else name
        for candidate in itertools.chain((wanted,), _numbered(wanted)):
            if candidate not in self._names and candidate not in taken:
                taken.add(candidate)
                return candidate
        raise AssertionError("unreachable")

    def adopt(self, definitions: Sequence[Definition]) -> None:
        """Append definitions made outside, with names from ``free_name``; they do not move."""
        for definition in definitions:
            self._names.add(definition.symbol.name)
            if definition.item:
                self._item.add(definition.symbol)
            self.definitions.append(definition)

    # -- questions ---------------------------------------------------------------------------

    def owner(self, symbol: sp.Symbol) -> str | None:
        """Name of the vertex whose tangent a symbol is, if it moves."""
        return self._owner[symbol][0] if symbol in self._owner else None

    def item_arguments(self, symbols: Iterable[sp.Symbol]) -> frozenset[sp.Symbol]:
        """Those of the symbols that differ from item to item."""
        return frozenset(symbol for symbol in symbols if symbol in self._item)

    def moves(self, *expressions: sp.Expr) -> bool:
        """True when an expression depends on the error of the state or of an input."""
        return any(not self._moving.isdisjoint(e.free_symbols) for e in expressions)

    def is_item(self, *expressions: sp.Expr) -> bool:
        """True when an expression depends on an item's inputs."""
        return any(self._is_item(e.free_symbols) for e in expressions)

    def _is_item(self, symbols: Iterable[sp.Basic]) -> bool:
        return not self._item.isdisjoint(symbols)

    def _partials_item(self, partials: dict[str, Matrix]) -> bool:
        return any(
            self.vertices[name].item or self.is_item(*itertools.chain(*rows))
            for name, rows in partials.items()
        )

    def _append(self, vertex: Vertex) -> Vertex:
        self.vertices[vertex.name] = vertex
        return vertex

    def _unique(self, name: str) -> str:
        return _first_free(name, self._names)

    def _unique_vertex(self, name: str) -> str:
        return _first_free(name, set(self.vertices))


def derivative(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """The derivative by a symbol, without the time SymPy's ``diff`` takes over sums and products.

    The base of a power stays whole, so that it is recognised as what has a name already.
    """
    if symbol not in expression.free_symbols:
        return ZERO
    if expression.is_Symbol:
        return ONE
    arguments = expression.args
    if expression.is_Add:
        return sp.Add(*(derivative(term, symbol) for term in arguments))
    if expression.is_Mul:
        parts = ((k, derivative(factor, symbol)) for k, factor in enumerate(arguments))
        return sp.Add(
            *(
                sp.Mul(*arguments[:k], part, *arguments[k + 1 :])
                for k, part in parts
                if part is not ZERO
            )
        )
    if expression.is_Pow and expression.exp.is_Number:
        base, exponent = arguments
        return sp.Mul(exponent, base ** (exponent - 1), derivative(base, symbol))
    return sp.diff(expression, symbol)


def is_multiple(expression: sp.Expr) -> bool:
    """True for a number other than one and minus one times a symbol."""
    number, rest = expression.as_coeff_Mul()
    return bool(rest.is_Symbol and number not in (1, -1))


def element_names(name: str, count: int, suffixes: Sequence[str] | None = None) -> tuple[str, ...]:
    """Names for the elements of a named quantity: ``a``, ``a_x a_y a_z`` or ``a_0 a_1 ...``."""
    if suffixes is None:
        if count == 1:
            return (name,)
        suffixes = ("x", "y", "z") if count == 3 else [str(i) for i in range(count)]
    return tuple(f"{name}_{suffix}" for suffix in suffixes)


def identity(size: int, scale: sp.Expr = ONE) -> Matrix:
    """The identity as rows of expressions, times ``scale``."""
    return tuple(tuple(scale if i == j else ZERO for j in range(size)) for i in range(size))


def rows_of(flat: Sequence[sp.Expr], columns: int) -> Matrix:
    """Rows of a matrix given row-major."""
    return tuple(tuple(flat[i : i + columns]) for i in range(0, len(flat), columns))


def transpose(matrix: Matrix) -> Matrix:
    """The transposed rows."""
    return tuple(zip(*matrix, strict=True))


def product(left: Matrix, right: Matrix) -> Matrix:
    """Matrix product of rows of expressions."""
    columns = transpose(right)
    return tuple(tuple(_dot(row, column) for column in columns) for row in left)


def _dot(row: Sequence[sp.Expr], column: Sequence[sp.Expr]) -> sp.Expr:
    """Sum of products; SymPy takes its time to multiply by zero and by one."""
    pairs = [(a, b) for a, b in zip(row, column, strict=True) if a is not ZERO and b is not ZERO]
    return sp.Add(*(b if a is sp.S.One else a if b is sp.S.One else a * b for a, b in pairs))


def _first_free(name: str, taken: set[str]) -> str:
    for candidate in itertools.chain((name,), _numbered(name)):
        if candidate not in taken:
            taken.add(candidate)
            return candidate
    raise AssertionError("unreachable")


def _numbered(name: str) -> Iterator[str]:
    return (f"{name}_{k}" for k in itertools.count(2))


def _ordered_symbols(expressions: Sequence[sp.Expr]) -> list[sp.Symbol]:
    found = set().union(*(e.free_symbols for e in expressions)) if expressions else set()
    return sorted(found, key=lambda symbol: symbol.name)
