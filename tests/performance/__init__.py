"""Budgets of operations and instructions: counts, never times."""
