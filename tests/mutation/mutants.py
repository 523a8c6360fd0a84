"""The mutants: every place of the mathematics where a sign, an order or a transpose can be wrong.

Three kinds of sites, found in the syntax tree:

sign
    ``a + b`` becomes ``a - b`` and the reverse; ``-a`` becomes ``a``. Signs that are data count as
    well: ``Operation.ADD`` and ``Operation.SUB``, ``operator.add`` and ``operator.sub``, the
    strings ``"+"`` and ``"-"``, alone or as a piece of a formatted one.
product
    The operands of ``cross``, ``quaternion_product`` and ``product`` change places; ``skew`` and
    ``_axis_cross``, which take a sign, get the opposite one.
transpose
    ``transpose(m)``, ``conjugate(q)`` and ``m.T`` become their argument, ``zip(*m)`` becomes ``m``,
    ``m[i][j]`` becomes ``m[j][i]`` and ``m[3 * i + j]`` becomes ``m[3 * j + i]``.

Only arithmetic counts. Left alone are signs inside subscripts and arguments of ``range`` (where an
element stands, not what it is: their transposes are mutants of their own) and inside formatted
text, sums of text, of lists and of sets, annotations, and augmented assignments, which in these
files gather lists and counts.
"""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Callable, Iterator
from copy import deepcopy
from dataclasses import dataclass
from pathlib import Path

ROOTS = (
    "symnav/graph.py",
    "symnav/quantities",
    "symnav/elimination.py",
    "symnav/binding.py",
    "symnav/derive.py",
    "symnav/equations",
    "symnav/blocks",
    "symnav/frames",
    "symnav/lower",
    "symnav/emit/c/expressions.py",
    "symnav/emit/numpy/expressions.py",
)
SWAPPED = {"cross", "quaternion_product", "product"}
SIGNED = {"skew": 1, "_axis_cross": 2}
DROPPED = {"transpose", "conjugate"}
OPPOSITES = {"ADD": "SUB", "SUB": "ADD", "add": "sub", "sub": "add", "neg": "pos"}
SIGNS = {"+": "-", "-": "+"}


@dataclass(frozen=True, order=True)
class Mutant:
    """One change of one file.

    Attributes:
        file: relative to the root of the project.
        function: qualified name of the innermost function or class, or ``module``.
        ordinal: among the sites of that function.
        kind: ``sign``, ``product`` or ``transpose``.
        change: the expression before and after.
        digest: of the function's syntax, so that a table tells when it is out of date.
        line: of the site; never written down.
    """

    file: str
    function: str
    ordinal: int
    kind: str
    change: str
    digest: str
    line: int

    @property
    def id(self) -> str:
        """Stable name: it does not move when other functions change."""
        return f"{self.file}::{self.function}#{self.ordinal}"


@dataclass(frozen=True)
class _Site:
    """A node that can be replaced, and how."""

    node: ast.AST
    kind: str
    replacement: ast.AST
    scope: tuple[str, ...]
    owner: ast.AST


def files(root: Path) -> list[str]:
    """Files with mutants, relative to the root."""
    found = []
    for entry in ROOTS:
        path = root / entry
        paths = sorted(path.rglob("*.py")) if path.is_dir() else [path]
        found += [p.relative_to(root).as_posix() for p in paths if p.is_file()]
    return found


def mutants(root: Path) -> list[Mutant]:
    """Every mutant of the project under ``root``, in the order of files and sites."""
    return [m for file in files(root) for m in mutants_of(file, (root / file).read_text("utf-8"))]


def mutants_of(file: str, source: str) -> list[Mutant]:
    """Every mutant of one file."""
    counts: dict[str, int] = {}
    found = []
    for site in _Finder().sites(ast.parse(source)):
        function = ".".join(site.scope) or "module"
        ordinal = counts[function] = counts.get(function, 0) + 1
        change = f"{_short(site.node)} -> {_short(site.replacement)}"
        digest = hashlib.sha256(ast.unparse(site.owner).encode()).hexdigest()[:12]
        line = getattr(site.node, "lineno", 0)
        found.append(Mutant(file, function, ordinal, site.kind, change, digest, line))
    return found


def mutated(source: str, mutant: Mutant) -> ast.Module:
    """The syntax tree of the file with one mutant in it."""
    tree = ast.parse(source)
    position = [m.id for m in mutants_of(mutant.file, source)].index(mutant.id)
    site = list(_Finder().sites(tree))[position]
    changed = _Replacer(site).visit(tree)
    assert isinstance(changed, ast.Module)
    return ast.fix_missing_locations(changed)


def _short(node: ast.AST) -> str:
    """The text of a node; of a long sum what is around its sign."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub)):
        left, right = " ".join(ast.unparse(node.left).split()), _short(node.right)
        sign = "+" if isinstance(node.op, ast.Add) else "-"
        bracketed = f"({right})" if isinstance(node.right, ast.BinOp) else right
        return f"{left if len(left) <= 40 else '..' + left[-38:]} {sign} {bracketed}"
    text = " ".join(ast.unparse(node).split())
    return text if len(text) <= 60 else f"{text[:29]}..{text[-29:]}"


class _Replacer(ast.NodeTransformer):
    """Puts the replacement where the node of the site stands."""

    def __init__(self, site: _Site) -> None:
        self._site = site

    def visit(self, node: ast.AST) -> ast.AST:
        if node is self._site.node:
            return ast.copy_location(self._site.replacement, node)
        visited: ast.AST = super().visit(node)
        return visited


class _Finder:
    """Walks a tree in the order of the text and finds the sites."""

    def sites(self, tree: ast.Module) -> Iterator[_Site]:
        """Every site of a module."""
        for statement in tree.body:
            yield from self._walk(statement, (), statement, inside_index=False)

    def _walk(
        self, node: ast.AST, scope: tuple[str, ...], owner: ast.AST, *, inside_index: bool
    ) -> Iterator[_Site]:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            scope, owner = (*scope, node.name), node
        for kind, replacement in _changes(node, inside_index):
            yield _Site(node, kind, replacement, scope, owner)
        for name, child in _children(node):
            if name in ("annotation", "returns"):
                continue
            index = inside_index or _is_index(node, name)
            yield from self._walk(child, scope, owner, inside_index=index)


def _children(node: ast.AST) -> Iterator[tuple[str, ast.AST]]:
    for name, value in ast.iter_fields(node):
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST):
                yield name, child


def _is_index(node: ast.AST, name: str) -> bool:
    """True where a child says which element, how many, or what something is called."""
    if isinstance(node, ast.FormattedValue):
        return True
    if isinstance(node, ast.Subscript):
        return name == "slice"
    return isinstance(node, ast.Call) and _name(node.func) == "range"


def _changes(node: ast.AST, inside_index: bool) -> Iterator[tuple[str, ast.AST]]:
    for rule in _RULES if not inside_index else (_flat_index,):
        change = rule(node)
        if change is not None:
            yield change


Change = tuple[str, ast.AST] | None


def _binary(node: ast.AST) -> Change:
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, (ast.Add, ast.Sub)):
        return None
    if _is_collection(node.left) or _is_collection(node.right):
        return None
    other = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
    return "sign", ast.BinOp(deepcopy(node.left), other, deepcopy(node.right))


def _is_collection(node: ast.expr) -> bool:
    """Text, lists and sets, whose sum or difference is no arithmetic."""
    if isinstance(node, ast.BinOp):
        return _is_collection(node.left) or _is_collection(node.right)
    if isinstance(node, ast.Constant):
        return isinstance(node.value, str)
    if isinstance(node, ast.Call):
        return _name(node.func) in ("list", "tuple", "set", "frozenset")
    collections = (ast.JoinedStr, ast.List, ast.ListComp, ast.Tuple, ast.Set, ast.SetComp)
    return isinstance(node, collections)


def _unary(node: ast.AST) -> Change:
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return "sign", deepcopy(node.operand)
    return None


def _sign_as_data(node: ast.AST) -> Change:
    if isinstance(node, ast.Attribute) and _name(node.value) in ("Operation", "operator"):
        opposite = OPPOSITES.get(node.attr)
        if opposite is not None:
            return "sign", ast.Attribute(deepcopy(node.value), opposite, ast.Load())
    if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value in SIGNS:
        return "sign", ast.Constant(SIGNS[node.value])
    return None


def _swapped(node: ast.AST) -> Change:
    if not isinstance(node, ast.Call):
        return None
    name = _name(node.func)
    if name in SWAPPED:
        swapped = deepcopy(node)
        first = swapped.args[0]
        if isinstance(first, ast.Starred):
            reverse = ast.Slice(step=ast.UnaryOp(ast.USub(), ast.Constant(1)))
            first.value = ast.Subscript(first.value, reverse, ast.Load())
        else:
            swapped.args[:2] = reversed(swapped.args[:2])
        return "product", swapped
    if name in SIGNED and len(node.args) > SIGNED[name]:
        opposite = deepcopy(node)
        place = SIGNED[name]
        opposite.args[place] = ast.UnaryOp(ast.USub(), opposite.args[place])
        return "product", opposite
    return None


def _transposed(node: ast.AST) -> Change:
    if isinstance(node, ast.Call) and len(node.args) == 1:
        only = node.args[0]
        if _name(node.func) in DROPPED:
            return "transpose", deepcopy(only)
        if _name(node.func) == "zip" and isinstance(only, ast.Starred):
            return "transpose", deepcopy(only.value)
    if isinstance(node, ast.Attribute) and node.attr == "T":
        return "transpose", deepcopy(node.value)
    return None


def _two_indices(node: ast.AST) -> Change:
    if not isinstance(node, ast.Subscript) or not isinstance(node.value, ast.Subscript):
        return None
    first, second = node.value.slice, node.slice
    if not isinstance(first, ast.Name) or not isinstance(second, ast.Name):
        return None
    if first.id == second.id:
        return None
    swapped = deepcopy(node)
    assert isinstance(swapped.value, ast.Subscript)
    swapped.value.slice, swapped.slice = swapped.slice, swapped.value.slice
    return "transpose", swapped


def _flat_index(node: ast.AST) -> Change:
    """``3 * i + j`` as an index."""
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, ast.Add):
        return None
    row, column = node.left, node.right
    if not isinstance(row, ast.BinOp) or not isinstance(row.op, ast.Mult):
        return None
    if not isinstance(row.right, ast.Name) or not isinstance(column, ast.Name):
        return None
    moved = ast.BinOp(deepcopy(row.left), ast.Mult(), deepcopy(column))
    return "transpose", ast.BinOp(moved, ast.Add(), deepcopy(row.right))


def _name(node: ast.AST) -> str:
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else ""


_RULES: tuple[Callable[[ast.AST], Change], ...] = (
    _binary, _unary, _sign_as_data, _swapped, _transposed, _two_indices,
)  # fmt: skip
