"""Tests of the demonstration on recorded observations."""
