"""Tests of the NumPy back end on hand-written modules."""
