"""Parameters of the entry points: what stands in a prototype, in its order, with its meaning."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import prod

from symnav import ir
from symnav.emit.c.kernel import Kernel
from symnav.emit.c.pieces import Parameter
from symnav.emit.c.rounding import rounding_text
from symnav.emit.c.store import is_jacobian, layout_of
from symnav.figures import readable

EPOCHS = Parameter("int32_t epochs", "epochs", False, "in", "Number of epochs.")


@dataclass(frozen=True, slots=True)
class Interface:
    """Parameters of one function's entry points."""

    kernel: Kernel

    @property
    def function(self) -> ir.Function:
        """The function."""
        return self.kernel.function

    @property
    def limit(self) -> str:
        """Macro that holds the largest number of items."""
        return f"{self.kernel.target.macro}_{self.function.name.upper()}_MAX_ITEMS"

    @property
    def count(self) -> Parameter:
        """The number of items."""
        return Parameter("int32_t n", "n", False, "in", f"Number of items, at most {self.limit}.")

    def arguments(self) -> list[Parameter]:
        """Inputs of a call for one epoch."""
        parameters: list[Parameter] = []
        for argument in self.function.arguments:
            parameters.append(self._argument(argument))
            if self.kernel.mapped and len(parameters) == 1:
                parameters.append(self.count)
        return parameters

    def stepped_arguments(self) -> list[Parameter]:
        """Inputs of a call for many epochs."""
        parameters: list[Parameter] = []
        for argument in self.function.arguments:
            parameters.append(self._argument(argument, sized=False))
            parameters.append(
                Parameter(
                    f"int32_t {argument.name}_step",
                    f"{argument.name}_step",
                    False,
                    "in",
                    f"Elements from one epoch of {argument.name} to the next; 0 for the same.",
                )
            )
            if self.kernel.mapped and len(parameters) == 2:
                parameters.append(self.count)
        return parameters

    def outputs(self, outputs: Iterable[ir.Output], *, fewer: int = 0) -> list[Parameter]:
        """Dense outputs of one epoch; ``fewer`` items where rows are differenced."""
        return [self._dense(output, fewer) for output in outputs]

    def nonzero_outputs(self) -> list[Parameter]:
        """Outputs of the call that stores non-zeros only."""
        return [
            self._nonzeros(output) if is_jacobian(output) else self._dense(output, 0)
            for output in self.function.outputs
            if output.entries or not is_jacobian(output)
        ]

    def blocked_arguments(self) -> list[Parameter]:
        """Inputs of a call for many epochs that lie side by side in blocks."""
        return [
            self._blocked(
                "const ", argument.name, argument.size, argument.integer,
                "in", _argument_text(argument, self.kernel.target.macro),
            )
            for argument in self.function.arguments
        ]  # fmt: skip

    def blocked_outputs(self) -> list[Parameter]:
        """Outputs of such a call: values, non-zeros of Jacobians and the status of every epoch."""
        parameters = []
        for output in self.function.outputs:
            if not is_jacobian(output):
                size, text = prod(output.shape), self._dense_text(output, 0)
                parameters.append(self._blocked("", output.name, size, False, "out", text))
            elif output.entries:
                one = self._nonzeros(output)
                size = len(output.entries)
                parameters.append(self._blocked("", one.name, size, False, "out", one.text))
        status = self._array("uint8_t", "status", "")
        text = "Status of every epoch, one byte each, in the order of the epochs."
        return [*parameters, Parameter(status, "status", True, "out", text)]

    def _blocked(
        self, const: str, name: str, size: int, integer: bool, way: str, text: str
    ) -> Parameter:
        kind = "int32_t" if integer else self.kernel.target.real
        declared = const + self._array(kind, name, "")
        # The shape of one epoch is part of the shape of a block.
        meaning = text.partition("] ")[2] if text.startswith("[") else text
        return Parameter(declared, name, True, way, f"[blocks x {size} x L] {meaning}")

    def stacked_outputs(self, *, nonzeros: bool = False) -> list[Parameter]:
        """Outputs of a call for many epochs: Jacobians in full, or their non-zeros."""
        real = self.kernel.target.real
        parameters = [
            self._stacked_nonzeros(output)
            if nonzeros and is_jacobian(output)
            else Parameter(
                self._array(real, output.name, ""),
                output.name,
                True,
                "out",
                f"As in one call, epoch after epoch, by row: {self._stack(output)}.",
            )
            for output in self.function.outputs
            if output.entries or not (nonzeros and is_jacobian(output))
        ]
        text = "Status of every epoch, one byte each."
        status = self._array("uint8_t", "status", "")
        parameters.append(Parameter(status, "status", True, "out", text))
        if self.kernel.mapped:
            parameters.append(
                Parameter(
                    self._array("uint8_t", "item_status", ""),
                    "item_status",
                    True,
                    "out",
                    "[epochs x n] Status of every item; not written for an epoch whose inputs "
                    "shared by all items fail.",
                )
            )
        return parameters

    def item_status(self) -> list[Parameter]:
        """The status of every item, where the function is mapped."""
        if not self.kernel.mapped:
            return []
        return [
            Parameter(
                self._array("uint8_t", "item_status", self.limit),
                "item_status",
                True,
                "out",
                "[n] Status of every item, one byte each.",
            )
        ]

    def _argument(self, argument: ir.Argument, *, sized: bool = True) -> Parameter:
        kind = "int32_t" if argument.integer else self.kernel.target.real
        macro = self.kernel.target.macro
        size = f"{macro}_STATE_SIZE" if argument.name == "x" else str(argument.size)
        if argument.item:
            size = self.limit if argument.size == 1 else f"{self.limit} * {argument.size}"
        return Parameter(
            "const " + self._array(kind, argument.name, size if sized else ""),
            argument.name,
            True,
            "in",
            _argument_text(argument, macro),
        )

    def _dense(self, output: ir.Output, fewer: int) -> Parameter:
        size = str(prod(output.shape))
        if output.item and self.kernel.mapped:
            items = f"({self.limit} - {fewer})" if fewer else self.limit
            size = items if size == "1" else f"{items} * {size}"
        return Parameter(
            self._array(self.kernel.target.real, output.name, size),
            output.name,
            True,
            "out",
            self._dense_text(output, fewer),
        )

    def _nonzeros(self, output: ir.Output) -> Parameter:
        per_item = output.item and self.kernel.mapped
        count = len(output.entries)
        size = f"{count} * {self.limit}" if per_item else str(count)
        text = f"The {count} structural non-zeros of {output.name}, in the order of the tables"
        if per_item:
            text += f"; non-zero k of item i stands at [k * {self.limit} + i]"
        name = f"{output.name}_nz"
        return Parameter(
            self._array(self.kernel.target.real, name, size), name, True, "out", f"{text}."
        )

    def _stacked_nonzeros(self, output: ir.Output) -> Parameter:
        """Non-zeros of many epochs; those of items in columns as long as there are items."""
        name, count = f"{output.name}_nz", len(output.entries)
        items = output.item and self.kernel.mapped
        shape = f"[epochs x {count} x n]" if items else f"[epochs x {count}]"
        text = f"{shape} Structural non-zeros of {output.name}, in the order of the tables."
        return Parameter(self._array(self.kernel.target.real, name, ""), name, True, "out", text)

    def _array(self, kind: str, name: str, size: str) -> str:
        restrict = f"{self.kernel.target.macro}_RESTRICT"
        return f"{kind} {name}[{restrict}{' ' + size if size else ''}]"

    def _dense_text(self, output: ir.Output, fewer: int) -> str:
        lengths = [str(length) for length in output.shape]
        if output.item and self.kernel.mapped:
            lengths.insert(0, f"n - {fewer}" if fewer else "n")
        shape = f"[{' x '.join(lengths)}] " if lengths else ""
        order = ""
        if len(lengths) > 1:
            by_column = self.function.column_major and is_jacobian(output)
            leading = layout_of(
                self.function, output, items=(self.function.maximum or 0) - fewer
            ).strides[-1]
            order = f", by column ({leading} from one to the next)" if by_column else ", by row"
        unit = "" if output.unit in ("", "1") else f"{output.unit}{_in(output.frame)}: "
        roundoff = self.kernel.target.unit_roundoff
        rounding = rounding_text(output, roundoff, differenced=bool(fewer))
        said = f"{output.description.rstrip('.')}{order}"
        return f"{shape}{unit}{said}{'; ' if rounding else ''}{rounding}."

    def _stack(self, output: ir.Output) -> str:
        lengths = ["epochs"]
        lengths += ["n"] if output.item and self.kernel.mapped else []
        lengths += [str(length) for length in output.shape]
        return f"[{' x '.join(lengths)}]"


def _argument_text(argument: ir.Argument, macro: str) -> str:
    if argument.name == "x":
        return "State vector; its blocks, units and ranges stand in the header of the types."
    lengths = (["n"] if argument.item else []) + [str(argument.size)]
    parts = [f"[{' x '.join(lengths)}]"]
    parts += [domain_text(domain) for domain in argument.domains]
    return " ".join(parts)


def domain_text(domain: ir.Domain) -> str:
    """Unit, frame, meaning and declared range of a run of elements."""
    unit = "" if domain.unit == "1" else domain.unit
    lead = f"{unit}{_in(domain.frame)}".strip()
    text = f"{lead}: " if lead else ""
    return text + meaning_text(domain)


def meaning_text(domain: ir.Domain) -> str:
    """Meaning, where it was given, and declared range."""
    parts = (domain.description.strip().rstrip("."), range_text(domain))
    return "; ".join(part for part in parts if part) + "."


def range_text(domain: ir.Domain) -> str:
    """The declared range, once where it is the same for all elements."""
    pairs = list(dict.fromkeys(zip(domain.lower, domain.upper, strict=True)))
    if domain.kind is ir.Kind.QUATERNION:
        order = " ".join(domain.labels)
        return f"unit quaternion, order {order}, q.q = 1 within {readable(domain.tolerance)}"
    if domain.kind is ir.Kind.UNREAD:
        return "not read"
    if domain.kind is ir.Kind.MATRIX:
        return f"rotation matrix, by row, orthonormal within {readable(domain.tolerance)}"
    return "range " + ", ".join(f"{readable(low)} to {readable(high)}" for low, high in pairs)


def _in(frame: str) -> str:
    if not frame:
        return ""
    return f" {frame}" if "->" in frame else f" in {frame}"
