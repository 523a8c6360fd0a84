"""Tests of the Python package around the back ends."""
