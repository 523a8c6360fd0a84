"""The C of a function as arithmetic that can be followed: bits, branches, room to move."""
