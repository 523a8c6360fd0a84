"""What a bundle is proven with, and the run of it."""
