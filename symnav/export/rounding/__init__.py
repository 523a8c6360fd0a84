"""Rigorous bounds on rounding errors.

expressions   a lowered function as a graph of its values
intervals     enclosures of real numbers
formats       what rounding to a type does
polynomials   exact values, where they can be had
structure     facts about ranges and errors that the graph as a whole shows
model         a number with its error
propagation   from the numbers of operands to that of a result
evaluation    one pass over a graph under assumptions
cases         the inputs taken apart where the function decides something
bounds        all of it put together
"""

from symnav.export.rounding.bounds import bounded, bounds

__all__ = ["bounded", "bounds"]
