"""What people read: README, interface control document, trace table, deviations, metrics."""

from __future__ import annotations

from collections.abc import Mapping

from symnav.emit.templates import render
from symnav.export.building import build_files, glue
from symnav.export.documents import example, icd, metrics, trace
from symnav.export.documents.deviations import DEVIATIONS
from symnav.export.records import Bundle

EXAMPLE = "example/example.c"


def files(bundle: Bundle) -> Mapping[str, str]:
    """The documents and the example they show."""
    program = example.program(bundle)
    return {
        "README.md": _readme(bundle, program),
        EXAMPLE: program,
        icd.PATH: icd.document(bundle),
        trace.PATH: trace.table(bundle),
        "docs/misra_deviations.md": render(
            "export/docs/misra_deviations.md.j2", name=bundle.name, deviations=DEVIATIONS
        ),
        metrics.PATH: metrics.document(bundle),
    }


def regenerate(bundle: Bundle) -> str:
    """The command that makes the bundle again from its own specification; empty without one."""
    if not bundle.spec.toml:
        return ""
    options = bundle.options
    tolerance = "".join(f" --tolerance {word}" for word in options.tolerance.words)
    batches = " --batches" if options.batches else ""
    guards = f" --guards {options.guards.value}" if options.guards else ""
    chosen = f"{options.scalar.value}{tolerance}{batches}{guards}"
    return f"symnav export spec.toml --to DIR --scalar {chosen}"


def _readme(bundle: Bundle, program: str) -> str:
    module = bundle.trees[0].module
    functions = list(bundle.functions())
    rows = [
        (f"`{tree.prefix}_{function.name}`", tree.module.scalar.value, function.title)
        for tree, function in functions
    ]
    first_tree, first = functions[0]
    return render(
        "export/docs/README.md.j2",
        name=bundle.name,
        macro=bundle.name.upper(),
        summary=build_files.summary(bundle),
        library=build_files.library_name(bundle),
        generator=module.generator,
        trees=bundle.trees,
        functions=functions,
        border=any(function.checks_at_border for _, function in functions),
        functions_table=icd.table(("function", "type", "what it computes"), rows),
        has_state=bool(module.state.blocks),
        size=module.state.size,
        error_size=module.state.error_size,
        example=program,
        zephyr=glue.zephyr_option(bundle),
        regenerate=regenerate(bundle),
        model_macro=f"{first_tree.prefix}_{first.name}".upper() + "_MODEL_DIGEST",
    )
