"""The test program of a bundle: golden vectors, guards, and what they are made of."""
