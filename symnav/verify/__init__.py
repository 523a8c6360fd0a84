"""Verification: independent witnesses, references from the book, and the proof sheet."""
