"""CasADi's own C for the same equation: its automatic Jacobian through the retract, its generator.

This is a witness and a back end of its own. It starts from the undifferentiated equation, so a
mistake in the structured derivation cannot reach it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import casadi as ca
import sympy as sp

from symnav.binding import STATE, Origin, Source
from symnav.blocks import Block, connecting
from symnav.derive import Derivation, derive_retract
from symnav.graph import Definition, Graph
from symnav.lower.casadi_bridge import to_casadi
from symnav.quantities import Rotation
from symnav.spec.records import Spec

Table = dict[sp.Symbol, ca.SX]


def sources(spec: Spec, derivations: Sequence[Derivation]) -> dict[str, str]:
    """CasADi's C and header for every entry, by path inside the package."""
    prefix = f"{spec.name}_casadi"
    generator = ca.CodeGenerator(
        f"{prefix}.c", {"with_header": True, "cpp": False, "casadi_int": "long long int"}
    )
    for derivation in derivations:
        generator.add(function(spec, derivation, f"{prefix}_{derivation.name}"))
    text = generator.dump()
    header = _header(spec, derivations, prefix)
    return {f"casadi/{prefix}.c": text, f"casadi/{prefix}.h": header}


def function(spec: Spec, derivation: Derivation, name: str) -> ca.Function:
    """One entry: inputs in argument order (one item's), outputs dense in the order of the IR."""
    inputs = {a: ca.SX.sym(a, _size(spec, a)) for a in derivation.arguments}
    plain = _evaluate(spec, derivation, inputs, {}, {})
    held = {d.symbol: plain.table[d.symbol] for d in derivation.equation.definitions if d.frozen}
    outputs = [_output(spec, derivation, o.name, inputs, plain, held) for o in derivation.outputs]
    results = [ca.densify(e) for e in outputs]
    return ca.Function(name, list(inputs.values()), results)


class _Evaluated:
    """The equation at one point: its table of symbols and its outputs."""

    def __init__(self, table: Table, outputs: Mapping[str, ca.SX]) -> None:
        self.table = table
        self.outputs = outputs


def _evaluate(
    spec: Spec,
    derivation: Derivation,
    inputs: Mapping[str, ca.SX],
    moved: Mapping[str, ca.SX],
    held: Mapping[sp.Symbol, ca.SX],
) -> _Evaluated:
    """The equation with some arguments replaced by moved ones and frozen values held."""
    table: Table = {}
    for symbol, origin in derivation.origins.items():
        if origin.argument in inputs:
            table[symbol] = _load(derivation.origins, origin, {**inputs, **moved})
    _define(derivation.equation.definitions, table, held)
    outputs = {
        name: ca.vertcat(*[to_casadi(e, table) for e in elements])
        for name, elements in derivation.equation.outputs.items()
    }
    return _Evaluated(table, outputs)


def _load(
    origins: Mapping[sp.Symbol, Origin], origin: Origin, arguments: Mapping[str, ca.SX]
) -> ca.SX:
    vector = arguments[origin.argument]
    if origin.slot is None:
        return vector[origin.index]
    slot = _load(origins, origins[origin.slot], arguments)
    chosen = ca.SX(0)
    for k in range(vector.numel() - origin.index):
        chosen = chosen + ca.if_else(slot == k, vector[origin.index + k], 0)
    return chosen


def _define(
    definitions: Sequence[Definition], table: Table, held: Mapping[sp.Symbol, ca.SX]
) -> None:
    for definition in definitions:
        if definition.symbol in held:
            table[definition.symbol] = held[definition.symbol]
        elif definition.symbol not in table:
            table[definition.symbol] = to_casadi(definition.expression, table)


def _output(
    spec: Spec,
    derivation: Derivation,
    name: str,
    inputs: Mapping[str, ca.SX],
    plain: _Evaluated,
    held: Mapping[sp.Symbol, ca.SX],
) -> ca.SX:
    equation = derivation.equation
    first = next(iter(equation.outputs))
    if name in plain.outputs:
        return plain.outputs[name]
    if name == "jacobian":
        return _state_jacobian(spec, derivation, inputs, held, first)
    if name in equation.rates:
        output, source = equation.rates[name]
        return _input_jacobian(spec, derivation, inputs, held, output, source)
    if name in equation.covariances:
        source, elements = equation.covariances[name]
        j = _input_jacobian(spec, derivation, inputs, held, first, source)
        flat = ca.vertcat(*[to_casadi(e, plain.table) for e in elements])
        p = ca.reshape(flat, source.size, source.size).T
        return ca.vec((j @ p @ j.T).T)
    (source,) = [s for s in equation.sources if f"jacobian_{s.name}" == name]
    return _input_jacobian(spec, derivation, inputs, held, first, source)


def _state_jacobian(
    spec: Spec,
    derivation: Derivation,
    inputs: Mapping[str, ca.SX],
    held: Mapping[sp.Symbol, ca.SX],
    output: str,
) -> ca.SX:
    d = ca.SX.sym("d", spec.layout.error_size)
    retract = derive_retract(spec, frozenset())
    table: Table = {}
    arguments = {**inputs, "d": d}
    for symbol, origin in retract.origins.items():
        if origin.argument in arguments:
            table[symbol] = arguments[origin.argument][origin.index]
    missing = [s for s, o in retract.origins.items() if o.argument not in arguments]
    for symbol in missing:
        table[symbol] = ca.SX.sym(symbol.name)
    _define(retract.definitions, table, {})
    moved = ca.vertcat(*[to_casadi(e, table) for e in retract.equation.outputs["value"]])
    value = _evaluate(spec, derivation, inputs, {STATE: moved}, held).outputs[output]
    return ca.substitute(ca.jacobian(value, d), d, ca.SX.zeros(d.numel()))


def _input_jacobian(
    spec: Spec,
    derivation: Derivation,
    inputs: Mapping[str, ca.SX],
    held: Mapping[sp.Symbol, ca.SX],
    output: str,
    source: Source,
) -> ca.SX:
    d = ca.SX.sym("d", source.size)
    x = inputs[source.name]
    raw = source.name in derivation.equation.raw
    moved = x + d if raw else _moved_input(spec, source, inputs, d)
    value = _evaluate(spec, derivation, inputs, {source.name: moved}, held).outputs[output]
    return ca.substitute(ca.jacobian(value, d), d, ca.SX.zeros(d.numel()))


def _moved_input(spec: Spec, source: Source, inputs: Mapping[str, ca.SX], d: ca.SX) -> ca.SX:
    """An input moved by its own retract; what else that reads is held."""
    block = spec.inputs[source.name].block
    nominal = _Nominal(spec, inputs)
    stored = nominal.loaded(block, inputs[source.name])
    error = nominal.graph.argument([f"d{i}" for i in range(source.size)])
    nominal.table.update(zip(error, _elements(d), strict=True))
    moved = block.retract(nominal.graph, stored, error, nominal)
    _define(nominal.graph.definitions, nominal.table, {})
    return ca.vertcat(*[to_casadi(e, nominal.table) for e in moved])


class _Nominal:
    """The nominal state and inputs, which the retract of an input may read."""

    def __init__(self, spec: Spec, inputs: Mapping[str, ca.SX]) -> None:
        self.graph = Graph()
        self.table: Table = {}
        self._spec = spec
        self._inputs = inputs

    def loaded(self, block: Block, elements: ca.SX) -> tuple[sp.Symbol, ...]:
        """Symbols of a block's elements, worth those given."""
        names = [f"{block.name}_{i}" for i in range(block.storage_size)]
        symbols = self.graph.argument(names)
        self.table.update(zip(symbols, _elements(elements), strict=True))
        return symbols

    def matrix_between(self, source: str, target: str) -> tuple[sp.Expr, ...]:
        """Nine entries of the rotation from ``source`` to ``target``."""
        layout, inputs = self._spec.layout, self._spec.inputs
        shared = [given.block for given in inputs.values() if not given.item]
        (block,) = connecting(layout.blocks, shared, source, target)
        name, start = block.name, 0
        if name in layout.places:
            start, name = layout.places[name].start, STATE
        stored = self._inputs[name][start : start + block.storage_size]
        vertex = self.graph.source(f"error of {block.name}", block.error_size).name
        rotation = block.attach(self.graph, self.loaded(block, stored), vertex, self)
        assert isinstance(rotation, Rotation)
        m = rotation.matrix
        if rotation.source == source:
            return m
        return tuple(m[3 * j + i] for i in range(3) for j in range(3))


def _elements(vector: ca.SX) -> Iterator[ca.SX]:
    return (vector[i] for i in range(vector.numel()))


def _size(spec: Spec, argument: str) -> int:
    if argument == STATE:
        return spec.layout.size
    return spec.inputs[argument].block.storage_size


def _header(spec: Spec, derivations: Sequence[Derivation], prefix: str) -> str:
    """Prototypes of the functions and of their work sizes."""
    lines = [f"/* CasADi's own C for {spec.name}: prototypes. */"]
    for derivation in derivations:
        name = f"{prefix}_{derivation.name}"
        lines.append(
            f"int {name}(const double **arg, double **res, long long int *iw, double *w, int mem);"
        )
        lines.append(
            f"int {name}_work(long long int *sz_arg, long long int *sz_res, "
            "long long int *sz_iw, long long int *sz_w);"
        )
    return "\n".join(lines) + "\n"
