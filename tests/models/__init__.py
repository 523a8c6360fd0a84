"""Shipped models against the formulas of their sources, written out by hand."""
