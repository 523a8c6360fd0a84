"""``docs/ICD.md``: the interface control document of a bundle."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import prod

from symnav import ir
from symnav.emit import c
from symnav.emit.c.border import SUFFIX as BORDER
from symnav.emit.c.documentation import status_text, statuses
from symnav.emit.c.entries import EntryPoint
from symnav.emit.c.header import Section
from symnav.emit.c.interface import range_text
from symnav.emit.c.store import is_jacobian, layout_of
from symnav.emit.templates import render
from symnav.export.building import build_files
from symnav.export.records import Bundle, Tree
from symnav.figures import readable
from symnav.lower.passes.counts import count_operations

PATH = "docs/ICD.md"

Table = list[str]


def document(bundle: Bundle) -> str:
    """The document as Markdown."""
    module = bundle.trees[0].module
    return render(
        "export/docs/ICD.md.j2",
        name=bundle.name,
        summary=build_files.summary(bundle),
        library=build_files.library_name(bundle),
        generator=module.generator,
        version=build_files.version(),
        specification=module.digest,
        layout=module.state.digest,
        flags=" ".join(build_files.FLAGS),
        trees=[_tree(tree) for tree in bundle.trees],
        statuses=table(
            ("status", "value", "meaning"),
            [(status.name, str(status.value), status_text(status)) for status in ir.Status],
        ),
        storage=_storage(module.state, bundle),
        errors=_errors(module.state, bundle),
        has_state=bool(module.state.blocks),
        size=module.state.size,
        error_size=module.state.error_size,
    )


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> Table:
    """Lines of a Markdown table."""
    cells = [[_cell(text) for text in row] for row in rows]
    return [
        f"| {' | '.join(head)} |",
        f"|{'|'.join('---' for _ in head)}|",
        *(f"| {' | '.join(row)} |" for row in cells),
    ]


def _cell(text: str) -> str:
    """Text that stays inside its cell and says what was written."""
    flat = " ".join(text.split())
    for mark in ("\\", "|", "*", "_", "<", "["):
        flat = flat.replace(mark, f"\\{mark}") if not flat.startswith("`") else flat
    return flat or "-"


def _code(text: str) -> str:
    return f"`{text}`" if text else ""


def _range(domain: ir.Domain) -> str:
    return range_text(domain).removeprefix("range ")


def _storage(state: ir.State, bundle: Bundle) -> Table:
    macro = bundle.name.upper()
    rows = [
        (
            _code(block.name),
            block.kind,
            _code(f"{macro}_X_{block.name.upper()}"),
            str(block.storage.start),
            str(block.storage.size),
            " ".join(block.storage.labels),
            block.storage.unit,
            block.storage.frame,
            _range(block.storage),
        )
        for block in state.blocks
    ]
    head = ("block", "kind", "enumerator", "first", "size", "elements", "unit", "frame", "range")
    return table(head, rows)


def _errors(state: ir.State, bundle: Bundle) -> Table:
    macro = bundle.name.upper()
    rows = [
        (
            _code(block.name),
            _code(f"{macro}_E_{block.name.upper()}"),
            str(block.error_start),
            str(block.error_size),
            " ".join(block.error_labels),
            block.error_unit,
            block.error_frame,
            block.convention,
        )
        for block in state.blocks
    ]
    head = ("block", "enumerator", "first", "size", "elements", "unit", "frame", "convention")
    return table(head, rows)


def _tree(tree: Tree) -> dict[str, object]:
    module = tree.module
    return {
        "prefix": tree.prefix,
        "macro": tree.prefix.upper(),
        "scalar": module.scalar.value,
        "digest": f"0x{module.state.digest[:8].upper()}U",
        "functions": [_function(tree, section) for section in c.sections(module)],
    }


def _function(tree: Tree, section: Section) -> dict[str, object]:
    function = section.kernel.function
    return {
        "symbol": section.kernel.symbol,
        "title": function.title,
        "role": function.role.value,
        "equation": [line for line in function.equation.splitlines() if line.strip()],
        "source": function.source,
        "conventions": function.conventions,
        "digest": build_files.model_digest(tree, function.name),
        "kernel": build_files.kernel_path(tree, function.name),
        "limit": f"{section.kernel.symbol.upper()}_MAX_ITEMS",
        "maximum": function.maximum,
        "policy": function.items.value,
        "guarded": function.checks_domain,
        "border": section.kernel.symbol + BORDER if function.checks_at_border else "",
        "guards": list(_guards(function)),
        "inputs": _inputs(function),
        "outputs": _outputs(function),
        "operations": _operations(function),
        "entries": [_entry(function, section, entry) for entry in section.entries],
    }


def _guards(function: ir.Function) -> Iterator[str]:
    for step in (*function.shared, *function.item):
        if isinstance(step, ir.Check):
            what = step.comment.strip().rstrip(".") or step.target
            limits = f"{readable(step.lower)} to {readable(step.upper)}"
            yield f"{what}: {limits}, else {step.status.name}"


def _inputs(function: ir.Function) -> Table:
    rows = [
        (
            _code(argument.name),
            _elements(argument, domain),
            domain.name if argument.name == "x" else domain.description,
            "int32" if argument.integer else "real",
            domain.unit,
            domain.frame,
            _range(domain),
        )
        for argument in function.arguments
        for domain in argument.domains
    ]
    return table(("input", "elements", "meaning", "type", "unit", "frame", "range"), rows)


def _elements(argument: ir.Argument, domain: ir.Domain) -> str:
    last = domain.start + domain.size - 1
    span = f"{domain.start}..{last}" if domain.size > 1 else str(domain.start)
    return f"{span} of {argument.size}{' per item' if argument.item else ''}"


def _outputs(function: ir.Function) -> Table:
    rows = []
    for output in function.outputs:
        per_item = output.item and function.maximum is not None
        axes = (["n"] if per_item else []) + [str(length) for length in output.shape]
        rows.append(
            (
                _code(output.name),
                " x ".join(axes) or "1",
                f"{len(output.entries)} of {prod(output.shape)}{' per item' if per_item else ''}",
                _units(function, output),
                output.frame,
                _memory(function, output),
                output.description,
            )
        )
    head = ("output", "shape", "non-zeros", "unit", "frame", "memory", "meaning")
    return table(head, rows)


def _units(function: ir.Function, output: ir.Output) -> str:
    """Unit of a value; of a Jacobian, of what is differenced by the unit of every block it has."""
    if not is_jacobian(output):
        return output.unit
    columns = [entry.index[-1] for entry in output.entries]
    reached = [index.base if isinstance(index, ir.Offset) else index for index in columns]
    sections = [
        f"{section.unit} ({section.name})"
        for section in output.columns
        if any(section.start <= column < section.start + section.size for column in reached)
    ]
    return f"{function.outputs[0].unit} per {', '.join(sections)}" if sections else "no non-zero"


def _memory(function: ir.Function, output: ir.Output) -> str:
    layout = layout_of(function, output)
    terms = [
        f"{stride if stride > 1 else ''}{' ' if stride > 1 else ''}{name}"
        for name, stride in zip(("row", "column"), layout.strides, strict=False)
    ]
    if len(layout.strides) == 1 and is_jacobian(output):
        terms = [terms[0].replace("row", "column")]
    if layout.item is not None:
        terms.insert(0, f"{layout.item} item" if layout.item > 1 else "item")
    return " + ".join(terms) or "one element"


def _operations(function: ir.Function) -> str:
    counts = count_operations(function)
    shared, item = counts.shared.total(), counts.item.total()
    if function.maximum is None:
        return f"{shared} operations a call"
    return f"{shared} operations a call and {item} an item"


def _entry(function: ir.Function, section: Section, entry: EntryPoint) -> dict[str, object]:
    *front, last = entry.prototype(section.kernel.target.status)
    rows = [
        (_code(p.name), p.direction, _code(_type(p.declaration)), p.text) for p in entry.parameters
    ]
    return {
        "symbol": entry.symbol,
        "brief": entry.brief,
        "prototype": [*front, f"{last};"],
        "parameters": table(("parameter", "direction", "type", "content"), rows),
        "statuses": ", ".join(status.name for status in statuses(function, entry)),
    }


def _type(declaration: str) -> str:
    """The type of a parameter without its name's brackets."""
    return declaration.partition("[")[0].rpartition(" ")[0]
