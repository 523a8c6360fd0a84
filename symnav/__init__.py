"""symnav: navigation equations, derived for your state vector and emitted as code that can fly."""

__version__ = "0.1.0"
