"""CasADi's own C for hand-written functions, as the pipeline would hand it to a package."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import casadi as ca

from symnav import ir

Op = ir.Operation

_SYMBOLIC: Mapping[ir.Operation, Callable[..., ca.SX]] = {
    Op.ADD: lambda a, b: a + b,
    Op.SUB: lambda a, b: a - b,
    Op.MUL: lambda a, b: a * b,
    Op.DIV: lambda a, b: a / b,
    Op.NEG: lambda a: -a,
    Op.SQRT: ca.sqrt,
    Op.SIN: ca.sin,
    Op.COS: ca.cos,
    Op.TAN: ca.tan,
    Op.ASIN: ca.asin,
    Op.ACOS: ca.acos,
    Op.ATAN: ca.atan,
    Op.ATAN2: ca.atan2,
    Op.EXP: ca.exp,
    Op.LOG: ca.log,
    Op.ABS: ca.fabs,
    Op.FLOOR: ca.floor,
    Op.MIN: ca.fmin,
    Op.MAX: ca.fmax,
    Op.SELECT: ca.if_else,
    Op.LT: lambda a, b: a < b,
    Op.LE: lambda a, b: a <= b,
    Op.EQ: lambda a, b: a == b,
    Op.NE: lambda a, b: a != b,
    Op.AND: ca.logic_and,
    Op.OR: ca.logic_or,
    Op.NOT: ca.logic_not,
}


def sources(module: ir.Module) -> dict[str, str]:
    """The C and the header of every function but the maps of the state, by path."""
    prefix = f"{module.name}_casadi"
    generator = ca.CodeGenerator(
        f"{prefix}.c", {"with_header": True, "casadi_int": "long long int"}
    )
    header = []
    for function in module.functions[2:]:
        name = f"{prefix}_{function.name}"
        generator.add(_function(function, name))
        header += [
            f"int {name}(const double **arg, double **res, long long int *iw, double *w, int mem);",
            f"int {name}_work(long long int *sz_arg, long long int *sz_res, "
            "long long int *sz_iw, long long int *sz_w);",
        ]
    return {
        f"casadi/{prefix}.c": generator.dump(),
        f"casadi/{prefix}.h": "\n".join(header) + "\n",
    }


def _function(function: ir.Function, name: str) -> ca.Function:
    arguments = {a.name: ca.SX.sym(a.name, a.size) for a in function.arguments}
    values: dict[str, ca.SX] = {}
    for step in (*function.shared, *function.item):
        values[step.target] = _value(step.value, arguments, values)
    outputs = [_dense(output, arguments, values) for output in function.outputs]
    return ca.Function(name, list(arguments.values()), outputs)


def _value(
    expression: ir.Expression, arguments: Mapping[str, ca.SX], values: Mapping[str, ca.SX]
) -> ca.SX:
    if isinstance(expression, ir.Number):
        return ca.SX(expression.value)
    if isinstance(expression, ir.Ref):
        return values[expression.name]
    if isinstance(expression, ir.Call):
        operands = [_value(operand, arguments, values) for operand in expression.operands]
        return _SYMBOLIC[expression.operation](*operands)
    vector, index = arguments[expression.argument], expression.index
    if not isinstance(index, ir.Offset):
        return vector[index]
    slot = _value(index.slot, arguments, values)
    chosen = ca.SX(0)
    for k in range(vector.numel() - index.base):
        chosen += ca.if_else(slot == k, vector[index.base + k], 0)
    return chosen


def _dense(output: ir.Output, arguments: Mapping[str, ca.SX], values: Mapping[str, ca.SX]) -> ca.SX:
    shape = (*output.shape, 1, 1)[:2]
    dense = ca.SX(*shape)
    stride = shape[0] if len(output.shape) == 2 else 1
    for entry in output.entries:
        value = _value(entry.value, arguments, values)
        row, last = (0, 0, *entry.index)[-2:]
        assert isinstance(row, int)
        if isinstance(last, ir.Offset):
            slot = _value(last.slot, arguments, values)
            for k in range(output.shape[-1] - last.base):
                dense[row + stride * (last.base + k)] = ca.if_else(slot == k, value, 0)
        else:
            dense[row + stride * last] = value
    return ca.densify(dense)
