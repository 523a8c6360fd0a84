"""Passes over the intermediate representation: pure functions from function to function."""
