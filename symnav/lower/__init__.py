"""Lowering: a derivation to the intermediate representation, by two routes that share no algebra.

``casadi`` goes through CasADi's expression graph, its common subexpressions and its scheduling;
``sympy`` goes through SymPy's. Both hand their steps to ``signature``, which describes arguments
and outputs.
"""
