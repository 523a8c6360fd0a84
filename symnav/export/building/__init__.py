"""What builds a bundle: on a desk, in a framework, for a board."""
