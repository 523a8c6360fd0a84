"""Mutation tests: one wrong sign, swapped product or dropped transpose at a time."""
