"""Verification: witnesses that differentiate on their own, references from the book, proof sheet."""
