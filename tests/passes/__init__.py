"""Tests of the passes over the intermediate representation."""
