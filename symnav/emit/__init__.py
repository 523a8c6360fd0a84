"""Emission: an intermediate-representation module in, the text of a package's files out."""
