"""A lowered function as a graph in which every different value occurs once.

What the C computes in two places under two names is one node here, so that a fact found for one is
a fact about both.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from symnav import ir
from symnav.export.arithmetic.walk import evaluate, run

Operation = ir.Operation
COMPARISONS = frozenset({Operation.LT, Operation.LE, Operation.EQ, Operation.NE})


@dataclass(frozen=True, slots=True)
class Node:
    """One value.

    Attributes:
        index: its place; operands come before.
        content: an operation, a literal, an element of an argument, or a guard.
        operands: places of what it is computed from.
    """

    index: int
    content: Operation | ir.Number | ir.Load | ir.Check
    operands: tuple[int, ...] = ()

    def does(self, operation: Operation) -> bool:
        """True for the result of an operation."""
        return self.content is operation

    @property
    def number(self) -> float | None:
        """The literal it is, if it is one."""
        return self.content.value if isinstance(self.content, ir.Number) else None


@dataclass
class Tracer:
    """The ``walk.Arithmetic`` whose numbers are places in a list of nodes."""

    nodes: list[Node] = field(default_factory=list)
    known: dict[object, int] = field(default_factory=dict)

    def number(self, value: float) -> int:
        """A literal."""
        return self._place(ir.Number(value))

    def load(self, load: ir.Load) -> int:
        """An element of an argument."""
        return self._place(load)

    def apply(self, operation: Operation, operands: Sequence[int]) -> int:
        """An operation on nodes."""
        return self._place(operation, tuple(operands))

    def check(self, step: ir.Check, value: int) -> int:
        """A guard on a node."""
        return self._place(step, (value,))

    def _place(
        self, content: Operation | ir.Number | ir.Load | ir.Check, operands: tuple[int, ...] = ()
    ) -> int:
        # A literal is told apart by its text: 0.0 and -0.0 compare equal.
        key = (repr(content) if isinstance(content, ir.Number) else content, operands)
        if key not in self.known:
            self.known[key] = len(self.nodes)
            self.nodes.append(Node(len(self.nodes), content, operands))
        return self.known[key]


@dataclass(frozen=True)
class Graph:
    """All values of a function.

    Attributes:
        function: whose values they are.
        nodes: operands before what is computed from them.
        results: for every output, the node of each of its entries.
    """

    function: ir.Function
    nodes: tuple[Node, ...]
    results: Mapping[str, tuple[int, ...]]

    def cone(self, ends: Iterable[int]) -> tuple[Node, ...]:
        """Every node some nodes depend on, themselves included, in order."""
        wanted: set[int] = set()
        pending = list(ends)
        while pending:
            index = pending.pop()
            if index not in wanted:
                wanted.add(index)
                pending.extend(self.nodes[index].operands)
        return tuple(self.nodes[index] for index in sorted(wanted))


def trace(function: ir.Function) -> Graph:
    """The graph of a function; the item part follows the shared part."""
    tracer = Tracer()
    shared = run(function.shared, tracer.load, {}, tracer)
    values = run(function.item, tracer.load, shared, tracer)
    results = {
        output.name: tuple(
            evaluate(entry.value, tracer.load, values, tracer) for entry in output.entries
        )
        for output in function.outputs
    }
    return Graph(function, tuple(tracer.nodes), results)
