"""Tests of the C emitter."""
