"""Tests of the core: graph, quantities, frames, blocks, equations, elimination and both routes."""
