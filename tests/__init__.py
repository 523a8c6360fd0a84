"""Tests of symnav, and the independent truth it is judged by."""
