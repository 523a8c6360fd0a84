"""Comparisons with third-party libraries, one file per library.

Every comparison runs over the implementations of :mod:`tests.oracles.implementations`. A library
that is not installed skips its file, unless ``SYMNAV_REQUIRE_ORACLES=1`` asks for all of them.
"""
